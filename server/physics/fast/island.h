// SPDX-License-Identifier: BSD-3-Clause
// Solves the linkages of one island - those that contacts hold together - for their new twists.
// Equations: fast_stepper.h, 3 and 4.
//
// Which normals push and which hinges are held is found by pivoting: solve as if the present guess
// were right, flip whatever turns out to contradict it, solve again. The problem is a linear
// complementarity problem with a positive definite matrix, of which flipping all contradictions at
// once nearly always finds the one solution in a few rounds, and flipping only the first one always
// does (Murty, Linear Complementarity, 1988, ch. 4; the mixture: Judice and Pires, Computers &
// Operations Research 21, 1994).
#pragma once

#include <span>
#include <vector>

#include "server/physics/fast/grip.h"

namespace k3d::server::physics::fast {

class IslandSolver {
  public:
    /// Leaves the new twists in the linkages and the impulses in the grips. Throws Diverged if no
    /// consistent solution was found.
    void solve(std::span<Linkage* const> linkages, std::span<Grip* const> grips);

  private:
    /// A row of the system: coefficients of the unknowns of one or two linkages.
    struct Row {
        std::size_t first;    ///< of its coefficients, in coefficients_
        std::size_t at[2];    ///< column where each block begins, ascending
        std::size_t size[2];  ///< columns of each block
        double stiffness;
        double target;  ///< less the bias
    };

    void lay_out(std::span<Linkage* const> linkages, std::span<Grip* const> grips);
    void aim(std::span<Linkage* const> linkages, std::span<Grip* const> grips);
    void add_rows(const Grip& grip);
    void add_block(const Side& side, const Vec3& direction, int block, Row& row);
    void add_stiffness(const Row& row, std::vector<double>& matrix) const;
    void add_target(const Row& row, std::vector<double>& right) const;
    double slack(const Row& row) const;  ///< target minus velocity, of the solution
    void solve_system(std::span<Grip* const> grips);
    bool flip_normals(std::span<Grip* const> grips, bool one_only);
    void hand_out(std::span<Linkage* const> linkages, std::span<Grip* const> grips);

    std::size_t size_ = 0;  ///< unknowns
    std::vector<double> coefficients_;
    std::vector<Row> rows_;                           ///< three for each grip
    std::vector<double> fixed_matrix_, fixed_right_;  ///< all but the normals; lower triangle
    std::vector<double> matrix_;                      ///< the factor of all that is in force
    bool factored_ = false;
    std::vector<double> right_;  ///< right side, then solution
};

}  // namespace k3d::server::physics::fast

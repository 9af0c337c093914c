// SPDX-License-Identifier: BSD-3-Clause
#include "server/physics/fast/island.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace k3d::server::physics::fast {

namespace {

constexpr int kBlockRounds = 12;  // flips of all contradictions at once, then one by one
constexpr int kRounds = 1000;     // far beyond what was ever needed
constexpr int kYields = 2;  // each leaves about a tenth of the error before (fast_stepper.h, 5)
constexpr double kSlack = 1e-11;  // m/s against rounding: smaller contradictions are none

/// Makes the lower triangle of A, row by row, its Cholesky factor with the diagonal's reciprocals.
/// A matrix that is not positive definite leaves numbers that are not finite.
void factor(std::vector<double>& a, std::size_t n) {
    for (std::size_t j = 0; j < n; ++j) {
        double* row = &a[j * n];
        for (std::size_t k = 0; k < j; ++k) {
            const double* above = &a[k * n];
            double sum = row[k];
            for (std::size_t m = 0; m < k; ++m) sum -= row[m] * above[m];
            row[k] = sum * above[k];
        }
        double sum = row[j];
        for (std::size_t m = 0; m < j; ++m) sum -= row[m] * row[m];
        row[j] = 1.0 / std::sqrt(sum);
    }
}

/// Turns b into the solution of A x = b, from A's factor.
void substitute(const std::vector<double>& factor, std::vector<double>& b) {
    const std::size_t n = b.size();
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t m = 0; m < j; ++m) b[j] -= factor[j * n + m] * b[m];
        b[j] *= factor[j * n + j];
    }
    for (std::size_t j = n; j-- > 0;) {
        b[j] *= factor[j * n + j];
        for (std::size_t m = 0; m < j; ++m) b[m] -= factor[j * n + m] * b[j];
    }
}

}  // namespace

void IslandSolver::solve(std::span<Linkage* const> linkages, std::span<Grip* const> grips) {
    lay_out(linkages, grips);
    int yields = 0;
    for (int round = 0; round < kRounds; ++round) {
        const bool one_only = round >= kBlockRounds;
        solve_system(grips);
        if (flip_normals(grips, one_only)) continue;
        hand_out(linkages, grips);
        bool moved = false;
        for (Linkage* linkage : linkages) {
            if (!(moved && one_only)) moved = linkage->release_hinges(one_only) || moved;
        }
        if (moved) {
            lay_out(linkages, grips);
        } else if (yields++ < kYields) {
            for (Linkage* linkage : linkages) linkage->yield_to_forces();
            aim(linkages, grips);
        } else {
            return;
        }
    }
    throw Diverged("contacts and hinges contradict one another whatever holds");
}

void IslandSolver::lay_out(std::span<Linkage* const> linkages, std::span<Grip* const> grips) {
    size_ = 0;
    for (Linkage* linkage : linkages) {
        linkage->column = size_;
        size_ += linkage->columns();
    }
    fixed_matrix_.assign(size_ * size_, 0.0);
    for (const Linkage* linkage : linkages) linkage->add_inertia(fixed_matrix_.data(), size_);
    rows_.clear();
    coefficients_.clear();
    for (const Grip* grip : grips) add_rows(*grip);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        if (r % 3 != 0) add_stiffness(rows_[r], fixed_matrix_);
    }
    factored_ = false;
    aim(linkages, grips);
}

void IslandSolver::aim(std::span<Linkage* const> linkages, std::span<Grip* const> grips) {
    fixed_right_.assign(size_, 0.0);
    for (const Linkage* linkage : linkages) linkage->add_momentum(fixed_right_.data());
    for (std::size_t g = 0; g < grips.size(); ++g) {
        const Vec3 bias = grips[g]->relative(&Linkage::bias_velocity);
        for (std::size_t k = 0; k < 3; ++k) {
            Row& row = rows_[3 * g + k];
            row.target = (k == 0 ? grips[g]->target : 0.0) - grips[g]->directions[k].dot(bias);
            if (k > 0) add_target(row, fixed_right_);
        }
    }
}

void IslandSolver::add_rows(const Grip& grip) {
    const bool two = grip.b.linkage != nullptr;
    const bool b_first = two && grip.b.linkage->column < grip.a.linkage->column;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& direction = grip.directions[k];
        Row row{};
        row.first = coefficients_.size();
        row.stiffness = grip.stiffness[k];
        if (b_first) add_block(grip.b, -direction, 0, row);
        add_block(grip.a, direction, b_first ? 1 : 0, row);
        if (two && !b_first) add_block(grip.b, -direction, 1, row);
        rows_.push_back(row);
    }
}

void IslandSolver::add_block(const Side& side, const Vec3& direction, int block, Row& row) {
    row.at[block] = side.linkage->column;
    row.size[block] = side.linkage->columns();
    const std::size_t begin = coefficients_.size();
    coefficients_.resize(begin + row.size[block]);
    side.linkage->jacobian(side.link, side.offset, direction, &coefficients_[begin]);
}

void IslandSolver::add_stiffness(const Row& row, std::vector<double>& matrix) const {
    const double* one = &coefficients_[row.first];
    const double* const two = one + row.size[0];
    for (std::size_t r = 0; r < row.size[0]; ++r) {
        const double scaled = row.stiffness * one[r];
        double* line = &matrix[(row.at[0] + r) * size_ + row.at[0]];
        for (std::size_t c = 0; c <= r; ++c) line[c] += scaled * one[c];
    }
    for (std::size_t r = 0; r < row.size[1]; ++r) {
        const double scaled = row.stiffness * two[r];
        double* line = &matrix[(row.at[1] + r) * size_];
        for (std::size_t c = 0; c < row.size[0]; ++c) line[row.at[0] + c] += scaled * one[c];
        for (std::size_t c = 0; c <= r; ++c) line[row.at[1] + c] += scaled * two[c];
    }
}

void IslandSolver::add_target(const Row& row, std::vector<double>& right) const {
    const double impulse = row.stiffness * row.target;
    const double* j = &coefficients_[row.first];
    for (std::size_t block = 0; block < 2; ++block) {
        double* lines = &right[row.at[block]];
        for (std::size_t c = 0; c < row.size[block]; ++c) lines[c] += impulse * j[c];
        j += row.size[block];
    }
}

double IslandSolver::slack(const Row& row) const {
    const double* j = &coefficients_[row.first];
    double value = row.target;
    for (std::size_t block = 0; block < 2; ++block) {
        const double* unknowns = &right_[row.at[block]];
        for (std::size_t c = 0; c < row.size[block]; ++c) value -= j[c] * unknowns[c];
        j += row.size[block];
    }
    return value;
}

void IslandSolver::solve_system(std::span<Grip* const> grips) {
    if (!factored_) {
        matrix_ = fixed_matrix_;
        for (std::size_t g = 0; g < grips.size(); ++g) {
            if (grips[g]->pushes) add_stiffness(rows_[3 * g], matrix_);
        }
        factor(matrix_, size_);
        factored_ = true;
    }
    right_ = fixed_right_;
    for (std::size_t g = 0; g < grips.size(); ++g) {
        if (grips[g]->pushes) add_target(rows_[3 * g], right_);
    }
    substitute(matrix_, right_);
    for (const double value : right_) {
        if (!std::isfinite(value)) throw Diverged("the contact system has no finite solution");
    }
}

bool IslandSolver::flip_normals(std::span<Grip* const> grips, bool one_only) {
    bool flipped = false;
    for (std::size_t g = 0; g < grips.size(); ++g) {
        const double away = slack(rows_[3 * g]);
        if (grips[g]->pushes ? away >= -kSlack : away <= kSlack) continue;
        grips[g]->pushes = !grips[g]->pushes;
        flipped = true;
        if (one_only) break;
    }
    if (flipped) factored_ = false;
    return flipped;
}

void IslandSolver::hand_out(std::span<Linkage* const> linkages, std::span<Grip* const> grips) {
    for (Linkage* linkage : linkages) linkage->take_solution(&right_[linkage->column]);
    for (std::size_t g = 0; g < grips.size(); ++g) {
        Grip& grip = *grips[g];
        grip.impulse = Vec3::Zero();
        for (std::size_t k = grip.pushes ? 0 : 1; k < 3; ++k) {
            const Row& row = rows_[3 * g + k];
            grip.impulse += row.stiffness * slack(row) * grip.directions[k];
        }
        grip.a.linkage->push(grip.a.link, grip.a.offset, grip.impulse);
        if (grip.b.linkage != nullptr) {
            grip.b.linkage->push(grip.b.link, grip.b.offset, -grip.impulse);
        }
    }
}

}  // namespace k3d::server::physics::fast

// SPDX-License-Identifier: BSD-3-Clause
#include "server/physics/fast/island.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace k3d::server::physics::fast {

namespace {

constexpr int kBlockRounds = 12;  // flips of all contradictions at once, then one by one
constexpr int kRounds = 1000;     // far beyond what was ever seen
constexpr double kSlack = 1e-11;  // m/s against rounding: smaller contradictions are none

/// Solves A x = b in place of b; A, of which the lower triangle is given row by row, becomes its
/// Cholesky factor. A matrix that is not positive definite leaves numbers that are not finite.
void solve_in_place(std::vector<double>& a, std::vector<double>& b, std::size_t n) {
    for (std::size_t j = 0; j < n; ++j) {
        double* row = &a[j * n];
        for (std::size_t k = 0; k < j; ++k) {
            const double* above = &a[k * n];
            double sum = row[k];
            for (std::size_t m = 0; m < k; ++m) sum -= row[m] * above[m];
            row[k] = sum * above[k];  // the diagonal holds reciprocals
        }
        double sum = row[j];
        for (std::size_t m = 0; m < j; ++m) sum -= row[m] * row[m];
        row[j] = 1.0 / std::sqrt(sum);
        double value = b[j];
        for (std::size_t m = 0; m < j; ++m) value -= row[m] * b[m];
        b[j] = value * row[j];
    }
    for (std::size_t j = n; j-- > 0;) {
        b[j] *= a[j * n + j];
        for (std::size_t m = 0; m < j; ++m) b[m] -= a[j * n + m] * b[j];
    }
}

}  // namespace

void IslandSolver::solve(std::span<Linkage* const> linkages, std::span<Grip* const> grips) {
    lay_out(linkages, grips);
    for (int round = 0; round < kRounds; ++round) {
        const bool one_only = round >= kBlockRounds;
        solve_system(grips);
        if (flip_normals(grips, one_only)) continue;
        hand_out(linkages, grips);
        bool moved = false;
        for (Linkage* linkage : linkages) {
            if (!(moved && one_only)) moved = linkage->release_hinges(one_only) || moved;
        }
        if (!moved) return;
        lay_out(linkages, grips);
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
    fixed_right_.assign(size_, 0.0);
    for (const Linkage* linkage : linkages) {
        linkage->add_to_system(fixed_matrix_.data(), size_, fixed_right_.data());
    }
    rows_.clear();
    coefficients_.clear();
    for (const Grip* grip : grips) add_rows(*grip);
    std::swap(matrix_, fixed_matrix_);
    std::swap(right_, fixed_right_);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        if (r % 3 != 0) add_to_system(rows_[r]);
    }
    std::swap(matrix_, fixed_matrix_);
    std::swap(right_, fixed_right_);
}

void IslandSolver::add_rows(const Grip& grip) {
    const Vec3 bias = grip.relative(&Linkage::bias_velocity);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& direction = grip.directions[k];
        Row row{};
        row.first = coefficients_.size();
        row.stiffness = grip.stiffness[k];
        row.target = (k == 0 ? grip.target : 0.0) - direction.dot(bias);
        const bool two = grip.b.linkage != nullptr;
        const bool b_first = two && grip.b.linkage->column < grip.a.linkage->column;
        if (b_first) add_block(grip.b, direction, -1.0, 0, row);
        add_block(grip.a, direction, 1.0, b_first ? 1 : 0, row);
        if (two && !b_first) add_block(grip.b, direction, -1.0, 1, row);
        rows_.push_back(row);
    }
}

void IslandSolver::add_block(const Side& side, const Vec3& direction, double sign, int block,
                             Row& row) {
    row.at[block] = side.linkage->column;
    row.size[block] = side.linkage->columns();
    const std::size_t begin = coefficients_.size();
    coefficients_.resize(begin + row.size[block]);
    side.linkage->jacobian(side.link, side.offset, sign * direction, &coefficients_[begin]);
}

void IslandSolver::add_to_system(const Row& row) {
    const double* j = &coefficients_[row.first];
    const double* const second = j + row.size[0];
    for (std::size_t r = 0; r < row.size[0]; ++r) {
        const double scaled = row.stiffness * j[r];
        double* line = &matrix_[(row.at[0] + r) * size_ + row.at[0]];
        for (std::size_t c = 0; c <= r; ++c) line[c] += scaled * j[c];
        right_[row.at[0] + r] += scaled * row.target;
    }
    for (std::size_t r = 0; r < row.size[1]; ++r) {
        const double scaled = row.stiffness * second[r];
        double* line = &matrix_[(row.at[1] + r) * size_];
        for (std::size_t c = 0; c < row.size[0]; ++c) line[row.at[0] + c] += scaled * j[c];
        for (std::size_t c = 0; c <= r; ++c) line[row.at[1] + c] += scaled * second[c];
        right_[row.at[1] + r] += scaled * row.target;
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
    matrix_ = fixed_matrix_;
    right_ = fixed_right_;
    for (std::size_t g = 0; g < grips.size(); ++g) {
        if (grips[g]->pushes) add_to_system(rows_[3 * g]);
    }
    solve_in_place(matrix_, right_, size_);
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

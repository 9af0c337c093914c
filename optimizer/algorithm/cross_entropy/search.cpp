// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/cross_entropy/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/log/log.h"
#include "optimizer/algorithm/matrix_json.h"

namespace k3d::optimizer::algorithm::cross_entropy {

Search::Search(const spec::CrossEntropySpec& spec, Coordinates space, std::uint64_t seed)
    : spec_(spec),
      space_(std::move(space)),
      seed_(seed),
      mean_(space_.start()),
      deviation_(Eigen::VectorXd::Ones(space_.dimension())) {
    if (spec_.elite * spec_.population < 2.0) {
        throw AlgorithmError(fmt::format(
            "cross_entropy: an elite of {} of a population of {} holds fewer than 2 candidates",
            spec_.elite, spec_.population));
    }
    points_ = Eigen::MatrixXd::Zero(space_.dimension(), spec_.population);
}

void Search::begin(int generation) {
    RandomStream stream(seed_, fmt::format("generation {}", generation), "cross_entropy.sample");
    const Eigen::VectorXd used = deviation_.cwiseMax(space_.least_deviation());
    for (Eigen::Index k = 0; k < points_.cols(); ++k) {
        for (Eigen::Index i = 0; i < points_.rows(); ++i) {
            points_(i, k) = mean_[i] + used[i] * stream.normal();
        }
    }
}

std::vector<double> Search::values(std::size_t candidate) const {
    return space_.values(points_.col(static_cast<Eigen::Index>(candidate)));
}

std::vector<double> Search::centre() const { return space_.values(mean_); }

void Search::update(const std::vector<Outcome>& outcomes) {
    K3D_ASSERT(outcomes.size() == size());
    const std::vector<std::size_t> order = ranking(outcomes);
    const auto good = static_cast<std::size_t>(
        std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return !o.failed; }));
    const std::size_t elite =
        std::min(good, static_cast<std::size_t>(std::floor(spec_.elite * spec_.population)));
    if (elite < 2) return;  // nothing to fit to: sample again
    Eigen::MatrixXd best(points_.rows(), static_cast<Eigen::Index>(elite));
    for (std::size_t i = 0; i < elite; ++i) {
        best.col(static_cast<Eigen::Index>(i)) = points_.col(static_cast<Eigen::Index>(order[i]));
    }
    const Eigen::VectorXd fit = best.rowwise().mean();
    const Eigen::VectorXd spread =
        ((best.colwise() - fit).cwiseAbs2().rowwise().sum() / static_cast<double>(elite)).cwiseSqrt();
    mean_ = spec_.smoothing * fit + (1.0 - spec_.smoothing) * mean_;
    deviation_ = spec_.smoothing * spread + (1.0 - spec_.smoothing) * deviation_;
    deviation_ = deviation_.cwiseMax(spec_.least_deviation).eval();
}

void Search::report(nlohmann::json& line) const {
    line["population"] = spec_.population;
    line["mean_values"] = exact(centre());
    line["deviations"] =
        exact(std::vector<double>(deviation_.data(), deviation_.data() + deviation_.size()));
}

nlohmann::json Search::save() const {
    return {{"mean", exact_matrix(mean_)},
            {"deviation", exact_matrix(deviation_)},
            {"points", exact_matrix(points_)}};
}

void Search::load(const Reader& reader) {
    mean_ = read_matrix(reader["mean"], space_.dimension(), 1);
    deviation_ = read_matrix(reader["deviation"], space_.dimension(), 1);
    if (deviation_.minCoeff() < 0.0) reader["deviation"].fail("holds a deviation below 0");
    points_ = read_matrix(reader["points"], space_.dimension(), spec_.population);
}

}  // namespace k3d::optimizer::algorithm::cross_entropy

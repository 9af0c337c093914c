// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/random_search/search.h"

#include <fmt/format.h>

#include <cmath>

#include "optimizer/algorithm/matrix_json.h"

namespace k3d::optimizer::algorithm::random_search {

Search::Search(const spec::RandomSearchSpec& spec, Coordinates space, std::uint64_t seed)
    : spec_(spec), space_(std::move(space)), seed_(seed) {
    for (const spec::Parameter& p : space_.parameters()) {
        if (spec_.distribution != "uniform" || p.frozen) continue;
        if (!std::isfinite(p.lower) || !std::isfinite(p.upper)) {
            throw AlgorithmError(fmt::format(
                "random_search.distribution is \"uniform\", but parameter \"{}\" has bounds {} to {}",
                p.name, p.lower, p.upper));
        }
    }
    points_ = Eigen::MatrixXd::Zero(space_.dimension(), spec_.population);
}

void Search::begin(int generation) {
    RandomStream stream(seed_, fmt::format("generation {}", generation), "random_search.sample");
    const Eigen::VectorXd start = space_.start();
    for (Eigen::Index k = 0; k < points_.cols(); ++k) {
        if (spec_.distribution == "uniform") {
            points_.col(k) = space_.random_start(stream);
            continue;
        }
        for (Eigen::Index i = 0; i < points_.rows(); ++i) points_(i, k) = start[i] + stream.normal();
    }
}

std::vector<double> Search::values(std::size_t candidate) const {
    return space_.values(points_.col(static_cast<Eigen::Index>(candidate)));
}

nlohmann::json Search::save() const { return {{"points", exact_matrix(points_)}}; }

void Search::load(const Reader& reader) {
    points_ = read_matrix(reader["points"], space_.dimension(), spec_.population);
}

}  // namespace k3d::optimizer::algorithm::random_search

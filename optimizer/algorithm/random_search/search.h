// SPDX-License-Identifier: BSD-3-Clause
// Random search: independent samples of one distribution that never learns. The baseline that every
// other algorithm has to beat.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimizer/algorithm/coordinates.h"
#include "optimizer/algorithm/score.h"

namespace k3d::optimizer::algorithm::random_search {

class Search {
  public:
    /// Throws AlgorithmError if the distribution is uniform and a searched parameter has no bounds.
    Search(const spec::RandomSearchSpec& spec, Coordinates space, std::uint64_t seed);

    void begin(int generation);
    std::size_t size() const { return static_cast<std::size_t>(spec_.population); }
    std::vector<double> values(std::size_t candidate) const;
    void update(const std::vector<Outcome>&) {}
    std::optional<std::string> stopped() const { return std::nullopt; }
    void report(nlohmann::json& line) const { line["population"] = spec_.population; }
    nlohmann::json save() const;
    void load(const Reader& reader);

  private:
    spec::RandomSearchSpec spec_;
    Coordinates space_;
    std::uint64_t seed_;
    Eigen::MatrixXd points_;  // of the generation under evaluation, by columns
};

}  // namespace k3d::optimizer::algorithm::random_search

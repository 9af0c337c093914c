// SPDX-License-Identifier: BSD-3-Clause
// The cross-entropy method: an axis-parallel normal distribution, refitted to each generation's elite.
// Source: P.-T. de Boer, D. Kroese, S. Mannor, R. Rubinstein, Annals of Operations Research 134, 2005,
// with their smoothed update.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimizer/algorithm/coordinates.h"
#include "optimizer/algorithm/score.h"

namespace k3d::optimizer::algorithm::cross_entropy {

class Search {
  public:
    Search(const spec::CrossEntropySpec& spec, Coordinates space, std::uint64_t seed);

    void begin(int generation);
    std::size_t size() const { return static_cast<std::size_t>(spec_.population); }
    std::vector<double> values(std::size_t candidate) const;
    std::vector<double> centre() const;
    void update(const std::vector<Outcome>& outcomes);
    std::optional<std::string> stopped() const { return std::nullopt; }
    void report(nlohmann::json& line) const;
    nlohmann::json save() const;
    void load(const Reader& reader);

  private:
    spec::CrossEntropySpec spec_;
    Coordinates space_;
    std::uint64_t seed_;
    Eigen::VectorXd mean_;
    Eigen::VectorXd deviation_;
    Eigen::MatrixXd points_;  // of the generation under evaluation, by columns
};

}  // namespace k3d::optimizer::algorithm::cross_entropy

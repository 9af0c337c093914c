// SPDX-License-Identifier: BSD-3-Clause
// Where K3 stands (GetOpen): the paper leaves it at home; here a learned function may value the target
// points as places for the pass after the next one, by the machinery that values K1's targets. Team
// frame, m.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "agent/decision/keepaway/features.h"
#include "common/network/network.h"

namespace k3d::agent::decision {

/// Sees f1..f9 with the ball where the present pass will end and K3 alone as receiver: f4 is K3's squared
/// way, f9 the squared distance to who gets the present pass.
class OpenPlace {
  public:
    /// A network of its own. Throws network::NetworkError for a file that is missing, damaged or of
    /// another shape than f1..f9 and one output.
    OpenPlace(const std::string& file, std::vector<Vec2> grid);
    /// The last output of a network over f1..f9: policy.h has networks that value K1's targets too.
    OpenPlace(network::Network net, std::vector<Vec2> grid);

    /// The place of lowest cost, the first of equals; the one chosen before stays unless another is
    /// better by kKeep of its absolute cost, so that a network's bias counts here, as it does not for K1,
    /// who compares ranks: it sets how readily K3 moves. `situation` has the receiver of the present pass in
    /// `ball`, K3 in `receivers`.
    Vec2 choose(const PassSituation& situation, double ideal_pass);

    /// No place has been chosen before: a new match.
    void forget() { before_.reset(); }

    static constexpr double kKeep = 0.1;

  private:
    double cost(const Vec2& point, const PassSituation& situation, double ideal_pass);

    network::Network net_;
    network::State state_;
    std::vector<double> outputs_;
    std::vector<Vec2> grid_;
    std::optional<Vec2> before_;
};

}  // namespace k3d::agent::decision

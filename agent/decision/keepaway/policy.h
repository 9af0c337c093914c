// SPDX-License-Identifier: BSD-3-Clause
// How K1 values target points: the hand-coded cost (paper, Algorithm 2), a network from a file, or
// one of the simple policies that serve as baselines. The lowest cost wins.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "agent/decision/config.h"
#include "agent/decision/decision.h"
#include "agent/decision/keepaway/features.h"
#include "common/network/network.h"

namespace k3d::agent::decision {

/// Algorithm 2, line by line.
double hand_coded_cost(const Features& features, const EvaluationConfig& config);

/// The target points of an area about the origin, margin inside, `cell` apart and symmetrical
/// about the centre: (-4..4)^2 for 10 m. By x, then y.
std::vector<Vec2> target_grid(double area, const EvaluationConfig& config);

struct Policy {
    enum class Kind {
        Evaluate,  ///< K1 kicks at the target of lowest cost
        Still,     ///< nobody moves: the baseline
        Hold,      ///< K1 keeps the ball as long as it can, and never kicks
        Random,    ///< K1 kicks at a random one of the possible targets, another when it is none any more
    };
    Kind kind = Kind::Evaluate;
    std::optional<network::Network> cost = {};  ///< Evaluate: hand-coded if absent
    bool values_places = false;            ///< the network's last output is the cost of K3's places
};

/// `name`: handcoded, still, hold, random, or the path of a network file: inputs f1..f8 and one
/// output, the cost of K1's targets, or inputs f1..f9 and two outputs, "cost" and "place", the cost
/// of K3's places. Throws network::NetworkError.
Policy load_policy(const std::string& name);

struct Target {
    Vec2 point = Vec2::Zero();
    double cost = 0.0;
};

/// How well a kick at a point can be done, m of room; negative: not at all (K1 would have to stand
/// outside the area, say).
using Room = std::function<double(const Vec2&)>;

/// The point of lowest cost among those with room that are at least min_pass from the ball, the
/// first of equals. `previous`, if it is on the grid and has room, stays unless more than a share
/// `keep` of the points is better: a measure that suits functions of any scale. If no point has room,
/// the one with most of it.
/// `scored`, if given, is filled with all points that have room.
Target best_target(const std::vector<Vec2>& grid, const PassSituation& situation,
                   const Policy& policy, const EvaluationConfig& config, const Room& room,
                   const std::optional<Vec2>& previous, double keep,
                   std::vector<Scored>* scored = nullptr);

}  // namespace k3d::agent::decision

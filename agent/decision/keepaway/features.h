// SPDX-License-Identifier: BSD-3-Clause
// The eight features of a target point (paper 5.3) for m keepers and n takers. Metres and degrees;
// any frame, the same for all.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "common/math/geometry.h"

namespace k3d::agent::decision {

struct TakerView {
    Vec2 position;
    Vec2 lagged;  ///< taker_hat: discounted mean of its positions
};

/// What targets are judged by.
struct PassSituation {
    Vec2 ball = Vec2::Zero();
    std::vector<TakerView> takers;
    /// Keepers who may receive: all but K1, since a ball is passed to somebody else.
    std::vector<Vec2> receivers;
};

/// f1..f8 at indices 0..7:
///   f1 smallest angle(ball, p, taker) over all takers, degrees, vertex p
///   f2 sum of 1 / distance(p, taker) over all takers
///   f3 (distance(p, ball) - ideal_pass)^2 + 1
///   f4 squared distance from p to the closest receiver
///   f5, f6 angle(taker, taker_hat, p), degrees, of the two takers nearest to p, vertex taker_hat
///   f7, f8 distance(taker, taker_hat) of the same two
/// The nearest taker is the first of the pair. With one taker f6 = 90 and f8 = 0 (it neither comes
/// nor goes); with none also f1 = 180, f2 = 0, f5 = 90, f7 = 0. Without receivers f4 = 0.
using Features = std::array<double, 8>;
inline constexpr std::array<std::string_view, 8> kFeatureNames{"f1", "f2", "f3", "f4",
                                                               "f5", "f6", "f7", "f8"};

/// f1..f8 and f9, the squared distance from p to the ball: what a network that also values K3's places
/// sees (open_place.h).
using PlaceFeatures = std::array<double, 9>;
inline constexpr std::array<std::string_view, 9> kPlaceFeatureNames{"f1", "f2", "f3", "f4", "f5",
                                                                    "f6", "f7", "f8", "f9"};

Features features_at(const Vec2& point, const PassSituation& situation, double ideal_pass);
PlaceFeatures place_features_at(const Vec2& point, const PassSituation& situation,
                                double ideal_pass);

}  // namespace k3d::agent::decision

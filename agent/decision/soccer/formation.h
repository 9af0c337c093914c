// SPDX-License-Identifier: BSD-3-Clause
// Where each number of a soccer team belongs. Team frame, m.
#pragma once

#include <algorithm>
#include <array>

#include "common/math/geometry.h"

namespace k3d::agent::decision {

/// At kick-off, by number, 1..11: in the own half and outside the centre circle.
inline Vec2 kick_off_place(int unum) {
    constexpr std::array<std::array<double, 2>, 11> kPlaces{{{-14.0, 0.0},
                                                             {-10.0, -4.5},
                                                             {-10.5, -1.5},
                                                             {-10.5, 1.5},
                                                             {-10.0, 4.5},
                                                             {-6.0, -6.0},
                                                             {-6.5, 0.0},
                                                             {-6.0, 6.0},
                                                             {-2.5, -3.5},
                                                             {-2.5, 0.0},
                                                             {-2.5, 3.5}}};
    const auto& place = kPlaces.at(static_cast<std::size_t>(std::clamp(unum, 1, 11) - 1));
    return {place[0], place[1]};
}

/// During play: the formation moves with the ball, the goalkeeper stays.
inline Vec2 place_in_play(int unum, const Vec2& ball) {
    const Vec2 home = kick_off_place(unum);
    if (unum == 1) return {home.x(), std::clamp(0.1 * ball.y(), -0.8, 0.8)};
    return {std::clamp(home.x() + 0.5 * (ball.x() + 2.0), -13.0, 12.0),
            std::clamp(home.y() + 0.25 * ball.y(), -9.0, 9.0)};
}

}  // namespace k3d::agent::decision

// SPDX-License-Identifier: BSD-3-Clause
// Moving players out of the way, and where they are put (reference 7.3, 8.5). Field frame, m.
#pragma once

#include "server/body/scene.h"

namespace k3d::server::game {

inline constexpr double kClearDistance = 2.5;  ///< that a player in the way is moved by

/// Where a player that is sent away from `from` goes: towards its own side, sideways if that would
/// leave the field.
Vec3 sent_back(const Vec3& torso, const Vec3& from, wire::Side team);

/// A rectangle on the ground.
struct Area {
    double min_x, max_x, min_y, max_y;

    bool contains(const Vec2& p) const {
        return p.x() >= min_x && p.x() <= max_x && p.y() >= min_y && p.y() <= max_y;
    }
};

/// Sends the players of `team` with any part nearer than `radius` to `centre` back from it.
void clear_circle(body::Scene& scene, const Vec3& centre, double radius, wire::Side team);
/// Sends the players of `team` with any part in `area` back behind it, those wholly within
/// `spared_radius` of the centre spot excepted.
void clear_area(body::Scene& scene, const Area& area, wire::Side team, double spared_radius = 0.0);
/// Pushes the players of `team` whose torso is nearer than `radius` out to radius + pad.
void repel(body::Scene& scene, const Vec3& centre, double radius, double pad, wire::Side team);

/// Sends every player that stands nearer to the ball than the free-kick distance away from it.
void clear_ball(body::Scene& scene);

/// Puts the ball to rest where it may be dropped: inside the field, outside the penalty areas.
void settle_ball(body::Scene& scene);

/// Outside the touch line that the ball is farther from, by number.
Vec3 beside_field(const Vec3& ball, int unum, wire::Side team);

}  // namespace k3d::server::game

// SPDX-License-Identifier: BSD-3-Clause
// The See percept: a noisy, restricted camera in the head (reference 3.6).
#pragma once

#include "common/config/fields.h"
#include "common/random/stream.h"
#include "server/body/scene.h"

namespace k3d::server::percepts {

struct VisionConfig {
    int interval = 3;           // cycles between See percepts
    bool noise = true;
    bool my_position = false;
    bool my_orientation = false;
    bool ball_position = false;

    void describe(config::Fields& f) {
        f.integer("interval", interval, {2, 3}, "cycles", "a See percept every so many cycles");
        f.boolean("noise", noise, "distance and angle noise and the calibration offset");
        f.boolean("my_position", my_position, "true pose: See carries mypos, the head's position");
        f.boolean("my_orientation", my_orientation, "true pose: See carries myorien");
        f.boolean("ball_position", ball_position, "See carries ballpos, the ball's true position");
    }
};

inline constexpr double kViewHalfAngleDeg = 60.0;
inline constexpr double kMinSeenDistance = 0.1;           // m
inline constexpr double kCalibrationRange = 0.005;        // m, uniform per axis, once per camera

/// One robot's camera: its calibration offset and its noise.
class Camera {
  public:
    Camera(const VisionConfig& config, RandomStream noise);

    /// What `self` sees of the scene; `out` is reset first.
    void see(const body::Scene& scene, const body::Player& self, wire::See& out);

  private:
    struct View;
    std::optional<wire::Pol> look_at(const View& view, const Vec3& point);
    wire::Pol noisy(const Vec3& in_head);
    void see_landmarks(const View& view, wire::See& out);
    void see_players(const View& view, const body::Scene& scene, wire::See& out);
    void see_lines(const View& view, wire::See& out);

    VisionConfig config_;
    RandomStream noise_;
    Vec3 calibration_ = Vec3::Zero();
};

/// What is seen of a line in the head frame (y forward), by the reference's way; false if nothing.
/// A line whose ends are both in view stays whole, be they outside the pyramid of a 60-degree image.
/// One that crosses two sides of the pyramid is told by these points, in the order of the sides: top,
/// bottom, left, right, which may turn it round.
bool clip_to_view(Vec3& begin, Vec3& end);

}  // namespace k3d::server::percepts

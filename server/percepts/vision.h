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
    bool ground_truth = false;  // mypos, myorien, ballpos

    void describe(config::Fields& f) {
        f.integer("interval", interval, {1, 3}, "cycles", "a See percept every so many cycles");
        f.boolean("noise", noise, "distance and angle noise and the calibration offset");
        f.boolean("ground_truth", ground_truth, "adds mypos, myorien and ballpos to See");
    }
};

inline constexpr double kViewHalfAngleDeg = 60.0;
inline constexpr double kMinSeenDistance = 0.1;           // m
inline constexpr double kDistanceNoise = 0.0965 / 100.0;  // sd relative to the distance
inline constexpr double kThetaNoiseDeg = 0.1480;          // sd, horizontal
inline constexpr double kPhiNoiseDeg = 0.1225;            // sd, vertical
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

/// Cuts the segment to the view pyramid of a head frame (y forward); false if nothing is left.
bool clip_to_view(Vec3& begin, Vec3& end);

}  // namespace k3d::server::percepts

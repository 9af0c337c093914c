// SPDX-License-Identifier: BSD-3-Clause
// A made-up robot on the real field: what its eyes report from a known pose, for tests that judge
// estimates by the truth. Written from SimSpark reference 3.6 and common/field alone, so that it
// shares no code with the server's vision.
//
// Frame: field frame; robot frame x forward, y left, z up.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "agent/motion/motion.h"
#include "common/field/field.h"
#include "common/random/stream.h"
#include "common/wire/percepts.h"

namespace k3d::agent::synthetic {

inline Pose2 turned_half(const Pose2& pose) {
    return {-pose.position, wrap_angle(pose.yaw + kPi)};
}

/// A player seen by others: upright, or on its back along its heading.
struct Other {
    std::string team;
    int unum = 0;
    Pose2 pose;
    bool fallen = false;
};

struct Scene {
    Pose2 robot;                   ///< true pose, field frame
    double head_yaw = 0.0;         ///< rad, positive left
    double head_pitch = -0.3;      ///< rad, positive up
    Quat tilt = Quat::Identity();  ///< of the torso, robot frame; tests may hide it from the agent
    std::optional<Vec2> ball;
    std::vector<Other> others;
    bool own_arms = false;
    std::string team = "Own";
    int unum = 1;

    Vec3 camera() const { return Vec3(0.0, 0.0, 0.385) + tilt * Vec3(0.0, 0.0, 0.155); }
    Quat camera_rotation() const {
        return tilt * Quat(Eigen::AngleAxisd(head_yaw, Vec3::UnitZ())) *
               Quat(Eigen::AngleAxisd(-head_pitch, Vec3::UnitY()));
    }
    /// Field frame -> camera axes.
    Vec3 to_camera(const Vec3& p) const {
        const Vec2 ground = robot.to_local(p.head<2>());
        return camera_rotation().conjugate() * (Vec3(ground.x(), ground.y(), p.z()) - camera());
    }
    Vec3 from_robot(const Vec3& p) const {
        const Vec2 ground = robot.to_global(p.head<2>());
        return {ground.x(), ground.y(), p.z()};
    }
};

class Eyes {
  public:
    Eyes(std::uint64_t seed, bool noise) : random_(seed, "test", "vision"), noise_(noise) {
        if (!noise) return;
        for (double& axis : calibration_) axis = random_.uniform(-0.005, 0.005);
    }

    wire::See look(const Scene& scene) {
        wire::See see;
        for (std::size_t k = 0; k < see.landmarks.size(); ++k) {
            const auto& mark = field::kLandmarks[k];
            see.landmarks[k] = point(scene, {mark.x, mark.y, mark.z});
        }
        if (scene.ball) {
            see.ball = point(scene, {scene.ball->x(), scene.ball->y(), field::kBallRadius});
        }
        for (const Other& other : scene.others) add_player(scene, other, see);
        if (scene.own_arms) {
            wire::SeenPlayer own;
            own.team = scene.team;
            own.unum = scene.unum;
            own.rlowerarm = point(scene, scene.from_robot({0.15, -0.1, 0.45}));
            own.llowerarm = point(scene, scene.from_robot({0.15, 0.1, 0.45}));
            see.players.push_back(own);
        }
        for (const field::Line& line : field::lines()) add_line(scene, line, see);
        return see;
    }

  private:
    static bool in_view(const Vec3& p) {
        const double theta = std::atan2(p.y(), p.x());
        const double phi = std::atan2(p.z(), std::hypot(p.x(), p.y()));
        return std::abs(theta) <= kHalfView && std::abs(phi) <= kHalfView && p.norm() > 0.1;
    }

    wire::Pol polar(const Vec3& p) {
        const auto rounded = [](double x) { return std::round(x * 100.0) / 100.0; };
        double distance = p.norm();
        double theta = degrees(std::atan2(p.y(), p.x()));
        double phi = degrees(std::atan2(p.z(), std::hypot(p.x(), p.y())));
        if (noise_) {
            distance *= 1.0 + random_.normal(0.0, 0.0965) / 100.0;
            theta += random_.normal(0.0, 0.1480);
            phi += random_.normal(0.0, 0.1225);
        }
        return {rounded(distance), rounded(theta), rounded(phi)};
    }

    std::optional<wire::Pol> point(const Scene& scene, const Vec3& p) {
        const Vec3 seen = scene.to_camera(p) + calibration_;
        if (!in_view(seen)) return std::nullopt;
        return polar(seen);
    }

    void add_player(const Scene& scene, const Other& other, wire::See& see) {
        const auto part = [&](double forward, double left, double up) {
            // Lying on the back: heights turn into distances behind the feet.
            const Vec2 local = other.fallen ? Vec2(-up, left) : Vec2(forward, left);
            const Vec2 ground = other.pose.to_global(local);
            return point(scene, {ground.x(), ground.y(), other.fallen ? 0.06 + forward : up});
        };
        wire::SeenPlayer player;
        player.team = other.team;
        player.unum = other.unum;
        player.head = part(0.0, 0.0, 0.53);
        player.rlowerarm = part(0.02, -0.12, 0.3);
        player.llowerarm = part(0.02, 0.12, 0.3);
        player.rfoot = part(0.025, -0.055, 0.01);
        player.lfoot = part(0.025, 0.055, 0.01);
        if (player.head || player.rlowerarm || player.llowerarm || player.rfoot || player.lfoot) {
            see.players.push_back(player);
        }
    }

    /// Clips to the view pyramid: x >= 0.1, |y| and |z| <= x tan 60.
    void add_line(const Scene& scene, const field::Line& line, wire::See& see) {
        const Vec3 begin = scene.to_camera({line.begin.x(), line.begin.y(), 0.0}) + calibration_;
        const Vec3 end = scene.to_camera({line.end.x(), line.end.y(), 0.0}) + calibration_;
        const double slope = std::tan(kHalfView);
        double from = 0.0;
        double to = 1.0;
        const auto keep = [&](double at_begin, double at_end) {  // part where the value is >= 0
            if (at_begin < 0.0 && at_end < 0.0) to = -1.0;
            const double zero = at_begin / (at_begin - at_end);
            if (at_begin < 0.0 && at_end >= 0.0) from = std::max(from, zero);
            if (at_begin >= 0.0 && at_end < 0.0) to = std::min(to, zero);
        };
        keep(begin.x() - 0.1, end.x() - 0.1);
        keep(slope * begin.x() - begin.y(), slope * end.x() - end.y());
        keep(slope * begin.x() + begin.y(), slope * end.x() + end.y());
        keep(slope * begin.x() - begin.z(), slope * end.x() - end.z());
        keep(slope * begin.x() + begin.z(), slope * end.x() + end.z());
        if (from >= to) return;
        see.lines.push_back(
            {polar(begin + from * (end - begin)), polar(begin + to * (end - begin))});
    }

    static constexpr double kHalfView = radians(60.0);
    RandomStream random_;
    bool noise_;
    Vec3 calibration_ = Vec3::Zero();
};

/// What motion would tell of the scene's body; `known_tilt` is what it believes of the tilt.
inline motion::State body_of(const Scene& scene, const Quat& known_tilt) {
    Scene believed = scene;
    believed.tilt = known_tilt;
    motion::State state;
    state.torso = known_tilt;
    state.torso_height = 0.385;
    state.camera = believed.camera();
    state.camera_rotation = believed.camera_rotation();
    return state;
}

/// A robot that walks about the middle of the field, looking left and right.
class Walker {
  public:
    Walker(const Pose2& start, double speed, std::uint64_t seed)
        : speed_(speed), random_(seed, "test", "walker") {
        scene.robot = start;
    }

    /// One cycle. Returns the odometry that motion would report: 10 % short, and shaky.
    Pose2 step() {
        time_ += 0.02;
        const Vec2& at = scene.robot.position;
        // Turn back to the middle when far out, else wander.
        const double home = wrap_angle(yaw_of(-at) - scene.robot.yaw);
        const double turn =
            at.norm() > 5.0 ? std::clamp(2.0 * home, -1.0, 1.0) : 0.6 * std::sin(0.7 * time_);
        Pose2 step;
        step.position = {speed_ * 0.02, 0.1 * speed_ * 0.02 * std::sin(2.0 * time_)};
        step.yaw = turn * 0.02 * (speed_ > 0.0 ? 1.0 : 0.0);
        scene.robot = scene.robot.then(step);
        scene.head_yaw = radians(60.0) * std::sin(1.5 * time_);
        // Sway of a walk, of which the body knows but a part.
        const double sway = speed_ > 0.0 ? 1.0 : 0.0;
        const double roll = sway * radians(2.0) * std::sin(2.0 * kPi * 2.5 * time_);
        const double pitch = sway * radians(3.0) + sway * radians(1.0) * std::cos(15.0 * time_);
        scene.tilt = Quat(Eigen::AngleAxisd(pitch, Vec3::UnitY())) *
                     Quat(Eigen::AngleAxisd(roll, Vec3::UnitX()));
        known_tilt = Quat(Eigen::AngleAxisd(pitch - sway * radians(1.0), Vec3::UnitY()));
        Pose2 odometry = step;
        odometry.position = 0.9 * step.position +
                            sway * Vec2(random_.normal(0.0, 0.001), random_.normal(0.0, 0.001));
        odometry.yaw = 0.9 * step.yaw + sway * random_.normal(0.0, 0.002);
        return odometry;
    }

    Scene scene;
    Quat known_tilt = Quat::Identity();

  private:
    double speed_;
    double time_ = 0.0;
    RandomStream random_;
};

inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 1e9 : values[values.size() / 2];
}

}  // namespace k3d::agent::synthetic

// SPDX-License-Identifier: BSD-3-Clause
// The truth of a drill, read from the monitor stream (SimSpark reference 8): time, play mode, ball,
// and the robot with number 1 of the left team. Reads full and difference frames of our server and
// of the reference server. Field frame, metres, radians, seconds.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "common/math/geometry.h"
#include "common/sexpr/reader.h"

namespace k3d::optimizer::drill {

/// A frame that is none; the text says why.
class SceneError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct RobotTruth {
    Vec3 torso = Vec3::Zero();
    Pose2 pose;       ///< of the torso, on the ground
    double up = 1.0;  ///< z of the torso's upward axis: 1 upright, 0 lying
};

struct Truth {
    double time = 0.0;      ///< game time: it stands still before kick-off
    std::string play_mode;  ///< as agents hear it
    Vec3 ball = Vec3::Zero();
    std::optional<RobotTruth> robot;  ///< none while there is none
};

class Scene {
  public:
    /// Throws SceneError. A difference before the first full frame changes nothing.
    const Truth& read(std::string_view frame);
    const Truth& truth() const { return truth_; }

  private:
    /// Column by column: three axes and the position, each with a fourth number.
    using Matrix = std::array<double, 16>;
    struct Item {
        int parent = -1;
        bool transform = false;
        Matrix matrix{};
    };

    void read_state(const sexpr::Node& state);
    void add(const sexpr::Node& node, int parent);
    void change(const sexpr::Node& node, std::size_t& next);
    void note_mesh(const sexpr::Node& node, int parent);
    Eigen::Matrix4d world(int item) const;
    void look();

    sexpr::Document document_;
    std::vector<Item> items_;  ///< in the order of the frame
    int ball_ = -1;            ///< items that carry the meshes of ball and torso
    int torso_ = -1;
    std::vector<std::string> modes_;
    Truth truth_;
};

}  // namespace k3d::optimizer::drill

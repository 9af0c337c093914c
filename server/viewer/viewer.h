// SPDX-License-Identifier: BSD-3-Clause
// The page: what it is told about the scene, and the HTTP + WebSocket server that tells it.
//
// Frame: field frame, metres; rotations as unit quaternions (w, x, y, z).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/math/geometry.h"
#include "common/net/net.h"
#include "common/wire/percepts.h"

namespace k3d::server::viewer {

struct PartPose {
    Vec3 position = Vec3::Zero();
    Quat rotation = Quat::Identity();
};

struct RobotView {
    wire::Side team = wire::Side::None;
    int unum = 0;
    int type = 0;
    std::vector<PartPose> parts;  ///< in the order of nao::model(type).bodies
};

/// One moment of the simulation, as the page draws it.
struct SceneView {
    double time = 0.0;       ///< simulation time, s
    double game_time = 0.0;  ///< s
    std::string play_mode;
    std::string team_left, team_right;
    int score_left = 0, score_right = 0;
    int episode = 1;
    PartPose ball;
    std::vector<RobotView> robots;
    std::optional<Vec2> area;  ///< full extents of the keepaway area about the centre, if any
};

/// The folder that the build puts the page into: ../web as seen from this program's own folder.
std::string web_folder_beside_program();

/// Serves the page at http://ADDRESS:PORT/ and streams scenes to every open WebSocket.
class Viewer {
  public:
    /// `web_folder` holds index.html and its modules. Throws net::NetError if it cannot listen,
    /// std::runtime_error naming the folder if index.html is not in it.
    /// `beliefs_folder`: agents' telemetry to be drawn over the scenes; empty: none.
    Viewer(net::Loop& loop, const std::string& address, std::uint16_t port,
           const std::string& web_folder, const std::string& beliefs_folder = {});
    ~Viewer();

    std::uint16_t port() const;
    /// True while a page is open: nobody watching costs nothing. To be asked in every cycle, for
    /// pages that were closed take up connections until then.
    bool watched();
    /// Sends the scene to every page that has taken the one before; slow pages skip scenes.
    void publish(const SceneView& scene);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace k3d::server::viewer

// SPDX-License-Identifier: BSD-3-Clause
// A scene with one robot of each side, parts in a row, for tests of what the page is told.
#pragma once

#include "common/nao/model.h"
#include "server/viewer/viewer.h"

namespace k3d::server::viewer {

inline RobotView sample_robot(wire::Side team, int unum, int type) {
    RobotView robot{team, unum, type, {}};
    for (std::size_t i = 0; i < nao::model(type).bodies.size(); ++i) {
        robot.parts.push_back({Vec3(0.1 * static_cast<double>(i), -unum, 0.385), Quat::Identity()});
    }
    return robot;
}

inline SceneView sample_scene() {
    SceneView scene;
    scene.time = 12.34;
    scene.game_time = 9.34;
    scene.play_mode = "PlayOn";
    scene.team_left = "keepers";
    scene.team_right = "takers";
    scene.score_right = 2;
    scene.episode = 7;
    scene.ball = {Vec3(-1.23456, 2.0, 0.042), Quat(0.5, -0.5, 0.5, -0.5)};
    scene.robots = {sample_robot(wire::Side::Left, 1, 0), sample_robot(wire::Side::Right, 11, 4)};
    scene.area = Vec2(10, 8);
    return scene;
}

}  // namespace k3d::server::viewer

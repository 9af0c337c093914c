// SPDX-License-Identifier: BSD-3-Clause
// What goes over the page's WebSocket: JSON texts of two kinds.
//
// "scene": what stays while the same robots play; first to every page, and again when it changes.
//   {"kind":"scene","version":2,
//    "field":{"length":30,"width":20,"lines":[[x0,y0,x1,y1],...],
//             "solids":[{"name":"goal-left-back","centre":[x,y,z],"size":[x,y,z]},...],
//             "landmarks":[{"name":"F1L","position":[x,y,z]},...]},
//    "ball_radius":0.042, "teams":["left name","right name"],
//    "types":{"0":[{"name":"body","shape":"box","size":[x,y,z],"collides":true},...]},
//    "robots":[{"team":"left"|"right"|"none","number":2,"type":0},...],
//    "now":MOMENT}
//   Parts stand in the order of nao::model(type).bodies, shapes and sizes as there.
//
// "moment": the rest, up to 100 times a second of wall time.
//   {"kind":"moment","time":12.34,"game_time":9.34,"play_mode":"PlayOn","score":[0,0],"episode":1,
//    "area":[width_x,width_y] or null,   keepaway's, which may shrink from one moment to the next
//    "ball":POSE,"robots":[[POSE of part 0, POSE of part 1, ...],...]}   robots as in the scene
//   A POSE is seven whole numbers in the flat list: position x,y,z in 0.1 mm, then the unit
//   quaternion w,x,y,z in 0.0001. A number that is not finite, or beyond 1e9, is null: the page
//   then leaves that part where it was.
#pragma once

#include <string>
#include <vector>

#include "server/viewer/viewer.h"

namespace k3d::server::viewer {

inline constexpr int kStreamVersion = 2;  ///< the page asks to be reloaded if it knows another

/// What a "scene" text depends on; a change means that it must be told again.
struct SceneKey {
    struct Robot {
        wire::Side team = wire::Side::None;
        int unum = 0;
        int type = 0;
        bool operator==(const Robot&) const = default;
    };
    std::vector<Robot> robots;
    std::string team_left, team_right;
    bool operator==(const SceneKey&) const = default;
};
SceneKey key_of(const SceneView& scene);

std::string scene_json(const SceneView& scene);
std::string moment_json(const SceneView& scene);

}  // namespace k3d::server::viewer

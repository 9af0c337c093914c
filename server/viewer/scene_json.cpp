// SPDX-License-Identifier: BSD-3-Clause
// Scenes as the page's JSON.
#include "server/viewer/scene_json.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/field/field.h"
#include "common/log/log.h"
#include "common/nao/model.h"
#include "server/body/scene.h"

namespace k3d::server::viewer {

using nlohmann::json;

namespace {

constexpr double kPositionScale = 1e4;  // 0.1 mm
constexpr double kRotationScale = 1e4;
constexpr double kLargest = 1e9;

json list(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// Names come from the wire: bytes that are no UTF-8 must not make the text unreadable.
std::string dumped(const json& value) {
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

const char* name_of(nao::Shape shape) {
    switch (shape) {
        case nao::Shape::Box:
            return "box";
        case nao::Shape::Sphere:
            return "sphere";
        case nao::Shape::Capsule:
            break;
    }
    return "capsule";
}

json field_json() {
    json lines = json::array();
    for (const field::Line& line : field::lines()) {
        lines.push_back({line.begin.x(), line.begin.y(), line.end.x(), line.end.y()});
    }
    json solids = json::array();
    for (const field::SolidBox& solid : field::solids()) {
        solids.push_back(
            {{"name", solid.name}, {"centre", list(solid.centre)}, {"size", list(solid.size)}});
    }
    json landmarks = json::array();
    for (const field::LandmarkDef& mark : field::kLandmarks) {
        landmarks.push_back(
            {{"name", mark.name}, {"position", list(Vec3(mark.x, mark.y, mark.z))}});
    }
    return {{"length", field::kLength},
            {"width", field::kWidth},
            {"lines", lines},
            {"solids", solids},
            {"landmarks", landmarks}};
}

json area_json(const std::optional<Vec2>& area) {
    return area ? json{area->x(), area->y()} : json(nullptr);
}

json parts_json(int type) {
    json parts = json::array();
    for (const nao::BodyDef& body : nao::model(type).bodies) {
        parts.push_back({{"name", body.name},
                         {"shape", name_of(body.shape)},
                         {"size", list(body.size)},
                         {"collides", body.collides}});
    }
    return parts;
}

void append_number(std::string& out, double value) {
    if (!(std::abs(value) <= kLargest)) {  // so written that NaN goes here too
        out += "null";
        return;
    }
    char text[24];
    const auto end = std::to_chars(text, text + sizeof text, std::llround(value)).ptr;
    out.append(text, end);
}

void append_pose(std::string& out, const PartPose& pose) {
    for (int i = 0; i < 3; ++i) {
        append_number(out, pose.position[i] * kPositionScale);
        out += ',';
    }
    const Quat& q = pose.rotation;
    for (const double component : {q.w(), q.x(), q.y()}) {
        append_number(out, component * kRotationScale);
        out += ',';
    }
    append_number(out, q.z() * kRotationScale);
}

}  // namespace

SceneKey key_of(const SceneView& scene) {
    SceneKey key;
    for (const RobotView& robot : scene.robots) {
        key.robots.push_back({robot.team, robot.unum, robot.type});
    }
    key.team_left = scene.team_left;
    key.team_right = scene.team_right;
    return key;
}

std::string scene_json(const SceneView& scene) {
    json types = json::object();
    json robots = json::array();
    for (const RobotView& robot : scene.robots) {
        K3D_ASSERT(nao::is_type(robot.type));
        types[std::to_string(robot.type)] = parts_json(robot.type);
        robots.push_back(
            {{"team", wire::side_name(robot.team)}, {"number", robot.unum}, {"type", robot.type}});
    }
    const json description{{"kind", "scene"},
                           {"version", kStreamVersion},
                           {"field", field_json()},
                           {"ball_radius", field::kBallRadius},
                           {"teams", {scene.team_left, scene.team_right}},
                           {"types", types},
                           {"robots", robots}};
    std::string text = dumped(description);
    text.pop_back();  // the closing brace
    return text + ",\"now\":" + moment_json(scene) + "}";
}

// By hand: 800 numbers fifty times a second are not worth a tree of JSON values.
std::string moment_json(const SceneView& scene) {
    std::string out = dumped({{"kind", "moment"},
                              {"time", scene.time},
                              {"game_time", scene.game_time},
                              {"play_mode", scene.play_mode},
                              {"score", {scene.score_left, scene.score_right}},
                              {"episode", scene.episode},
                              {"area", area_json(scene.area)}});
    out.pop_back();
    out += ",\"ball\":[";
    append_pose(out, scene.ball);
    out += "],\"robots\":[";
    for (const RobotView& robot : scene.robots) {
        K3D_ASSERT(robot.parts.size() == nao::model(robot.type).bodies.size());
        if (out.back() == ']') out += ',';
        out += '[';
        for (const PartPose& part : robot.parts) {
            if (out.back() != '[') out += ',';
            append_pose(out, part);
        }
        out += ']';
    }
    return out + "]}";
}

}  // namespace k3d::server::viewer

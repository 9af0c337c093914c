// SPDX-License-Identifier: BSD-3-Clause
// Tests for server/viewer/scene_json.cpp: the texts say what the tables say.
#include "server/viewer/scene_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "server/viewer/sample_scene.h"

namespace k3d::server::viewer {
namespace {

using nlohmann::json;

TEST(SceneJsonTest, DescribesTheField) {
    const json text = json::parse(scene_json(sample_scene()));
    EXPECT_EQ(text["kind"], "scene");
    EXPECT_EQ(text["version"], kStreamVersion);
    EXPECT_EQ(text["field"]["length"], 30.0);
    EXPECT_EQ(text["field"]["width"], 20.0);
    EXPECT_EQ(text["field"]["lines"].size(), 21u);
    EXPECT_EQ(text["field"]["lines"][0], json({0.0, -10.0, 0.0, 10.0}));  // the middle line
    EXPECT_EQ(text["field"]["solids"].size(), 12u);
    EXPECT_EQ(text["field"]["landmarks"].size(), 8u);
    EXPECT_EQ(text["field"]["landmarks"][4],
              json({{"name", "F1L"}, {"position", {-15.0, 10.0, 0.0}}}));
    EXPECT_EQ(text["ball_radius"], 0.042);
    EXPECT_EQ(text["teams"], json({"keepers", "takers"}));
}

TEST(SceneJsonTest, DescribesRobotsByTheirTypes) {
    const json text = json::parse(scene_json(sample_scene()));
    EXPECT_EQ(text["robots"], json::parse(R"([{"team":"left","number":1,"type":0},
                                              {"team":"right","number":11,"type":4}])"));
    ASSERT_EQ(text["types"].size(), 2u);  // only those on the field
    EXPECT_EQ(text["types"]["0"].size(), 23u);
    EXPECT_EQ(text["types"]["4"].size(), 25u);
    EXPECT_EQ(text["types"]["0"][0], json::parse(R"({"name":"body","shape":"box",
                                         "size":[0.1,0.1,0.18],"collides":true})"));
    EXPECT_EQ(text["types"]["0"][1]["shape"], "capsule");
    EXPECT_EQ(text["types"]["0"][2]["shape"], "sphere");
    EXPECT_EQ(text["types"]["0"][3]["collides"], false);  // the mass of a shoulder
}

TEST(SceneJsonTest, AMomentIsWholeNumbers) {
    const json text = json::parse(moment_json(sample_scene()));
    EXPECT_EQ(text["kind"], "moment");
    EXPECT_EQ(text["time"], 12.34);
    EXPECT_EQ(text["game_time"], 9.34);
    EXPECT_EQ(text["play_mode"], "PlayOn");
    EXPECT_EQ(text["score"], json({0, 2}));
    EXPECT_EQ(text["episode"], 7);
    EXPECT_EQ(text["area"], json({10.0, 8.0}));
    EXPECT_EQ(text["ball"], json({-12346, 20000, 420, 5000, -5000, 5000, -5000}));
    ASSERT_EQ(text["robots"].size(), 2u);
    ASSERT_EQ(text["robots"][0].size(), 23u * 7);
    ASSERT_EQ(text["robots"][1].size(), 25u * 7);
    const json& robot = text["robots"][1];
    EXPECT_EQ(json(robot.begin() + 14, robot.begin() + 21),
              json({2000, -110000, 3850, 10000, 0, 0, 0}));
    EXPECT_EQ(json::parse(scene_json(sample_scene()))["now"], text);
}

TEST(SceneJsonTest, AnEmptyFieldIsAScene) {
    SceneView scene;
    const json text = json::parse(scene_json(scene));
    EXPECT_TRUE(text["now"]["area"].is_null());
    EXPECT_TRUE(text["robots"].empty());
    EXPECT_TRUE(text["now"]["robots"].empty());
}

TEST(SceneJsonTest, WhatIsNoNumberIsNull) {
    SceneView scene = sample_scene();
    scene.ball.position.x() = std::numeric_limits<double>::quiet_NaN();
    scene.ball.position.y() = -std::numeric_limits<double>::infinity();
    scene.ball.position.z() = 1e300;
    const json text = json::parse(moment_json(scene));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(text["ball"][i].is_null());
    EXPECT_EQ(text["ball"][3], 5000);
}

TEST(SceneJsonTest, NamesFromTheWireCannotBreakIt) {
    SceneView scene = sample_scene();
    scene.team_left = "\"},{<script>\\\n\xff\xc3";
    scene.play_mode = "\x01\"";
    const json text = json::parse(scene_json(scene));
    EXPECT_EQ(text["teams"][0], "\"},{<script>\\\n\xEF\xBF\xBD\xEF\xBF\xBD");
    EXPECT_EQ(text["now"]["play_mode"], "\x01\"");
}

TEST(SceneKeyTest, ChangesWithTheRobotsNotWithTheirPoses) {
    const SceneView before = sample_scene();
    SceneView moved = before;
    moved.robots[0].parts[0].position.x() += 1;
    moved.time += 1;
    moved.play_mode = "GameOver";
    moved.episode = 8;
    moved.area = Vec2(9.9, 8.0);  // it shrinks every cycle in the league's game
    EXPECT_EQ(key_of(before), key_of(moved));
    SceneView joined = before;
    joined.robots.push_back(sample_robot(wire::Side::Left, 2, 0));
    EXPECT_NE(key_of(before), key_of(joined));
    SceneView named = before;
    named.team_right = "others";
    EXPECT_NE(key_of(before), key_of(named));
}

}  // namespace
}  // namespace k3d::server::viewer

// SPDX-License-Identifier: BSD-3-Clause
// Frames against lines composed after what the reference server sends: names, order, numbers, shape.
#include "server/monitor/frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/sexpr/reader.h"

namespace k3d::server::monitor {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr std::string_view kConstants =
    "((FieldLength 30)(FieldWidth 20)(FieldHeight 40)(GoalWidth 2.1)(GoalDepth 0.6)(GoalHeight "
    "0.8)(BorderSize 0)(FreeKickDistance 2)(WaitBeforeKickOff 30)(AgentRadius 0.4)(BallRadius "
    "0.042)(BallMass 0.026)(RuleGoalPauseTime 3)(RuleKickInPauseTime 1)(RuleHalfTime "
    "300)(PassModeMinOppBallDist 1)(PassModeDuration 4)(play_modes BeforeKickOff KickOff_Left "
    "KickOff_Right PlayOn KickIn_Left KickIn_Right corner_kick_left corner_kick_right "
    "goal_kick_left goal_kick_right offside_left offside_right GameOver Goal_Left Goal_Right "
    "free_kick_left free_kick_right direct_free_kick_left direct_free_kick_right pass_left "
    "pass_right)";

/// Kinds and nesting of a frame's nodes: "T(M)" for a transform with a mesh; L light, S SMN,
/// - a node without kind.
std::string shape(const sexpr::Node& node) {
    const auto kind = node.at(1);
    const std::string_view name = kind ? kind->atom() : std::string_view{};
    std::string text = name == "TRF"          ? "T"
                       : name == "Light"      ? "L"
                       : name == "StaticMesh" ? "M"
                       : name == "SMN"        ? "S"
                                              : "-";
    std::string inner;
    for (auto child = node.first(); child; child = child->next()) {
        if (child->tag() == "nd") inner += shape(*child);
    }
    if (!inner.empty()) text += "(" + inner + ")";
    return text;
}

/// The shape of the whole scene in a frame's text.
std::string scene_shape(const std::string& frame) {
    sexpr::Document document;
    EXPECT_EQ(document.parse(frame), sexpr::Error::None);
    const auto state = document.first();
    const auto header = state->next();
    const auto scene = header->next();
    EXPECT_FALSE(scene->next()) << "three expressions a frame";
    std::string text;
    for (auto node = scene->first(); node; node = node->next()) text += shape(*node);
    return text;
}

std::string repeated(int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

/// Lights, field, sky, goals, walls, flags, lines and ball, as the reference server orders them.
const std::string kArena = "T(L)T(L)T(M)T(M)" + repeated(2, "T(T(M)TTTTTT)") +
                           repeated(4, "T(S)") + repeated(4 + 21, "T") + "T(M)";
/// Torso with marker, neck, head; two arms; two legs.
const std::string kRobot = "T(T(T(M)T(S))T(S)T(T(M))" + repeated(2, "T(S)T(M)T(S)T(M)") +
                           repeated(2, "T(S)T(S)T(M)T(M)T(S)T(M)") + ")";
const std::string kRobotWithToes = "T(T(T(M)T(S))T(S)T(T(M))" + repeated(2, "T(S)T(M)T(S)T(M)") +
                                   repeated(2, "T(S)T(S)T(M)T(M)T(S)T(M)T(M)") + ")";

body::Player& add(body::Scene& scene, int type, wire::Side team, int unum, const Vec3& at) {
    body::Player& player = scene.add_player(type, at);
    player.team = team;
    player.unum = unum;
    return player;
}

TEST(Frames, FullFrameOfAnEmptyField) {
    body::Scene scene;
    SceneGraph graph;
    graph.update(scene);
    const std::string frame = Frames().full(graph, {});
    EXPECT_THAT(frame, StartsWith(std::string(kConstants) +
                                  "(time 0)(half 1)(score_left 0)(score_right 0)(play_mode "
                                  "0))(RSG 0 1)((nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 -10 10 10 1)"
                                  "(nd Light (setDiffuse 1 1 1 1) (setAmbient 0.8 0.8 0.8 1) "
                                  "(setSpecular 0.1 0.1 0.1 1)))"));
    EXPECT_THAT(frame, EndsWith("(nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0.042 1)(nd StaticMesh "
                                "(setVisible 1) (load models/soccerball.obj) (sSc 0.042 0.042 "
                                "0.042)(resetMaterials soccerball_rcs-soccerball.png))))"));
    EXPECT_EQ(scene_shape(frame), kArena);
}

TEST(Frames, GoalsAndWallsStandWhereTheReferenceHasThem) {
    body::Scene scene;
    SceneGraph graph;
    graph.update(scene);
    const std::string frame = Frames().full(graph, {});
    EXPECT_THAT(frame, HasSubstr("(nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 -15.3 0 0.4 1)(nd TRF (SLT "
                                 "0 1 0 0 0 0 1 0 1 0 0 0 0.3 0 -0.4 1)(nd StaticMesh (setVisible "
                                 "1) (setTransparent) (load models/leftsoccergoal.obj) (sSc 2.18 "
                                 "0.88 0.68)(resetMaterials naogoalnet yellow)))(nd TRF (SLT 1 0 0 "
                                 "0 0 1 0 0 0 0 1 0 0 -1.07 0 1))"));
    EXPECT_THAT(frame, HasSubstr("(load models/rightsoccergoal.obj) (sSc 2.18 0.88 "
                                 "0.68)(resetMaterials naogoalnet sky-blue)"));
    EXPECT_THAT(frame, HasSubstr("0 0 25 0 1)(nd SMN (setVisible 1) (load StdUnitBox) (sSc 50.98 1 "
                                 "1) (sMat matGrey))"));
}

TEST(Frames, RobotsAreOneNodeEachWithTheirMaterials) {
    body::Scene scene;
    add(scene, 0, wire::Side::Left, 1, {0, -1, 0.4});
    add(scene, 4, wire::Side::Right, 11, {3, 2, 0.4});
    add(scene, 2, wire::Side::None, 0, {5, 5, 0.5});
    SceneGraph graph;
    graph.update(scene);
    const std::string frame = Frames().full(graph, {});
    EXPECT_EQ(scene_shape(frame), kArena + kRobot + kRobotWithToes + kRobot);
    EXPECT_THAT(frame,
                HasSubstr("(nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 0 -1 0.4 1)(nd TRF (SLT -1 0 0 0 0 "
                          "0 1 0 0 1 0 0 0 0 0 1)(nd StaticMesh (setVisible 1) (load "
                          "models/naobody0.obj) (sSc 0.1 0.1 0.1)(resetMaterials matNum1 matLeft "
                          "matType0 naowhite)))(nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1)(nd "
                          "SMN (setVisible 0) (setTransparent) (load StdUnitCylinder 1 1) (sSc 0.2 "
                          "0.2 0.02) (sMat matSelect))))"));
    EXPECT_THAT(frame, HasSubstr("(load StdCapsule 0.015 0.08) (sSc 1 1 1) (sMat matDarkGrey)"));
    for (const char* mesh :
         {"naobody4.obj) (sSc 0.1 0.1 0.1)(resetMaterials matNum11 matRight naowhite)",
          "naohead.obj) (sSc 0.1 0.1 0.1)(resetMaterials matRight naoblack naogrey naowhite)",
          "rupperarm0.obj) (sSc 0.07 0.07 0.07)(resetMaterials matLeft matType0 naowhite)",
          "lupperarm4.obj) (sSc 0.07 0.07 0.07)(resetMaterials matRight naowhite)",
          "llowerarm.obj) (sSc 0.05 0.05 0.05)(resetMaterials matRight naowhite)",
          "rthigh.obj) (sSc 0.07 0.07 0.07)(resetMaterials matNum11 matRight naowhite)",
          "lthigh.obj) (sSc 0.07 0.07 0.07)(resetMaterials matRight naowhite)",
          "lshank0.obj) (sSc 0.08 0.08 0.08)(resetMaterials matLeft matType0 naowhite)",
          "lfoot.obj) (sSc 0.08 0.08 0.08)(resetMaterials matLeft naowhite)",
          "lfoot.obj) (sSc 0.08 0.062241 0.08)(resetMaterials matRight naowhite)",
          "rfoot.obj) (sSc 0.08 0.0228259 0.04)(resetMaterials matRight naowhite)",
          "naobody2.obj) (sSc 0.1 0.1 0.1)(resetMaterials matNum matTeam matType2 naowhite)"}) {
        EXPECT_THAT(frame, HasSubstr(std::string("(load models/") + mesh));
    }
}

TEST(Frames, DifferenceTellsWhatMovedByMoreThanFiveMillimetres) {
    body::Scene scene;
    add(scene, 0, wire::Side::Left, 1, {0, -1, 0.4});
    SceneGraph graph;
    graph.update(scene);
    Frames frames;
    EXPECT_TRUE(frames.restart(graph, {})) << "nothing was told before";
    const std::string still = frames.difference(graph, {});
    EXPECT_THAT(still, StartsWith("((time 0))(RDS 0 1)((nd(nd))(nd(nd))(nd(nd StaticMesh))"));
    EXPECT_THAT(still, Not(HasSubstr("SLT")));

    scene.ball.move({0.004, 0, 0.042});
    graph.update(scene);
    EXPECT_EQ(frames.difference(graph, {}), still) << "4 mm are not worth telling";
    scene.ball.move({0.006, 0, 0.042});
    graph.update(scene);
    const std::string moved = frames.difference(graph, {});
    EXPECT_THAT(moved, HasSubstr("(nd (SLT 1 0 0 0 0 1 0 0 0 0 1 0 0.006 0 0.042 1)(nd StaticMesh))"));
    scene.ball.move({0.010, 0, 0.042});
    graph.update(scene);
    EXPECT_EQ(frames.difference(graph, {}), still) << "4 mm from what was told last";

    // Same nodes at the same places: readers match them by position.
    std::string untyped = scene_shape(frames.full(graph, {}));
    std::ranges::replace(untyped, 'T', '-');
    std::ranges::replace(untyped, 'L', '-');
    EXPECT_EQ(scene_shape(moved), untyped);
}

TEST(Frames, DifferenceTellsToggledMarkersOnce) {
    body::Scene scene;
    body::Player& player = add(scene, 0, wire::Side::Left, 1, {0, -1, 0.4});
    SceneGraph graph;
    graph.update(scene);
    Frames frames;
    frames.restart(graph, {});
    player.selected = true;
    graph.update(scene);
    EXPECT_THAT(frames.difference(graph, {}), HasSubstr("(nd(nd SMN (setVisible 1)))"));
    EXPECT_THAT(frames.difference(graph, {}), Not(HasSubstr("setVisible")));
    player.selected = false;
    graph.update(scene);
    EXPECT_THAT(frames.difference(graph, {}), HasSubstr("(nd(nd SMN (setVisible 0)))"));
}

TEST(Frames, GameStateIsToldOnChange) {
    body::Scene scene;
    SceneGraph graph;
    graph.update(scene);
    Frames frames;
    GameView view;
    view.half_time = 60.0;
    EXPECT_TRUE(frames.restart(graph, view));
    EXPECT_THAT(frames.full(graph, view), HasSubstr("(RuleHalfTime 60)"));
    view.time = 1.24;
    view.team_left = "Reds";
    EXPECT_THAT(frames.difference(graph, view),
                StartsWith("((time 1.24)(team_left Reds))(RDS 0 1)("));
    view.team_right = "Blues";
    view.half = 2;
    view.score_right = 3;
    view.mode = game::PlayMode::GoalRight;
    EXPECT_THAT(frames.full(graph, view),
                HasSubstr("(time 1.24)(team_left Reds)(team_right Blues)(half 2)(score_left "
                          "0)(score_right 3)(play_mode 14))(RSG 0 1)("))
        << "a full frame for a newcomer is no difference told to the others";
    EXPECT_THAT(frames.difference(graph, view),
                StartsWith("((time 1.24)(team_right Blues)(half 2)(score_right 3)(play_mode "
                           "14))(RDS 0 1)("));
    EXPECT_THAT(frames.difference(graph, view), StartsWith("((time 1.24))(RDS 0 1)("));
}

TEST(Frames, WaitsAfterPassModeAreToldInEachFrameAsRecorded) {
    body::Scene scene;
    SceneGraph graph;
    graph.update(scene);
    Frames frames;
    GameView view;
    frames.restart(graph, view);
    view.time = 1.02;
    view.mode = game::PlayMode::PlayOn;
    view.pass_wait_left = 9.88;
    EXPECT_THAT(frames.difference(graph, view),
                StartsWith("((time 1.02)(play_mode 3)(pass_mode_score_wait_left 9.88))(RDS 0 1)("));
    EXPECT_THAT(frames.difference(graph, view),
                StartsWith("((time 1.02)(pass_mode_score_wait_left 9.88))(RDS 0 1)("));
    EXPECT_THAT(frames.full(graph, view),
                HasSubstr("(play_mode 3)(pass_mode_score_wait_left 9.88))(RSG 0 1)("));
    view.pass_wait_left = 0.0;
    view.pass_wait_right = 0.02;
    EXPECT_THAT(frames.difference(graph, view),
                StartsWith("((time 1.02)(pass_mode_score_wait_right 0.02))(RDS 0 1)("));
}

TEST(Frames, OtherRobotsMeanAFullFrame) {
    body::Scene scene;
    SceneGraph graph;
    graph.update(scene);
    Frames frames;
    EXPECT_TRUE(frames.restart(graph, {}));
    graph.update(scene);
    EXPECT_FALSE(frames.restart(graph, {})) << "the same robots";
    body::Player& player = add(scene, 1, wire::Side::None, 0, {0, -1, 1.5});
    graph.update(scene);
    EXPECT_TRUE(frames.restart(graph, {}));
    EXPECT_THAT(frames.difference(graph, {}), Not(HasSubstr("SLT")));
    player.team = wire::Side::Left;
    player.unum = 5;
    graph.update(scene);
    EXPECT_TRUE(frames.restart(graph, {}));
    EXPECT_THAT(frames.full(graph, {}), HasSubstr("matNum5 matLeft"));
    scene.remove_player(player.id);
    graph.update(scene);
    EXPECT_TRUE(frames.restart(graph, {}));
    EXPECT_EQ(scene_shape(frames.full(graph, {})), kArena);
}

}  // namespace
}  // namespace k3d::server::monitor

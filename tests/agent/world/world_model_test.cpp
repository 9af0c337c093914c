// SPDX-License-Identifier: BSD-3-Clause
// Beliefs against the truth, through the whole chain from percepts on, and the game's state.
#include "agent/world/world_model.h"

#include <gtest/gtest.h>

#include "tests/agent/support/synthetic.h"

namespace k3d::agent::world {
namespace {

struct Trial {
    Trial(const Pose2& start, double speed, std::uint64_t seed, wire::Side on = wire::Side::Left)
        : walker(start, speed, seed),
          eyes(seed, true),
          model(WorldConfig{}, localisation::LocalisationConfig{}, seed, "Own"),
          side(on) {}

    const Beliefs& cycle(bool upright = true, std::span<const talk::Message> messages = {}) {
        const Pose2 odometry = walker.step();
        wire::Percepts percepts;
        percepts.time = time = 0.02 * ++count;
        percepts.game.emplace();
        percepts.game->play_mode = play_mode;
        percepts.game->time = 0.5;
        if (count == 2) {
            percepts.game->unum = 1;
            percepts.game->team = side;
        }
        if (count % 3 == 0) percepts.see = eyes.look(walker.scene);
        motion::State state = synthetic::body_of(walker.scene, walker.known_tilt);
        state.odometry = odometry;
        state.upright = upright;
        return model.update(percepts, state, messages);
    }
    const Beliefs& run(double seconds) {
        for (int k = 1; k < static_cast<int>(seconds * 50.0); ++k) cycle();
        return cycle();
    }
    Vec2 team(const Vec2& on_field) const {
        return side == wire::Side::Right ? Vec2(-on_field) : on_field;
    }

    synthetic::Walker walker;
    synthetic::Eyes eyes;
    WorldModel model;
    wire::Side side;
    std::string play_mode = "PlayOn";
    int count = 0;
    double time = 0.0;
};

class BothSides : public testing::TestWithParam<wire::Side> {};
INSTANTIATE_TEST_SUITE_P(WorldModel, BothSides,
                         testing::Values(wire::Side::Left, wire::Side::Right), [](const auto& test) {
                             return test.param == wire::Side::Left ? "Left" : "Right";
                         });

TEST_P(BothSides, EverythingIsWhereItIsInTheTeamFrame) {
    std::vector<double> ball_errors;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Trial trial({{-2.0, -1.0}, 0.3}, 0.4, seed, GetParam());
        trial.walker.scene.ball = Vec2(1.0, 0.5);
        trial.walker.scene.others = {{"Own", 2, {{2.0, -2.0}, 1.0}, false},
                                     {"Foe", 1, {{3.5, 1.0}, 3.0}, false}};
        trial.walker.scene.own_arms = true;
        const Beliefs& beliefs = trial.run(2.5);
        EXPECT_TRUE(beliefs.self.localised);
        EXPECT_LT(
            (beliefs.self.pose.position - trial.team(trial.walker.scene.robot.position)).norm(),
            0.1);
        ASSERT_TRUE(beliefs.ball.known);
        EXPECT_FALSE(beliefs.ball.moving);
        ball_errors.push_back((beliefs.ball.position - trial.team({1.0, 0.5})).norm());
        ASSERT_EQ(beliefs.mates.size(), 1u);
        EXPECT_EQ(beliefs.mates[0].unum, 2);
        EXPECT_LT((beliefs.mates[0].position - trial.team({2.0, -2.0})).norm(), 0.15);
        ASSERT_EQ(beliefs.opponents.size(), 1u);
        EXPECT_LT((beliefs.opponents[0].position - trial.team({3.5, 1.0})).norm(), 0.15);
        EXPECT_EQ(beliefs.game.side, GetParam());
        EXPECT_EQ(beliefs.game.unum, 1);
    }
    EXPECT_LT(synthetic::median(ball_errors), 0.04);
}

TEST(WorldModel, ARollingBallsVelocityIsRightWhileTheRobotWalks) {
    std::vector<double> errors;
    std::vector<double> finish_errors;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Trial trial({{-3.0, -1.0}, 0.3}, 0.4, seed);
        trial.walker.scene.ball = Vec2(-1.0, 0.5);
        trial.run(2.5);
        const Vec2 velocity = 2.5 * direction(0.2);
        const double start = trial.time;
        Vec2 truth = velocity;
        while (trial.time < start + 0.7) {
            const double t = trial.time + 0.02 - start;
            const double kept = std::exp(-field::kRollDecay * t);
            trial.walker.scene.ball = Vec2(-1.0, 0.5) + velocity * (1.0 - kept) / field::kRollDecay;
            truth = velocity * kept;
            trial.cycle();
        }
        const Ball& ball = trial.model.beliefs().ball;
        if (trial.time - ball.seen > 0.1) continue;  // the sweeping head had left it
        errors.push_back((ball.velocity - truth).norm() / truth.norm());
        finish_errors.push_back(
            (ball.finish - Vec2(-1.0, 0.5) - velocity / field::kRollDecay).norm());
    }
    ASSERT_GE(errors.size(), 10u);
    EXPECT_LT(synthetic::median(errors), 0.10);
    EXPECT_LT(synthetic::median(finish_errors), 0.3);
}

TEST(WorldModel, ABallThatShouldBeInViewAndIsNotIsForgotten) {
    Trial trial({{0.0, 0.0}, 0.0}, 0.0, 1);
    trial.walker.scene.ball = Vec2(2.0, 0.0);
    EXPECT_TRUE(trial.run(1.0).ball.known);
    trial.walker.scene.ball.reset();
    EXPECT_FALSE(trial.run(1.5).ball.known);
}

TEST(WorldModel, ACorrectionOfTheOwnPoseIsNoKick) {
    Trial trial({{0.0, 0.0}, 0.0}, 0.0, 2);
    trial.walker.scene.ball = Vec2(1.5, 0.0);
    trial.run(2.0);
    // Somebody bumps into the robot: it stands 0.3 m aside, and no odometry says so. Ball and robot
    // move together, so that only the pose can be to blame.
    trial.walker.scene.robot.position += Vec2(0.0, 0.3);
    *trial.walker.scene.ball += Vec2(0.0, 0.3);
    for (int k = 0; k < 50; ++k) {
        EXPECT_LT(trial.cycle().ball.velocity.norm(), 0.5) << "cycle " << k;
    }
    EXPECT_LT((trial.model.beliefs().ball.position - Vec2(1.5, 0.3)).norm(), 0.05);
}

TEST(WorldModel, MessagesFillInWhatIsNotSeen) {
    Trial trial({{0.0, 0.0}, 0.0}, 0.0, 3);
    trial.run(1.0);
    talk::Message message;
    message.unum = 3;
    message.position = {-4.0, 1.0};
    message.ball = Vec2(-4.0, -2.0);
    message.opponent = {2, {-3.0, 1.0}};
    talk::Message own;
    own.unum = 1;
    own.position = {9.0, 9.0};
    const std::array<talk::Message, 2> heard{message, own};
    const Beliefs& beliefs = trial.cycle(true, heard);
    ASSERT_EQ(beliefs.mates.size(), 1u);
    EXPECT_EQ(beliefs.mates[0].unum, 3);
    ASSERT_EQ(beliefs.opponents.size(), 1u);
    EXPECT_EQ(beliefs.opponents[0].unum, 2);
    EXPECT_EQ(beliefs.opponents[0].position, Vec2(-3.0, 1.0));
    ASSERT_TRUE(beliefs.ball.known);
    EXPECT_LT((beliefs.ball.position - Vec2(-4.0, -2.0)).norm(), 1e-9);
    EXPECT_LT(beliefs.ball.seen, -1e8);
}

TEST(WorldModel, WhileDownNothingIsTakenFromSight) {
    Trial trial({{0.0, 0.0}, 0.0}, 0.0, 4);
    trial.walker.scene.ball = Vec2(2.0, 0.0);
    trial.run(1.0);
    const double seen = trial.model.beliefs().ball.seen;
    for (int k = 0; k < 50; ++k) trial.cycle(false);
    EXPECT_EQ(trial.model.beliefs().ball.seen, seen);
    EXPECT_FALSE(trial.model.beliefs().self.upright);
    EXPECT_FALSE(trial.model.beliefs().self.localised);
    EXPECT_TRUE(trial.run(1.0).self.localised);
}

TEST(WorldModel, ANewMatchForgetsTheOldOne) {
    Trial trial({{0.0, 0.0}, 0.0}, 0.0, 5);
    trial.walker.scene.ball = Vec2(2.0, 0.0);
    trial.walker.scene.others = {{"Foe", 1, {{3.0, 1.0}, 3.0}, false}};
    trial.run(1.0);
    ASSERT_EQ(trial.model.beliefs().opponents.size(), 1u);
    trial.walker.scene.ball.reset();
    trial.walker.scene.others.clear();
    trial.play_mode = "BeforeKickOff";
    const Beliefs& beliefs = trial.cycle();
    EXPECT_FALSE(beliefs.ball.known);
    EXPECT_TRUE(beliefs.opponents.empty());
    EXPECT_EQ(beliefs.game.play_mode, "BeforeKickOff");
    EXPECT_EQ(beliefs.game.side, wire::Side::Left) << "side and number are told only once";
    EXPECT_TRUE(trial.run(1.0).self.localised);
}

}  // namespace
}  // namespace k3d::agent::world

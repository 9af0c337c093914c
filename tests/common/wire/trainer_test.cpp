// SPDX-License-Identifier: BSD-3-Clause
// Trainer commands as foreign trainers write them, faults, and round trips.
#include "common/wire/trainer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/common/wire/gen.h"

namespace k3d::wire {
namespace {

std::string text_of(const std::vector<TrainerCommand>& commands) {
    std::string out;
    for (const TrainerCommand& command : commands) encode(command, out);
    return out;
}

/// Decodes, expects no fault and writes it again.
std::string rewritten(std::string_view text) {
    std::vector<TrainerCommand> commands;
    EXPECT_EQ(decode(text, commands), 0) << text;
    return text_of(commands);
}

TEST(TrainerDecode, EveryCommand) {
    EXPECT_EQ(rewritten("(ball (pos 1.5 -2 0.042) (vel 0 0 0))"),
              "(ball (pos 1.5 -2 0.042) (vel 0 0 0))");
    EXPECT_EQ(rewritten("(ball (vel 1 2 3))"), "(ball (vel 1 2 3))");
    EXPECT_EQ(rewritten("(agent (team Right)(unum 2)(pos 1.00 2.00 0.40))"),
              "(agent (unum 2)(team Right)(pos 1 2 0.4))");
    EXPECT_EQ(rewritten("(agent (unum 1) (team Left) (move -14 0 0.5 -90))"),
              "(agent (unum 1)(team Left)(move -14 0 0.5 -90))");
    EXPECT_EQ(rewritten("(playMode BeforeKickOff) (kickOff Left)(kickOff None)(dropBall)"),
              "(playMode BeforeKickOff)(kickOff Left)(kickOff None)(dropBall)");
    EXPECT_EQ(rewritten("(time 0)(score (right 2)(left 1))"), "(time 0)(score (left 1)(right 2))");
    EXPECT_EQ(rewritten("(kill (unum 3)(team Left))(repos (unum 4)(team Right))"),
              "(kill (unum 3)(team Left))(repos (unum 4)(team Right))");
    EXPECT_EQ(rewritten("(kill) (repos) (agent)"), "(kill)(repos)(agent)");
    EXPECT_EQ(rewritten("(select (team Left)(unum 2))(select)(select (unum -1))"),
              "(select (unum 2)(team Left))(select)(select (unum -1))");
    EXPECT_EQ(rewritten("(reqfullstate)(killsim)(syn)"), "(reqfullstate)(killsim)(syn)");
    // Without effect here: only that they are no faults.
    EXPECT_EQ(rewritten("(agent (unum 1)(team Left)(temperature 50))"),
              "(agent (unum 1)(team Left)(battery 0))");
    EXPECT_EQ(rewritten("(init)(getAck 3)"), "(init)(init)");
}

TEST(TrainerDecode, KeepsTheOrderOfTheFrame) {
    std::vector<TrainerCommand> commands;
    EXPECT_EQ(decode("(playMode PlayOn) (ball (pos 0 -9 0))", commands), 0);
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_EQ(std::get<PlayModeCommand>(commands[0]).mode, "PlayOn");
    EXPECT_EQ(*std::get<BallCommand>(commands[1]).position, Vec3(0, -9, 0));
}

TEST(TrainerDecode, UnknownAndDamagedAreCountedAndTheRestStands) {
    for (const char* text : {"(select (unum 1))",
                             "(select (unum -2))",
                             "(select (team Left))",
                             "(ball)",
                             "(ball (pos 1 2))",
                             "(ball (pos 1 2 nan))",
                             "(ball (pos 1 2 3 4))",
                             "(ball (pos 1 2 3) (vel 1 2 x))",
                             "(agent (battery 1))",
                             "(agent (unum 1)(team Left)(battery x))",
                             "(agent (unum 1)(team Left)(rot 0 0 90))",
                             "(agent (unum 1)(team left)(pos 1 2 3))",
                             "(agent (unum 1)(team Left))",
                             "(agent (team Left)(pos 1 2 3))",
                             "(agent (unum 1)(team Left)(move 1 2 3))",
                             "(playMode)",
                             "(playMode (a))",
                             "(kickOff)",
                             "(kickOff Both)",
                             "(time -1)",
                             "(time 1e7)",
                             "(ball (pos 1e300 0 0))",
                             "(ball (vel 0 0 -1001))",
                             "(ball (pos nan 0 0))",
                             "(agent (unum 1)(team Left)(pos 0 inf 0))",
                             "(agent (unum 1)(team Left)(move 0 0 1e4 0))",
                             "(score (left 10000)(right 0))",
                             "(time)",
                             "(time x)",
                             "(score (left 1))",
                             "(score (left -1)(right 0))",
                             "(kill (unum 1))",
                             "(repos (unum a)(team Left))",
                             "atom",
                             "()",
                             "(()"}) {
        std::vector<TrainerCommand> commands;
        EXPECT_EQ(decode(std::string("(dropBall)") + text, commands), 1) << text;
        EXPECT_EQ(text_of(commands), "(dropBall)") << text;
    }
}

RC_GTEST_PROP(Trainer, RoundTrip, ()) {
    const auto side = [] { return *rc::gen::element(Side::Left, Side::Right, Side::None); };
    const auto unum = [] { return *rc::gen::arbitrary<int>(); };
    const auto exact = [] {
        return *rc::gen::suchThat<double>([](double v) { return std::isfinite(v); });
    };
    const auto within = [&](double bound) { return std::fmod(exact(), bound); };
    const auto vector = [&] { return Vec3(within(1e3), within(1e3), within(1e3)); };
    AgentCommand agent{unum(), side(), vector(), std::nullopt};
    if (*rc::gen::arbitrary<bool>()) agent.yaw_deg = exact();
    const std::vector<TrainerCommand> sent{BallCommand{vector(), std::nullopt},
                                           BallCommand{std::nullopt, vector()},
                                           BallCommand{vector(), vector()},
                                           agent,
                                           PlayModeCommand{*word()},
                                           KickOffCommand{side()},
                                           TimeCommand{std::abs(within(1e6))},
                                           ScoreCommand{*rc::gen::inRange(0, 10000), 0},
                                           KillCommand{unum(), side()},
                                           ReposCommand{unum(), side()},
                                           SelectCommand{unum(), side()}};
    const std::string text = text_of(sent);
    std::vector<TrainerCommand> read;
    RC_ASSERT(decode(text, read) == 0);
    RC_ASSERT(read.size() == sent.size());
    RC_ASSERT(text_of(read) == text);  // numbers are written exactly, so equal text is equal value
    RC_ASSERT(*std::get<BallCommand>(read[0]).position == *std::get<BallCommand>(sent[0]).position);
    RC_ASSERT(std::get<AgentCommand>(read[3]).yaw_deg == agent.yaw_deg);
}

}  // namespace
}  // namespace k3d::wire

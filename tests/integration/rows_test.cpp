// SPDX-License-Identifier: BSD-3-Clause
// What must not become a row like any other: an episode short of a player, one whose time and modes
// a trainer has set, a match whose physics broke.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "integration/puppets.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* kBallOutside = "(ball (pos 8 0 0.042))";

TEST(Rows, AnEpisodeWhosePlayerATrainerKillsIsLostAndSaysWhose) {
    for (const bool keeper : {true, false}) {
        for (const int turns : {1, 10}) {  // before kick-off and in play
            PuppetGame game("kill", {"--episodes", "2"});
            game.turns(turns);
            game.turn(keeper ? "(kill (unum 1)(team Left))" : "(kill (unum 1)(team Right))");
            EXPECT_EQ(game.play_to_the_end(), 3) << game.server().log();
            const auto rows = game.results();
            ASSERT_EQ(rows.size(), 1U);
            EXPECT_EQ(rows[0].status, episode::Status::AgentLost);
            EXPECT_EQ(rows[0].reason,
                      keeper ? "left.1: killed by a trainer" : "right.1: killed by a trainer");
            EXPECT_EQ(rows[0].players.size(), 2U);
        }
    }
}

TEST(Rows, WhoIsKilledAfterTheWhistlePlaysTheNextEpisode) {
    PuppetGame game("late-kill", {"--episodes", "2"});
    game.turns(10);
    game.turn(kBallOutside);
    game.turn("(kill (unum 1)(team Right))");
    game.turns(15);
    game.turn(kBallOutside);
    EXPECT_EQ(game.play_to_the_end(), 0) << game.server().log();
    const auto rows = game.results();
    ASSERT_EQ(rows.size(), 2U);
    for (const episode::Result& row : rows) {
        EXPECT_EQ(row.reason, "ball_out");
        EXPECT_EQ(row.players.size(), 2U);
        EXPECT_GT(row.hold_time_s, 0.1);
    }
}

TEST(Rows, NoFurtherEpisodeBeginsWithoutWhoLeftAfterTheWhistle) {
    PuppetGame game("leaver", {"--episodes", "3"}, until_the_whistle);
    game.turns(10);
    game.turn(kBallOutside);
    EXPECT_EQ(game.play_to_the_end(), 3);
    const auto rows = game.results();
    ASSERT_EQ(rows.size(), 1U) << game.server().log();
    EXPECT_EQ(rows[0].reason, "ball_out") << "what was over is valid";
    EXPECT_THAT(game.server().log(), HasSubstr("keepaway 2 of 3 cannot begin: missing right 1"));
}

TEST(Rows, SayTheSameWhateverModeAndTimeATrainerWishes) {
    const auto play = [](const std::string& name, const std::vector<std::string>& wishes) {
        PuppetGame game(name, {"--set", "keepaway.limit=1"});
        game.turns(10);
        for (const std::string& wish : wishes) game.turn(wish);
        EXPECT_EQ(game.play_to_the_end(), 0);
        const auto rows = game.results();
        EXPECT_EQ(rows.size(), 1U) << "it must end by the limit: " << game.server().log();
        return std::pair(rows.empty() ? "" : episode::to_line(rows[0]), game.server().log());
    };
    const auto [quiet, unused] = play("quiet", {});
    EXPECT_THAT(quiet, HasSubstr("time_limit"));
    const std::vector<std::string> wishes{"(time 0)",
                                          "(time 250)",
                                          "(dropBall)",
                                          "(kickOff Left)",
                                          "(playMode free_kick_left)",
                                          "(playMode GameOver)"};
    const auto [wished, log] = play("wishes", wishes);
    EXPECT_EQ(wished, quiet);
    for (const std::string& wish : wishes) {
        EXPECT_THAT(log, HasSubstr(": " + wish + " ignored, keepaway keeps its own time")) << wish;
    }
    EXPECT_THAT(log, HasSubstr("trainer at 127.0.0.1:"));
}

TEST(Rows, OfASoccerMatchWhosePhysicsBreaksSaysSo) {
    const auto results = std::filesystem::temp_directory_path() /
                         ("k3d-diverged-" + std::to_string(getpid()) + ".jsonl");
    std::filesystem::remove(results);
    ServerProcess server(fast_with_one_agent({"--results", results.string()}));
    WireAgent agent(server);
    agent.begin_match("Reds");
    net::Client trainer("127.0.0.1", server.trainer_port(), kPatience);
    trainer.send("(playMode PlayOn)(ball (pos 0 0 -900))");  // below the ground
    try {
        wire::Percepts percepts;
        for (int i = 0; i < 5000; ++i) {
            agent.send("(syn)");
            if (!agent.receive(percepts)) break;
        }
    } catch (const net::NetError&) {  // it ended between the two
    }
    const auto exit = server.child().wait(kPatience);
    EXPECT_TRUE(exit && exit->code == 0) << server.log();
    std::ifstream file(results);
    std::string line;
    ASSERT_TRUE(std::getline(file, line)) << server.log();
    const episode::Result row = episode::from_line(line);
    EXPECT_EQ(row.game, "soccer");
    EXPECT_EQ(row.status, episode::Status::Diverged);
    EXPECT_FALSE(row.reason.empty());
    std::filesystem::remove(results);
}

}  // namespace
}  // namespace k3d::testing

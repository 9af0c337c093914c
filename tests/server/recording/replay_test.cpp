// SPDX-License-Identifier: BSD-3-Clause
// A recording's steps as connections.
#include "server/recording/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "server/recording/recorder.h"

namespace k3d::server::recording {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ReplayFile : public ::testing::Test {
  protected:
    ~ReplayFile() override { std::filesystem::remove(name_); }

    /// The error of reading all steps; empty if there is none.
    std::string error() const {
        try {
            Replay replay(name_);
            while (replay.next_step()) {
            }
        } catch (const RecordError& fault) {
            return fault.what();
        }
        return "";
    }

    std::string name_ = (std::filesystem::temp_directory_path() /
                         ("k3d-replay-test-" + std::to_string(getpid())))
                            .string();
};

std::vector<std::string> frames(net::Connection& connection) {
    std::vector<std::string> all;
    std::string_view frame;
    while (connection.next_frame(frame)) all.emplace_back(frame);
    return all;
}

TEST_F(ReplayFile, FramesComeInTheStepInWhichTheyWereTaken) {
    {
        RecordWriter writer(name_, {"v", "seed = 3"});
        writer.add(StepEnd{10});
        writer.add({1, Port::Agent, false, "peer 1"});
        writer.add({2, Port::Monitor, true, "peer 2"});
        writer.add(2, "(dropBall)");
        writer.add(1, "(syn)");
        writer.add(1, "(he1 1)");
        writer.add(StepEnd{11});
        writer.add(1, "(he1 2)");
        writer.add(Left{2, "peer closed"});
        writer.add(StepEnd{12});
        writer.add(End{0});
    }
    Replay replay(name_);
    EXPECT_EQ(replay.header().config, "seed = 3");
    auto step = replay.next_step();
    ASSERT_TRUE(step);
    EXPECT_TRUE(step->arrivals.empty());
    EXPECT_EQ(step->digest, 10U);

    step = replay.next_step();
    ASSERT_TRUE(step);
    ASSERT_EQ(step->arrivals.size(), 2U);
    const auto agent = std::move(step->arrivals[0].connection);
    const auto monitor = std::move(step->arrivals[1].connection);
    EXPECT_EQ(step->arrivals[1].accepted.port, Port::Monitor);
    EXPECT_TRUE(step->arrivals[1].accepted.commands);
    EXPECT_EQ(agent->peer(), "peer 1");
    EXPECT_THAT(frames(*agent), ElementsAre("(syn)", "(he1 1)"));
    EXPECT_THAT(frames(*monitor), ElementsAre("(dropBall)"));
    EXPECT_FALSE(agent->ready() || agent->send("x")) << "nobody listens";

    step = replay.next_step();
    ASSERT_TRUE(step);
    EXPECT_THAT(frames(*agent), ElementsAre("(he1 2)"));
    ASSERT_EQ(step->left.size(), 1U);
    EXPECT_EQ(step->left[0].connection, 2);
    EXPECT_FALSE(replay.complete());
    EXPECT_FALSE(replay.next_step());
    EXPECT_TRUE(replay.complete());
    agent->close("lost");
    EXPECT_TRUE(agent->closed());
}

TEST_F(ReplayFile, ImpossibleEntriesAreNamed) {
    {
        RecordWriter writer(name_, {});
        writer.add(5, "(syn)");
        writer.add(StepEnd{1});
    }
    EXPECT_THAT(error(), HasSubstr("a frame of connection 5, which never came"));
    {
        RecordWriter writer(name_, {});
        writer.add(Accepted{5, Port::Agent, false, ""});
        writer.add(Accepted{5, Port::Agent, false, ""});
    }
    EXPECT_THAT(error(), HasSubstr("connection 5 twice"));
    {
        RecordWriter writer(name_, {});
        writer.add(End{0});
        writer.add(StepEnd{1});
    }
    EXPECT_THAT(error(), HasSubstr("more behind the end of the run"));
    std::filesystem::remove(name_);
    EXPECT_THAT(error(), HasSubstr("cannot read: No such file"));
}

TEST(Digest, DependsOnEachPart) {
    game::GameState state;
    const std::uint64_t base = digest(1, Cycle{2}, state);
    EXPECT_EQ(digest(1, Cycle{2}, state), base);
    EXPECT_NE(digest(2, Cycle{2}, state), base);
    EXPECT_NE(digest(1, Cycle{3}, state), base);
    for (const auto& change : std::vector<std::function<void(game::GameState&)>>{
             [](auto& s) { s.mode = game::PlayMode::PlayOn; }, [](auto& s) { s.time = 0.02; },
             [](auto& s) { s.half = 2; }, [](auto& s) { s.score_left = 1; },
             [](auto& s) { s.score_right = 1; }}) {
        game::GameState other;
        change(other);
        EXPECT_NE(digest(1, Cycle{2}, other), base);
    }
}

}  // namespace
}  // namespace k3d::server::recording

// SPDX-License-Identifier: BSD-3-Clause
// Byte for byte, our frames are built as those recorded from the reference server: the same groups in
// the same order, blanks, decimals and signs, numbers aside. The dialogue is that of the recording.
#include <gtest/gtest.h>

#include <cctype>
#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "integration/server_process.h"

namespace k3d::testing {
namespace {

/// A number becomes '#', its decimals one '#' each: "(ax -12.30)" -> "(ax #.##)".
std::string shape(const std::string& frame) {
    const auto digit = [&](std::size_t i) {
        return i < frame.size() && std::isdigit(static_cast<unsigned char>(frame[i])) != 0;
    };
    std::string out;
    for (std::size_t i = 0; i < frame.size();) {
        const std::size_t first = frame[i] == '-' ? i + 1 : i;
        if (out.empty() || out.back() != ' ' || !digit(first)) {
            out += frame[i++];
            continue;
        }
        for (i = first; digit(i);) ++i;
        out += '#';
        if (i < frame.size() && frame[i] == '.') {
            out += frame[i++];
            for (; digit(i); ++i) out += '#';
        }
    }
    return out;
}

struct Recorded {
    int type;
    std::size_t number;
    std::string frame;
};

std::vector<Recorded> recorded_frames() {
    std::ifstream file(std::string(K3D_SOURCE_DIR) + "/tests/integration/recorded_frames.txt");
    std::vector<Recorded> frames;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        Recorded& one = frames.emplace_back();
        std::istringstream words(line);
        words >> one.type >> one.number;
        std::getline(words >> std::ws, one.frame);
    }
    return frames;
}

/// A team-mate behind the tested agent's back, out of its view. The server waits for it in every cycle, and
/// so goes no further than told: nobody is waited for at the handshake, nor before its fifth frame.
class Metronome {
  public:
    explicit Metronome(const ServerProcess& server) : agent_(server) {
        take_seat(server);
        agent_.step("(beam -14 -9 0)");
        for (int cycle = 0; cycle < 10; ++cycle) tick();
    }

    /// Lets the server go on by one cycle, and gives its time.
    double tick() { return agent_.step().time; }

    /// Cycles until the newcomer has its first frame; the time of the last cycle. The newcomer has
    /// connected before us, so that a cycle's frame is sent to it before ours: once ours is here,
    /// its own is, too.
    double tick_until_answered(WireAgent& newcomer, wire::Percepts& percepts) {
        for (int cycle = 0; cycle < 100; ++cycle) {
            const double now = tick();
            try {
                if (newcomer.receive(percepts, std::chrono::milliseconds(250))) return now;
                break;
            } catch (const net::NetError&) {
                continue;  // its robot is not yet there to sense anything
            }
        }
        ADD_FAILURE() << "no frame within 100 cycles";
        return 0.0;
    }

  private:
    /// The server must not be given one (syn) too many, nor may a frame lie unread: from then on
    /// each tick would give an old one. So it gets none at all until it waits for one, in the cycle
    /// after the one that gives us our seat.
    void take_seat(const ServerProcess& server) {
        wire::Percepts percepts;
        agent_.send("(scene rsg/agent/nao/nao.rsg)");
        for (int frame = 0; frame < 5; ++frame) EXPECT_TRUE(agent_.receive(percepts));
        agent_.send("(init (unum 2)(teamname Alpha))");
        const auto deadline = std::chrono::steady_clock::now() + kPatience;
        while (server.log().find("is left.2 of team") == std::string::npos) {
            if (std::chrono::steady_clock::now() > deadline) throw std::runtime_error("no seat");
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        agent_.send("(syn)");
        // All that the server sent while it did not wait, and at last the answer.
        while (agent_.receive(percepts) && !percepts.game->unum) {
        }
    }

    WireAgent agent_;
};

class Grammar : public ::testing::TestWithParam<int> {};

TEST_P(Grammar, OfTheFirstFramesIsTheRecordedOne) {
    const int type = GetParam();
    // With a clock there are few frames before it waits for anybody.
    ServerProcess server({"--pace", "sync"});
    WireAgent agent(server);
    Metronome metronome(server);
    wire::Percepts percepts;
    agent.send("(scene rsg/agent/nao/nao_hetero.rsg " + std::to_string(type) + ")(syn)");
    const double now = metronome.tick_until_answered(agent, percepts);
    ASSERT_NEAR(percepts.time, now, 1e-9) << "of another cycle";
    std::vector<std::string> ours{agent.last_payload()};
    while (ours.size() < 8) {
        agent.send(ours.size() == 1 ? "(init (unum 1)(teamname Alpha))(syn)" : "(syn)");
        metronome.tick();
        ASSERT_TRUE(agent.receive(percepts));
        ours.push_back(agent.last_payload());
    }
    int compared = 0;
    for (const Recorded& recorded : recorded_frames()) {
        if (recorded.type != type) continue;
        EXPECT_EQ(shape(ours.at(recorded.number)), recorded.frame) << "frame " << recorded.number;
        ++compared;
    }
    EXPECT_GE(compared, 3);
}

INSTANTIATE_TEST_SUITE_P(Recorded, Grammar, ::testing::Values(0, 4),
                         [](const auto& test) { return "Type" + std::to_string(test.param); });

TEST(GrammarShape, KeepsEverythingButTheDigits) {
    EXPECT_EQ(shape("(HJ (n rlj1) (ax -0.00))(GS (sl 12) (pm PlayOn))"),
              "(HJ (n rlj1) (ax #.##))(GS (sl #) (pm PlayOn))");
}

}  // namespace
}  // namespace k3d::testing

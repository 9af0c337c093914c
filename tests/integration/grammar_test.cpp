// SPDX-License-Identifier: BSD-3-Clause
// Byte for byte, our frames are built as those recorded from the reference server: the same groups in
// the same order, blanks, decimals and signs, numbers aside. The dialogue is that of the recording.
#include <gtest/gtest.h>

#include <cctype>
#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
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
        agent_.join(2, "Alpha");
        agent_.step("(beam -14 -9 0)");
        for (int cycle = 0; cycle < 10; ++cycle) tick();
    }

    /// Lets the server go on by one cycle.
    void tick() { now_ = agent_.step().time; }

    /// Cycles until the newcomer has its first frame; the time of the last cycle.
    double tick_until_answered(WireAgent& newcomer, wire::Percepts& percepts) {
        for (int cycle = 0; cycle < 100; ++cycle) {
            tick();
            try {
                if (!newcomer.receive(percepts, std::chrono::milliseconds(250))) break;
            } catch (const net::NetError&) {
                continue;  // the server had not yet read its scene
            }
            read_up_to(percepts.time);
            return now_;
        }
        ADD_FAILURE() << "no frame within 100 cycles";
        return 0.0;
    }

  private:
    /// Frames that came before it was waited for may still lie unread: then each tick reads an old
    /// one.
    void read_up_to(double time) {
        wire::Percepts percepts;
        while (now_ < time - 1e-9 && agent_.receive(percepts)) now_ = percepts.time;
    }

    WireAgent agent_;
    double now_ = 0.0;
};

class Grammar : public ::testing::TestWithParam<int> {};

TEST_P(Grammar, OfTheFirstFramesIsTheRecordedOne) {
    const int type = GetParam();
    ServerProcess server({"--pace", "fast"});
    Metronome metronome(server);
    WireAgent agent(server);
    wire::Percepts percepts;
    agent.send("(scene rsg/agent/nao/nao_hetero.rsg " + std::to_string(type) + ")(syn)");
    const double now = metronome.tick_until_answered(agent, percepts);
    ASSERT_NEAR(percepts.time, now, 1e-9) << "a frame came late";
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

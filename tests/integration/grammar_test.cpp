// SPDX-License-Identifier: BSD-3-Clause
// Byte for byte, our frames are built as those recorded from the reference server: the same groups in
// the same order, blanks, decimals and signs, numbers aside. The dialogue is that of the recording.
#include <gtest/gtest.h>

#include <cctype>
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

class Grammar : public ::testing::TestWithParam<int> {};

TEST_P(Grammar, OfTheFirstFramesIsTheRecordedOne) {
    const int type = GetParam();
    ServerProcess server({"--pace", "fast"});
    WireAgent agent(server);
    wire::Percepts percepts;
    agent.send("(scene rsg/agent/nao/nao_hetero.rsg " + std::to_string(type) + ")(syn)");
    ASSERT_TRUE(agent.receive(percepts));
    std::vector<std::string> ours{agent.last_payload()};
    agent.step("(init (unum 1)(teamname Alpha))");
    ours.push_back(agent.last_payload());
    while (ours.size() < 8) {
        agent.step();
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

INSTANTIATE_TEST_SUITE_P(Recorded, Grammar, ::testing::Values(0, 4));

TEST(GrammarShape, KeepsEverythingButTheDigits) {
    EXPECT_EQ(shape("(HJ (n rlj1) (ax -0.00))(GS (sl 12) (pm PlayOn))"),
              "(HJ (n rlj1) (ax #.##))(GS (sl #) (pm PlayOn))");
}

}  // namespace
}  // namespace k3d::testing

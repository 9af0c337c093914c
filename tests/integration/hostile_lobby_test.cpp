// SPDX-License-Identifier: BSD-3-Clause
// A trainer that wants to hurt a server whose match has not begun.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "integration/raw_socket.h"
#include "integration/server_process.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;

TEST(HostileLobby, ATrainerFillsNoLogAndWritesNoBytesOfItsOwnToIt) {
    ServerProcess server({"--game", "keepaway", "--pace", "fast"});
    std::string commands;
    while (commands.size() < 60'000) commands += "(playMode \x1b[2J\x07\xff\x7fx)";
    std::string frame;
    wire::append_frame(commands + "(killsim)", frame);
    RawSocket trainer(server.trainer_port());
    trainer.write(frame);
    const auto exit = server.child().wait(kPatience);
    ASSERT_TRUE(exit) << "killsim is obeyed";
    EXPECT_EQ(exit->code, 0);
    const std::string log = server.log();
    EXPECT_LT(std::ranges::count(log, '\n'), 100) << "of 3000 commands";
    EXPECT_TRUE(std::ranges::all_of(log, [](char c) {
        return c == '\n' || (c >= ' ' && c <= '~');
    })) << "only what is fit for a terminal";
    EXPECT_THAT(log, HasSubstr("trainer at 127.0.0.1:"));
    EXPECT_THAT(log, HasSubstr(": (playMode ?[2J???x) ignored, the match has not begun"));
    EXPECT_THAT(log, HasSubstr("lines about peers left out"));
}

}  // namespace
}  // namespace k3d::testing

// SPDX-License-Identifier: BSD-3-Clause
// What programs refuse is known before anything is played.
#include "optimizer/spec/ask.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/config/config.h"

namespace k3d::optimizer::spec {
namespace {

using testing::HasSubstr;

TaskSpec real_programs() {
    TaskSpec task;
    task.server_program = K3D_BIN_DIR "/k3d-server";
    task.agent_program = K3D_BIN_DIR "/k3d-agent";
    return task;
}

std::string fault_of(const std::string& words, const TaskSpec& task = real_programs()) {
    try {
        require_taken("a.toml: task.settings", task, parse_settings(words));
    } catch (const config::ConfigError& error) {
        return error.what();
    }
    return "";
}

TEST(Ask, GivesAllThatAProgramPrints) {
    const Answer answer = ask({"/bin/sh", "-c", "echo one; echo two >&2; exit 3"});
    ASSERT_TRUE(answer.exit);
    EXPECT_EQ(answer.exit->code, 3);
    EXPECT_EQ(answer.text, "one\ntwo\n");
    EXPECT_THROW(ask({"/nowhere/agent"}), process::StartError);
}

TEST(RequireTaken, NamesTheProgramThatRefuses) {
    EXPECT_EQ(fault_of(""), "");
    EXPECT_EQ(fault_of("server:physics.stepper=fast agent:keeper.hold_threshold=2.0"), "");
    EXPECT_THAT(fault_of("server:physics.stepper=fast server:physics.steper=exact"),
                HasSubstr("a.toml: task.settings: k3d-server: unknown key \"physics.steper\""));
    EXPECT_THAT(fault_of("keeper:motion.wlak=3"),
                HasSubstr("a.toml: task.settings: k3d-agent: unknown key \"motion.wlak\""));
    EXPECT_THAT(fault_of("taker:taker.top_speed=fast"),
                HasSubstr("k3d-agent: \"taker.top_speed\""));
}

TEST(LastWords, AreThoseThatNameWhatWasAmiss) {
    EXPECT_EQ(last_words("ready\n--seed: 'x' is no number\nRun with --help for more.\n\n"),
              "--seed: 'x' is no number");
    EXPECT_EQ(last_words(""), "");
}

TEST(RequireTaken, AsksNobodyWhoIsNotThere) {
    TaskSpec task = real_programs();
    task.taker_command = "foreign --port={port}";
    EXPECT_EQ(fault_of("taker:motion.wlak=3", task), "") << "no agent of ours takes";
    task.server_program = "/nowhere/server";
    EXPECT_EQ(fault_of("server:physics.steper=exact", task), "")
        << "it may be where episodes are played";
}

}  // namespace
}  // namespace k3d::optimizer::spec

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/drill_spec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace k3d::optimizer::spec {
namespace {

using testing::HasSubstr;

std::string fault_of(const DrillSpec& spec) {
    try {
        check(spec);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(DrillSpecCheck, AServerThatRunsAlreadyTakesNoSettings) {
    DrillSpec spec;
    EXPECT_EQ(fault_of(spec), "");
    spec.pace = "sync";
    spec.settings = "server:physics.stepper=fast agent:role=drill";
    spec.http_port = 0;
    EXPECT_EQ(fault_of(spec), "") << "its own server does";
    spec.agent_port = 3100;
    EXPECT_THAT(fault_of(spec), HasSubstr("agent_port and server_port"));
    spec.server_port = 3200;
    EXPECT_EQ(fault_of(spec),
              "a server that runs already is not told http_port 0, pace sync, "
              "server:physics.stepper=fast; agent_port 3100 names one");
    spec.http_port = -1;
    spec.pace = "";
    spec.settings = "agent:role=drill";
    EXPECT_EQ(fault_of(spec), "");
}

TEST(DrillSpecCheck, AHostIsOfAServerThatRunsAlready) {
    DrillSpec spec;
    spec.host = "example.org";
    EXPECT_THAT(fault_of(spec), HasSubstr("host example.org"));
    spec.agent_port = 3100;
    spec.server_port = 3200;
    EXPECT_EQ(fault_of(spec), "");
}

TEST(DrillSpecCheck, NamesWhatNoSingleFieldCanTell) {
    DrillSpec spec;
    spec.setup.roll_least = 7.0;
    EXPECT_THAT(fault_of(spec), HasSubstr("roll_least 7 is above roll_most 6"));
}

}  // namespace
}  // namespace k3d::optimizer::spec

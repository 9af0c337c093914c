// SPDX-License-Identifier: BSD-3-Clause
// Tests of complex behaviours: Algorithm 1 and the order of abort and invoke.
#include "agent/decision/behaviour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace k3d::agent::decision {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Log = std::vector<std::string>;

Action<int, std::string> logged(const std::string& name, Log& log) {
    return {name,
            [name, &log](const int&) {
                log.push_back("skill " + name);
                return name;
            },
            [name, &log] { log.push_back("invoke " + name); },
            [name, &log] { log.push_back("abort " + name); }};
}

/// The state that the world says.
const Chooser<int> kObedient = [](const int& world, int) { return world; };

TEST(ComplexBehaviour, StateChangesOneCallAfterItWasChosen) {
    Log log;
    ComplexBehaviour<int, std::string> b({logged("a", log), logged("b", log)}, kObedient);
    EXPECT_EQ(b.get_skill(0), "a");
    EXPECT_EQ(b.get_skill(1), "a");  // chosen now
    EXPECT_EQ(b.state(), 0);
    EXPECT_EQ(b.next_state(), 1);
    EXPECT_EQ(b.get_skill(1), "b");  // in force now
    EXPECT_EQ(b.state(), 1);
}

TEST(ComplexBehaviour, AbortsTheOldThenInvokesTheNewThenAsksTheOldOnce) {
    Log log;
    ComplexBehaviour<int, std::string> b({logged("a", log), logged("b", log)}, kObedient);
    b.get_skill(1);
    EXPECT_THAT(log, ElementsAre("abort a", "invoke b", "skill a"));
    log.clear();
    b.get_skill(1);
    EXPECT_THAT(log, ElementsAre("skill b"));
    log.clear();
    b.get_skill(0);
    b.get_skill(0);
    EXPECT_THAT(log, ElementsAre("abort b", "invoke a", "skill b", "skill a"));
}

TEST(ComplexBehaviour, InvokeSetsTheInitialStateAndAbortTheOtherOne) {
    Log log;
    ComplexBehaviour<int, std::string> b(
        {logged("a", log), logged("b", log), logged("c", log)}, kObedient, 1, 2);
    b.get_skill(0);
    b.get_skill(0);
    log.clear();
    b.invoke();
    EXPECT_EQ(b.state(), 1);
    EXPECT_EQ(b.next_state(), 1);
    EXPECT_THAT(log, ElementsAre("invoke b"));
    log.clear();
    b.abort();
    EXPECT_EQ(b.state(), 2);
    EXPECT_EQ(b.next_state(), 2);
    EXPECT_THAT(log, ElementsAre("abort b"));
}

TEST(ComplexBehaviour, NestsAndPassesInvokeAndAbortOn) {
    Log log;
    ComplexBehaviour<int, std::string> inner({logged("x", log), logged("y", log)},
                                             [](const int& world, int) { return world / 10; });
    ComplexBehaviour<int, std::string> outer({logged("a", log), inner.as_action("inner")},
                                             [](const int& world, int) { return world % 10; });
    outer.get_skill(1);
    EXPECT_THAT(log, ElementsAre("abort a", "invoke x", "skill a"));
    log.clear();
    EXPECT_EQ(outer.get_skill(11), "x");
    EXPECT_EQ(outer.get_skill(11), "y");
    EXPECT_EQ(outer.state_name(), "inner");
    log.clear();
    outer.get_skill(0);
    EXPECT_THAT(log, ElementsAre("abort y", "invoke a", "skill x"));
}

TEST(ComplexBehaviour, PrimitiveActionNeedsNoInvokeOrAbort) {
    ComplexBehaviour<int, int> b({{"one", [](const int&) { return 1; }},
                                  {"two", [](const int&) { return 2; }}},
                                 kObedient);
    b.get_skill(1);
    EXPECT_EQ(b.get_skill(1), 2);
}

TEST(ComplexBehaviour, NetworkChooserTakesTheLargestOutputTheFirstOfEquals) {
    network::Definition d;
    d.inputs = {{"x"}};
    d.outputs = {"low", "high", "also"};
    d.nodes = {{"low", network::Activation::Linear, 0.0},
               {"high", network::Activation::Linear, 0.0},
               {"also", network::Activation::Linear, 0.0}};
    d.links = {{"x", "low", -1.0}, {"x", "high", 1.0}, {"x", "also", 1.0}};
    const auto choose = network_chooser<double>(network::Network(d, "test"), [](const double& x) {
        return std::vector<double>{x};
    });
    EXPECT_EQ(choose(2.0, 0), 1);
    EXPECT_EQ(choose(-2.0, 1), 0);
    EXPECT_EQ(choose(0.0, 2), 0);
}

}  // namespace
}  // namespace k3d::agent::decision

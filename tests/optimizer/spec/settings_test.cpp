// SPDX-License-Identifier: BSD-3-Clause
// Settings for the programs of an episode.
#include "optimizer/spec/settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace k3d::optimizer::spec {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Settings, GoToTheProgramTheyName) {
    const Settings s =
        parse_settings("server:keepaway.side=12 keeper:a=1 agent:b.c=x=y taker:\"d=two words\"");
    EXPECT_THAT(s.server, ElementsAre("keepaway.side=12"));
    EXPECT_THAT(s.keeper, ElementsAre("a=1", "b.c=x=y"));
    EXPECT_THAT(s.taker, ElementsAre("b.c=x=y", "d=two words"));
    EXPECT_THAT(parse_settings("").server, IsEmpty());
}

TEST(Settings, OthersAreErrorsThatNameTheWord) {
    for (const char* word : {"keepaway.side=12", "referee:a=1", "server:a", "server:=1", "server",
                             "a=server:b=1", ":a=1"}) {
        try {
            parse_settings(word);
            ADD_FAILURE() << word;
        } catch (const std::invalid_argument& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(std::string("'") + word + "'"));
        }
    }
}

}  // namespace
}  // namespace k3d::optimizer::spec

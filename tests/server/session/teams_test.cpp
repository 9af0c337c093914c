// SPDX-License-Identifier: BSD-3-Clause
// Who gets which seat, and what the others are told.
#include "server/session/teams.h"

#include <gtest/gtest.h>

namespace k3d::server::session {
namespace {

TEST(Teams, FirstNameIsLeftSecondIsRightThirdIsRefused) {
    Teams teams("", "", 11, 11);
    EXPECT_EQ(teams.assign({3, "Reds"})->team, wire::Side::Left);
    EXPECT_EQ(teams.assign({3, "Blues"})->team, wire::Side::Right);
    const auto third = teams.assign({1, "Greens"});
    ASSERT_FALSE(third);
    EXPECT_EQ(third.error(), "third team 'Greens': the match is 'Reds' against 'Blues'");
}

TEST(Teams, ReservedNamesDoNotDependOnWhoComesFirst) {
    Teams teams("Keepers", "Takers", 3, 2);
    EXPECT_EQ(teams.assign({1, "Takers"})->team, wire::Side::Right);
    EXPECT_EQ(teams.assign({1, "Keepers"})->team, wire::Side::Left);
}

TEST(Teams, NumberZeroTakesTheLowestFree) {
    Teams teams("", "", 11, 11);
    EXPECT_EQ(teams.assign({2, "Reds"})->unum, 2);
    EXPECT_EQ(teams.assign({0, "Reds"})->unum, 1);
    EXPECT_EQ(teams.assign({0, "Reds"})->unum, 3);
}

TEST(Teams, BadNumbersAreNamed) {
    Teams teams("", "", 11, 11);
    EXPECT_EQ(teams.assign({99, "Reds"}).error(), "number 99 is not in 0..11");
    EXPECT_EQ(teams.assign({-1, "Reds"}).error(), "number -1 is not in 0..11");
    ASSERT_TRUE(teams.assign({4, "Reds"}));
    EXPECT_EQ(teams.assign({4, "Reds"}).error(), "number 4 of team 'Reds' is taken");
}

TEST(Teams, TheTwelfthPlayerIsRefusedAndALeftSeatIsFreeAgain) {
    Teams teams("", "", 11, 11);
    for (int unum = 1; unum <= 11; ++unum) ASSERT_TRUE(teams.assign({unum, "Reds"}));
    EXPECT_EQ(teams.assign({0, "Reds"}).error(), "team 'Reds' already has its 11 players");
    teams.release({wire::Side::Left, 5});
    EXPECT_EQ(teams.assign({0, "Reds"})->unum, 5);
}

TEST(Teams, NamesThatWouldHurtOthersAreRefused) {
    Teams teams("", "", 11, 11);
    const std::string why = " is not 1 to 32 bytes of visible ASCII";
    EXPECT_EQ(teams.assign({1, ""}).error(), "team name ''" + why);
    EXPECT_EQ(teams.assign({1, "R\xC3\xA9" "ds\x1B[2J"}).error(), "team name 'R??ds?[2J'" + why);
    EXPECT_EQ(teams.assign({1, std::string(60'000, 'x')}).error(),
              "team name '" + std::string(120, 'x') + "...'" + why);
    EXPECT_TRUE(teams.assign({1, std::string(32, 'x')}));
}

TEST(Teams, KeepawaySeatsAreCountedAndNamed) {
    Teams teams("Keepers", "Takers", 2, 1);
    EXPECT_EQ(teams.missing(), "left 1, left 2, right 1");
    ASSERT_TRUE(teams.assign({2, "Keepers"}));
    EXPECT_FALSE(teams.assign({3, "Keepers"}));
    ASSERT_TRUE(teams.assign({0, "Keepers"}));
    EXPECT_FALSE(teams.full());
    ASSERT_TRUE(teams.assign({1, "Takers"}));
    EXPECT_TRUE(teams.full());
}

}  // namespace
}  // namespace k3d::server::session

// SPDX-License-Identifier: BSD-3-Clause
// Who gets which seat, and what the others are told.
#include "server/session/teams.h"

#include <gtest/gtest.h>

#include "common/config/config.h"

namespace k3d::server::session {
namespace {

TEST(Teams, FirstNameIsLeftSecondIsRightThirdIsRefused) {
    Teams teams("", "", 11, 11, std::nullopt);
    EXPECT_EQ(teams.assign({3, "Reds"}, 0)->team, wire::Side::Left);
    EXPECT_EQ(teams.assign({3, "Blues"}, 0)->team, wire::Side::Right);
    const auto third = teams.assign({1, "Greens"}, 0);
    ASSERT_FALSE(third);
    EXPECT_EQ(third.error(), "third team 'Greens': the match is 'Reds' against 'Blues'");
}

TEST(Teams, ReservedNamesDoNotDependOnWhoComesFirst) {
    Teams teams("Keepers", "Takers", 3, 2, std::nullopt);
    EXPECT_EQ(teams.assign({1, "Takers"}, 0)->team, wire::Side::Right);
    EXPECT_EQ(teams.assign({1, "Keepers"}, 0)->team, wire::Side::Left);
}

TEST(Teams, NumberZeroTakesTheLowestFree) {
    Teams teams("", "", 11, 11, std::nullopt);
    EXPECT_EQ(teams.assign({2, "Reds"}, 0)->unum, 2);
    EXPECT_EQ(teams.assign({0, "Reds"}, 0)->unum, 1);
    EXPECT_EQ(teams.assign({0, "Reds"}, 0)->unum, 3);
}

TEST(Teams, BadNumbersAreNamed) {
    Teams teams("", "", 11, 11, std::nullopt);
    EXPECT_EQ(teams.assign({99, "Reds"}, 0).error(), "number 99 is not in 0..11");
    EXPECT_EQ(teams.assign({-1, "Reds"}, 0).error(), "number -1 is not in 0..11");
    ASSERT_TRUE(teams.assign({4, "Reds"}, 0));
    EXPECT_EQ(teams.assign({4, "Reds"}, 0).error(), "number 4 of team 'Reds' is taken");
}

TEST(Teams, TheTwelfthPlayerIsRefusedAndALeftSeatIsFreeAgain) {
    Teams teams("", "", 11, 11, std::nullopt);
    for (int unum = 1; unum <= 11; ++unum) ASSERT_TRUE(teams.assign({unum, "Reds"}, 0));
    EXPECT_EQ(teams.assign({0, "Reds"}, 0).error(), "team 'Reds' already has its 11 players");
    teams.release({wire::Side::Left, 5});
    EXPECT_EQ(teams.assign({0, "Reds"}, 0)->unum, 5);
}

TEST(Teams, NamesThatWouldHurtOthersAreRefused) {
    Teams teams("", "", 11, 11, std::nullopt);
    const std::string why = " is not 1 to 32 bytes of visible ASCII without parentheses";
    EXPECT_EQ(teams.assign({1, ""}, 0).error(), "team name ''" + why);
    EXPECT_EQ(teams.assign({1, "R\xC3\xA9" "ds\x1B[2J"}, 0).error(), "team name 'R??ds?[2J'" + why);
    EXPECT_EQ(teams.assign({1, std::string(60'000, 'x')}, 0).error(),
              "team name '" + std::string(120, 'x') + "...'" + why);
    EXPECT_TRUE(teams.assign({1, std::string(32, 'x')}, 0));
}

TEST(Teams, ReservedNamesThatNobodyCanHaveAreRefused) {
    const auto fault = [](const std::string& left, const std::string& right) -> std::string {
        try {
            Teams(left, right, 3, 2, std::nullopt);
        } catch (const config::ConfigError& error) {
            return error.what();
        }
        return "";
    };
    const std::string why = " is not 1 to 32 bytes of visible ASCII without parentheses";
    EXPECT_EQ(fault("Red Team", ""), "left_team: team name 'Red Team'" + why);
    EXPECT_EQ(fault("Reds", "(Blues)"), "right_team: team name '(Blues)'" + why);
    const std::string long_name(33, 'x');
    EXPECT_EQ(fault("", long_name), "right_team: team name '" + long_name + "'" + why);
    EXPECT_EQ(fault("Reds", "Reds"), "left_team and right_team are both 'Reds'");
    EXPECT_EQ(fault("", ""), "");
}

TEST(Teams, KeepawaySeatsAreCountedAndNamed) {
    Teams teams("Keepers", "Takers", 2, 1, std::nullopt);
    EXPECT_EQ(teams.missing(), "left 1, left 2, right 1");
    ASSERT_TRUE(teams.assign({2, "Keepers"}, 0));
    EXPECT_FALSE(teams.assign({3, "Keepers"}, 0));
    ASSERT_TRUE(teams.assign({0, "Keepers"}, 0));
    EXPECT_FALSE(teams.full());
    ASSERT_TRUE(teams.assign({1, "Takers"}, 0));
    EXPECT_TRUE(teams.full());
}

TEST(Teams, SevenOfATypeAndNoMore) {
    Teams teams("", "", 11, 11, TypeQuotas{});
    for (int unum = 1; unum <= 7; ++unum) ASSERT_TRUE(teams.assign({unum, "Reds"}, 3));
    EXPECT_EQ(teams.assign({8, "Reds"}, 3).error(), "team 'Reds': more than 7 robots of type 3");
    EXPECT_TRUE(teams.assign({8, "Reds"}, 0)) << "the number stays free";
    EXPECT_TRUE(teams.assign({8, "Blues"}, 3)) << "each team has its own quota";
    teams.release({wire::Side::Left, 2});
    EXPECT_TRUE(teams.assign({2, "Reds"}, 3)) << "who leaves makes room";
}

TEST(Teams, NineOfAnyTwoTypesAndNoMore) {
    Teams teams("", "", 11, 11, TypeQuotas{});
    for (int unum = 1; unum <= 9; ++unum) ASSERT_TRUE(teams.assign({unum, "Reds"}, unum % 2));
    EXPECT_EQ(teams.assign({10, "Reds"}, 1).error(),
              "team 'Reds': more than 9 robots of types 0 and 1");
    EXPECT_TRUE(teams.assign({10, "Reds"}, 2));
    EXPECT_TRUE(teams.assign({11, "Reds"}, 2));
}

TEST(Teams, RoomIsKeptForThreeTypes) {
    Teams teams("", "", 11, 11, TypeQuotas{.of_one_type = 11, .of_two_types = 11});
    for (int unum = 1; unum <= 9; ++unum) ASSERT_TRUE(teams.assign({unum, "Reds"}, 0));
    EXPECT_EQ(teams.assign({10, "Reds"}, 0).error(),
              "team 'Reds': no room would be left for 3 different types");
    EXPECT_TRUE(teams.assign({10, "Reds"}, 4));
    EXPECT_FALSE(teams.assign({11, "Reds"}, 4));
    EXPECT_TRUE(teams.assign({11, "Reds"}, 2));
}

}  // namespace
}  // namespace k3d::server::session

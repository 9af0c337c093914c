// SPDX-License-Identifier: BSD-3-Clause
#include "agent/world/player_tracks.h"

#include <gtest/gtest.h>

#include "common/random/stream.h"

namespace k3d::agent::world {
namespace {

struct Trial {
    /// One second and more of a player walking from `start`.
    void walk(const Vec2& start, const Vec2& velocity, double seconds) {
        const double begun = now;
        for (int k = 0; k < static_cast<int>(seconds * 50.0 + 0.5); ++k) {
            now = 0.02 * ++count;
            tracks.predict(now);
            const Vec2 truth = start + velocity * (now - begun);
            if (count % 3 == 0) {
                const Vec2 noise = 0.03 * Vec2(random.normal(), random.normal());
                tracks.see(false, 2, truth + noise, 0.03, false, now);
            }
        }
        tracks.report(now, 1, mates, opponents);
    }

    RandomStream random{1, "test", "players"};
    PlayerTracks tracks{PlayersConfig{}, TakerConfig{}};
    std::vector<Player> mates, opponents;
    int count = 0;
    double now = 0.0;
};

TEST(PlayerTracks, FollowAWalkingPlayer) {
    Trial trial;
    trial.walk({1.0, 1.0}, {0.6, 0.0}, 4.0);
    ASSERT_EQ(trial.opponents.size(), 1u);
    const Player& player = trial.opponents[0];
    EXPECT_EQ(player.unum, 2);
    EXPECT_FALSE(player.mate);
    EXPECT_LT((player.position - Vec2(3.4, 1.0)).norm(), 0.08);
    EXPECT_LT((player.velocity - Vec2(0.6, 0.0)).norm(), 0.3);
}

TEST(PlayerTracks, TheLaggedMeanTrailsByAboutTheTimeConstant) {
    Trial trial;
    trial.walk({-3.0, 0.0}, {0.5, 0.0}, 12.0);
    const Player& player = trial.opponents.at(0);
    const TakerConfig taker;
    // Of a steady walk the discounted mean lags v * lambda.
    EXPECT_NEAR((player.position - player.lagged).x(), 0.5 * taker.lambda, 0.06);
    EXPECT_NEAR((player.position - player.lagged).y(), 0.0, 0.05);
}

TEST(PlayerTracks, APlayerPutElsewhereHasNoSpeedForIt) {
    Trial trial;
    trial.walk({1.0, 1.0}, {0.0, 0.0}, 1.0);
    trial.walk({4.0, -2.0}, {0.0, 0.0}, 0.3);
    const Player& player = trial.opponents.at(0);
    EXPECT_LT((player.position - Vec2(4.0, -2.0)).norm(), 0.1);
    EXPECT_LT(player.velocity.norm(), 0.4);
    EXPECT_LT((player.lagged - player.position).norm(), 0.1);
}

TEST(PlayerTracks, UnseenPlayersSlowDownAndAreForgotten) {
    Trial trial;
    trial.walk({0.0, 0.0}, {0.6, 0.0}, 2.0);
    const PlayersConfig config;
    const double last = trial.now;
    while (trial.now < last + 3.0) trial.tracks.predict(trial.now = 0.02 * ++trial.count);
    trial.tracks.report(trial.now, 1, trial.mates, trial.opponents);
    ASSERT_EQ(trial.opponents.size(), 1u);
    EXPECT_LT(trial.opponents[0].velocity.norm(), 0.05);
    EXPECT_NEAR(trial.opponents[0].position.x(), 1.5, 0.4);
    while (trial.now < last + config.memory + 0.1) {
        trial.tracks.predict(trial.now = 0.02 * ++trial.count);
    }
    trial.tracks.report(trial.now, 1, trial.mates, trial.opponents);
    EXPECT_TRUE(trial.opponents.empty());
}

TEST(PlayerTracks, MatesAreWhereTheySayUnlessSeen) {
    Trial trial;
    trial.tracks.hear(3, {2.0, -1.0}, true, 0.0);
    trial.tracks.report(0.0, 1, trial.mates, trial.opponents);
    ASSERT_EQ(trial.mates.size(), 1u);
    EXPECT_EQ(trial.mates[0].position, Vec2(2.0, -1.0));
    EXPECT_TRUE(trial.mates[0].fallen);
    trial.tracks.see(true, 3, {2.1, -1.0}, 0.03, false, 0.02);
    trial.tracks.report(0.02, 1, trial.mates, trial.opponents);
    const Vec2 seen = trial.mates[0].position;
    EXPECT_FALSE(trial.mates[0].fallen);
    trial.tracks.hear(3, {2.6, -1.0}, false, 0.04);
    trial.tracks.report(0.04, 1, trial.mates, trial.opponents);
    EXPECT_EQ(trial.mates[0].position, seen) << "own eyes are better";
}

TEST(PlayerTracks, OpponentsOutOfSightAreWhereMatesSeeThem) {
    Trial trial;
    trial.tracks.see(false, 2, {2.0, -1.0}, 0.03, false, 0.0);
    trial.tracks.hear_of_opponent(2, {1.0, 1.0}, 0.1);
    trial.tracks.report(0.1, 1, trial.mates, trial.opponents);
    ASSERT_EQ(trial.opponents.size(), 1u);
    EXPECT_EQ(trial.opponents[0].position, Vec2(2.0, -1.0)) << "own eyes are better";
    trial.tracks.hear_of_opponent(2, {1.0, 1.0}, 1.0);
    trial.tracks.hear_of_opponent(1, {3.0, 0.0}, 1.0);
    trial.tracks.report(1.0, 1, trial.mates, trial.opponents);
    ASSERT_EQ(trial.opponents.size(), 2u);
    EXPECT_EQ(trial.opponents[0].position, Vec2(3.0, 0.0));
    EXPECT_EQ(trial.opponents[1].position, Vec2(1.0, 1.0));
    EXPECT_EQ(trial.opponents[1].eyes, 0.0);
    EXPECT_EQ(trial.opponents[1].seen, 1.0);
}

TEST(PlayerTracks, ReportsByNumberWithoutItselfAndIgnoresNumbersOutOfRange) {
    Trial trial;
    for (const int unum : {5, 1, 3, 0, 12, -4}) {
        trial.tracks.see(true, unum, {1.0 * unum, 0.0}, 0.03, false, 0.0);
    }
    trial.tracks.hear(99, {0.0, 0.0}, false, 0.0);
    trial.tracks.report(0.0, 1, trial.mates, trial.opponents);
    ASSERT_EQ(trial.mates.size(), 2u);
    EXPECT_EQ(trial.mates[0].unum, 3);
    EXPECT_EQ(trial.mates[1].unum, 5);
}

}  // namespace
}  // namespace k3d::agent::world

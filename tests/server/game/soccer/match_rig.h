// SPDX-License-Identifier: BSD-3-Clause
// A match without agents: players stand where a test puts them, the ball goes where a test kicks it.
#pragma once

#include <gtest/gtest.h>

#include "common/field/field.h"
#include "server/game/soccer/soccer.h"

namespace k3d::server::game {

class SoccerRig : public ::testing::Test {
  protected:
    /// Three a side, out of the way in their own halves.
    SoccerRig() {
        for (int unum = 1; unum <= 3; ++unum) {
            add(wire::Side::Left, unum, -8.0, -6.0 + 3.0 * unum);
            add(wire::Side::Right, unum, 8.0, -6.0 + 3.0 * unum);
        }
    }
    body::Player& add(wire::Side team, int unum, double x, double y) {
        body::Player& player = scene.add_player(0, {0, 0, 1});
        player.team = team;
        player.unum = unum;
        put(player, x, y);
        return player;
    }
    void put(body::Player& player, double x, double y) { player.robot->place({x, y, 0.386}, 0.0); }
    body::Player& player(wire::Side team, int unum) { return *scene.find(team, unum); }

    void step(int cycles = 1) {
        for (int i = 0; i < cycles; ++i) {
            game.before_step(scene);
            scene.world.step();
            game.after_step(scene);
        }
    }
    void seconds(double s) { step(static_cast<int>(s * 50.0 + 0.5)); }

    /// The player's right foot touches the ball, which lies at rest; one step.
    void touch(wire::Side team, int unum) {
        const Vec3 ball = scene.ball.position();
        put(player(team, unum), ball.x() - 0.13, ball.y() + 0.055);
        step();
    }
    /// Gone from the ball again, so that what follows is no further touch.
    void step_away(wire::Side team, int unum) {
        put(player(team, unum), team == wire::Side::Left ? -8.0 : 8.0, -6.0 + 3.0 * unum);
    }
    void roll(const Vec3& from, const Vec3& velocity) {
        scene.ball.move(from);
        scene.ball.set_velocity(velocity);
    }
    /// In PlayOn, the ball at `spot` having been touched by this player alone.
    void play(wire::Side team, int unum, const Vec2& spot) {
        mode(PlayMode::PlayOn);
        step();
        roll({spot.x(), spot.y(), 0.0402}, Vec3::Zero());
        touch(team, unum);
        step_away(team, unum);
        step();
    }
    void mode(PlayMode next) { game.state().enter(next); }
    PlayMode mode() const { return game.state().mode; }

    body::Scene scene;
    SoccerConfig config;
    Soccer game{config};
};

}  // namespace k3d::server::game

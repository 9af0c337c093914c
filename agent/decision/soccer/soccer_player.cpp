// SPDX-License-Identifier: BSD-3-Clause
// Decides for a soccer player.
#include "agent/decision/soccer/soccer_player.h"

#include <algorithm>
#include <string_view>

#include "agent/decision/soccer/formation.h"
#include "agent/skills/look.h"
#include "common/field/field.h"

namespace k3d::agent::decision {
namespace {

constexpr double kKeepTheJob = 0.5;    // m: a striker's lead over the others
constexpr double kGoalkeeperArea = 3.0;  // m from its place in which it plays the ball

}  // namespace

bool is_theirs(const std::string& play_mode, wire::Side own) {
    const std::string_view other = own == wire::Side::Left ? "ight" : "eft";
    return play_mode.ends_with(other);
}

SoccerPlayer::SoccerPlayer(const PossessionConfig& possession, const skills::SkillConfig& skills,
                           const skills::KickGeometry& kick, RandomStream chances)
    : skills_(skills), possession_(make_possession(possession, skills, kick, chances)) {}

Decision SoccerPlayer::decide(const world::Beliefs& b, const motion::State& body) {
    Decision d;
    const bool was_striker = striker_;
    striker_ = is_striker(b);
    if (striker_ && !was_striker) possession_.invoke();
    if (!striker_ && was_striker) possession_.abort();
    d.account.role = striker_ ? "striker" : "place";
    d.request.body = act(b, body, d.account);
    const bool busy = striker_ && (b.self.pose.position - b.ball.position).norm() < 0.8;
    d.request.head = skills::look(b, body, busy, skills_);
    return d;
}

motion::BodyRequest SoccerPlayer::act(const world::Beliefs& b, const motion::State& body,
                                      Account& account) {
    if (body.activity == motion::Activity::Kicking && swing_) {
        account.skill = "kick";
        return *swing_;
    }
    const bool committed = swing_.has_value();
    swing_.reset();
    if (!b.self.upright) {
        account.skill = "fallen";
        return motion::Stand{};
    }
    if (const auto turn = skills::search_turn(b, skills_)) {
        account.skill = "search";
        return *turn;
    }
    if (!b.self.localised) {
        account.skill = "lost";
        return motion::Stand{};
    }
    return striker_ ? strike(b, body, committed, account) : keep_place(b, account);
}

bool SoccerPlayer::is_striker(const world::Beliefs& b) {
    if (!b.ball.known || is_theirs(b.game.play_mode, b.game.side)) return false;
    const Vec2 ball = b.ball.moving ? b.ball.finish : b.ball.position;
    if (b.game.unum == 1 && (ball - kick_off_place(1)).norm() > kGoalkeeperArea) return false;
    const double mine =
        (b.self.pose.position - ball).norm() - (striker_ ? kKeepTheJob : 0.0);
    return std::none_of(b.mates.begin(), b.mates.end(), [&](const world::Player& mate) {
        return !mate.fallen && mate.unum != 1 && (mate.position - ball).norm() < mine;
    });
}

motion::BodyRequest SoccerPlayer::strike(const world::Beliefs& b, const motion::State& body,
                                         bool committed, Account& account) {
    skills::robots_of(b, skills_.robot_clearance, robots_);
    const PossessionInput input{
        .beliefs = b,
        .body = body,
        .target = Vec2(field::kLength / 2.0 + 0.3, 0.0),
        .pressure = 1.0,
        .may_kick = true,
        .committed = committed,
        .robots = robots_,
    };
    account.target = input.target;
    motion::BodyRequest request = possession_.get_skill(input);
    account.skill = possession_.state_name();
    if (const auto* kick = std::get_if<motion::Kick>(&request)) swing_ = *kick;
    return request;
}

motion::BodyRequest SoccerPlayer::keep_place(const world::Beliefs& b, Account& account) {
    account.skill = "keep_place";
    const Vec2 place = place_in_play(b.game.unum, b.ball.known ? b.ball.position : Vec2(0.0, 0.0));
    account.target = place;
    const double yaw = yaw_of(b.ball.position - b.self.pose.position);
    skills::robots_of(b, skills_.robot_clearance, robots_);
    return go_to_.step(b.self.pose, {place, yaw}, robots_, skills_);
}

}  // namespace k3d::agent::decision

// SPDX-License-Identifier: BSD-3-Clause
// Decides for a taker.
#include "agent/decision/keepaway/taker.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "agent/skills/look.h"

namespace k3d::agent::decision {
namespace {

const world::Player* find(const std::vector<world::Player>& players, int unum) {
    const auto found = std::find_if(players.begin(), players.end(),
                                    [&](const world::Player& p) { return p.unum == unum; });
    return found == players.end() ? nullptr : &*found;
}

}  // namespace

bool PassWatch::update(const world::Beliefs& b, const TakerConfig& c) {
    if (!b.ball.known || b.opponents.empty()) return false;
    const world::Player* nearest = nullptr;
    double shortest = std::numeric_limits<double>::infinity();
    for (const world::Player& keeper : b.opponents) {
        const double distance = (keeper.position - b.ball.finish).norm();
        if (distance < shortest) {
            shortest = distance;
            nearest = &keeper;
        }
    }
    if (k1_ == 0) {
        k1_ = nearest->unum;
        finish_ = b.ball.finish;
        return true;
    }
    if (nearest->unum == k1_ && !b.ball.moving) finish_ = b.ball.finish;
    // A K1 out of sight for long is as good as far away.
    const world::Player* present = find(b.opponents, k1_);
    const double lead = present == nullptr ? std::numeric_limits<double>::infinity()
                                           : (present->position - b.ball.finish).norm() - shortest;
    const bool moved = (b.ball.finish - finish_).norm() >= c.pass_distance;
    if (nearest->unum == k1_ || lead < c.pass_margin || !moved) {
        rival_since_.reset();
        return false;
    }
    if (!rival_since_) rival_since_ = b.now;
    if (b.now - *rival_since_ < c.pass_delay) return false;
    k1_ = nearest->unum;
    finish_ = b.ball.finish;
    rival_since_.reset();
    return true;
}

Taker::Taker(const TakerConfig& config, const skills::SkillConfig& skills, RandomStream choices)
    : greedy_(config.strategy == "greedy"), config_(config), skills_(skills), choices_(choices) {
    skills_.forward_speed = std::min(skills_.forward_speed, config.top_speed);
    robots_.reserve(22);
}

void Taker::forget() {
    watch_ = {};
    go_to_.reset();
    followed_ = 0;
    chaser_ = 0;
}

Decision Taker::decide(const world::Beliefs& b, const motion::State& body) {
    Decision d;
    d.request.head = skills::look(b, body, false, skills_);
    skills::robots_of(b, skills_.robot_clearance, robots_);
    if (!greedy_ && watch_.update(b, config_)) pick(b);
    const bool chase = is_chaser(b);
    d.account.role = chase ? "chaser" : "follower";
    d.account.k1 = watch_.k1();
    if (b.ball.known) d.account.taker_distance = (b.self.pose.position - b.ball.position).norm();

    if (!b.self.upright) {
        d.account.skill = "fallen";
    } else if (const auto turn = skills::search_turn(b, skills_)) {
        d.account.skill = "search";
        d.request.body = *turn;
    } else if (!b.self.localised) {
        d.account.skill = "lost";
    } else if (chase) {
        d.account.skill = "chase";
        d.account.target = b.ball.position;
        d.request.body = skills::walk_onto(b.self.pose, b.ball.position, robots_, skills_);
    } else {
        d.request.body = follow(b, d.account);
    }
    return d;
}

bool Taker::is_chaser(const world::Beliefs& b) {
    if (greedy_ || followed_ == 0) return true;
    int nearest = 0;
    double shortest = std::numeric_limits<double>::infinity();
    const auto consider = [&](int unum, const Vec2& position) {
        const double distance = (position - b.ball.position).norm() -
                                (unum == chaser_ ? config_.chaser_hysteresis : 0.0);
        if (distance < shortest || (distance == shortest && unum < nearest)) {
            shortest = distance;
            nearest = unum;
        }
    };
    consider(b.game.unum, b.self.pose.position);
    for (const world::Player& mate : b.mates)
        consider(mate.unum, mate.position);
    chaser_ = nearest;
    return nearest == b.game.unum;
}

void Taker::pick(const world::Beliefs& b) {
    std::vector<int> others;
    for (const world::Player& keeper : b.opponents)
        if (keeper.unum != watch_.k1()) others.push_back(keeper.unum);
    followed_ = others.empty() ? 0 : others[static_cast<std::size_t>(
                                         choices_.below(static_cast<int>(others.size())))];
}

motion::BodyRequest Taker::follow(const world::Beliefs& b, Account& account) {
    account.skill = "follow";
    account.k2 = followed_;
    const world::Player* keeper = find(b.opponents, followed_);
    if (keeper == nullptr) return motion::Stand{};
    const Vec2 from_keeper = b.self.pose.position - keeper->position;
    const Vec2 goal = from_keeper.norm() > config_.follow_distance
                          ? Vec2(keeper->position + from_keeper.normalized() * config_.follow_distance)
                          : b.self.pose.position;
    account.target = goal;
    const double yaw = yaw_of(b.ball.position - b.self.pose.position);
    return go_to_.step(b.self.pose, {goal, yaw}, robots_, skills_);
}

}  // namespace k3d::agent::decision

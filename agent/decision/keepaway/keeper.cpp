// SPDX-License-Identifier: BSD-3-Clause
// Decides for a keeper.
#include "agent/decision/keepaway/keeper.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "agent/skills/look.h"
#include "agent/talk/slots.h"

namespace k3d::agent::decision {
namespace {

constexpr std::size_t kMostRobots = 22;
constexpr double kEvadeAhead = 0.3;  // s that a taker's motion is looked ahead
constexpr double kEvadeStep = 0.4;   // m

double nearest_taker(const world::Beliefs& b, const Vec2& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const world::Player& taker : b.opponents)
        nearest = std::min(nearest, (taker.position - point).norm());
    return nearest;
}

/// A place to step back to if a taker stands or comes nearer than this.
std::optional<Vec2> away_from_takers(const world::Beliefs& b, double distance) {
    const Vec2 self = b.self.pose.position;
    Vec2 away = Vec2::Zero();
    for (const auto& taker : b.opponents) {
        const Vec2 soon = taker.position + kEvadeAhead * taker.velocity;
        const Vec2 from = self - soon;
        if (from.norm() < distance) away += from.normalized();
    }
    if (away.norm() < 1e-6) return std::nullopt;
    return Vec2(self + kEvadeStep * away.normalized());
}

/// How far beside a taker a shot passes. Who is far can be told by the target's features; who is near
/// will come straight for the ball, and be nearer when it is kicked.
double lane_past(const Vec2& taker, const Vec2& shot, const KeeperConfig& c) {
    const double distance = taker.norm();
    if (distance > c.lane_far || taker.dot(shot) <= 0.0) return std::numeric_limits<double>::infinity();
    const Vec2 met = taker * (std::min(distance, c.lane_near) / std::max(distance, 1e-6));
    return std::abs(shot.x() * met.y() - shot.y() * met.x());
}

/// One of the opponents in view, another in each round of talk.
std::optional<talk::Sighting> opponent_to_tell(const world::Beliefs& b, int keepers) {
    constexpr double kFresh = 0.2;  // s
    const auto in_view = [&](const world::Player& p) { return b.now - p.eyes < kFresh; };
    const auto count = std::ranges::count_if(b.opponents, in_view);
    if (count == 0) return std::nullopt;
    auto skip = talk::round_of(b.now, keepers) % count;
    for (const world::Player& opponent : b.opponents)
        if (in_view(opponent) && skip-- == 0) return talk::Sighting{opponent.unum, opponent.position};
    return std::nullopt;
}

}  // namespace

Vec2 birth_place(int unum, const KeepawayConfig& c) {
    const double angle = kPi / 2.0 + 2.0 * kPi * (unum - 1) / c.keepers;
    return direction(angle) * (0.25 * c.side);
}

Keeper::Keeper(const KeeperSettings& settings, Policy policy, const skills::KickGeometry& kick,
               RandomStream choices)
    : settings_(settings),
      policy_(std::move(policy)),
      kick_(skills::no_farther(kick, settings.keeper.longest_kick)),
      choices_(choices),
      grid_(target_grid(settings.keepaway.side, settings.evaluation)),
      possession_(make_possession(settings.possession, settings.skills, kick_, choices)) {
    situation_.takers.reserve(kMostRobots);
    situation_.receivers.reserve(kMostRobots);
    obstacles_.reserve(kMostRobots + 1);
    in_time_.reserve(grid_.size());
    scored_.reserve(grid_.size());
    if (!settings.keeper.open.empty()) {
        open_.emplace(settings.keeper.open, grid_);
    } else if (policy_.values_places) {
        open_.emplace(*policy_.cost, grid_);
    }
}

Decision Keeper::decide(const world::Beliefs& b, const motion::State& body,
                        std::span<const talk::Report> reports) {
    if (!home_)
        home_ =
            b.self.localised ? b.self.pose.position : birth_place(b.game.unum, settings_.keepaway);

    Assignment part = roles_.update(b, reports, settings_.keeper);
    Decision d;
    d.account.role = name_of(part.role);
    d.account.k1 = part.k1;
    if (const double near = nearest_taker(b, b.ball.position); std::isfinite(near))
        d.account.taker_distance = near;

    const bool is_k1 = part.role == Role::K1;
    if (is_k1 && !was_k1_) possession_.invoke();
    if (!is_k1 && was_k1_) possession_.abort();
    if (is_k1 != was_k1_ || body.kick_done) target_.reset();
    was_k1_ = is_k1;

    d.request.body = act(b, body, part, d.account);
    const bool busy = is_k1 && (b.self.pose.position - b.ball.position).norm() < 0.8;
    d.request.head = skills::look(b, body, busy, settings_.skills);

    talk::Message m;
    m.unum = b.game.unum;
    m.position = b.self.pose.position;
    m.fallen = !b.self.upright;
    if (b.ball.known && b.now - b.ball.seen < 0.5) {
        m.ball = b.ball.position;
        m.ball_velocity = b.ball.velocity;
    }
    m.claims_k1 = is_k1;
    if (is_k1 && target_) m.target = target_;
    m.k2 = is_k1 ? k2_ : 0;
    m.opponent = opponent_to_tell(b, settings_.keepaway.keepers);
    d.say = m;
    return d;
}

void Keeper::forget() {
    roles_ = {};
    if (was_k1_) possession_.abort();
    was_k1_ = false;
    go_to_.reset();
    if (open_) open_->forget();
    home_.reset();
    target_.reset();
    swing_.reset();
    k2_ = 0;
}

motion::BodyRequest Keeper::act(const world::Beliefs& b, const motion::State& body,
                                const Assignment& part, Account& account) {
    if (body.activity == motion::Activity::Kicking && swing_) {
        account.skill = "kick";
        account.target = target_;
        return *swing_;
    }
    const bool committed = swing_.has_value();
    swing_.reset();
    if (policy_.kind == Policy::Kind::Still) {
        account.skill = "still";
        return motion::Stand{};
    }
    if (!b.self.upright) {
        account.skill = "fallen";
        return motion::Stand{};
    }
    if (const auto turn = skills::search_turn(b, settings_.skills)) {
        account.skill = "search";
        return *turn;
    }
    if (!b.self.localised) {  // the head looks for landmarks meanwhile
        account.skill = "lost";
        return motion::Stand{};
    }
    switch (part.role) {
        case Role::K1: return act_k1(b, body, committed, account);
        case Role::K2:
            account.skill = "go_to_target";
            account.target = part.target;
            return walk_and_watch(b, *part.target);
        case Role::K3: break;
    }
    // A taker that comes for the ball just kicked runs its kicker down, who has time to step aside.
    const auto aside = away_from_takers(b, settings_.keeper.evade_distance);
    account.skill = aside ? "step_aside" : open_ ? "get_open" : "go_home";
    account.target = aside ? *aside : place_of_k3(b, part);
    return walk_and_watch(b, *account.target);
}

Vec2 Keeper::place_of_k3(const world::Beliefs& b, const Assignment& part) {
    if (!open_) return *home_;
    situation_.takers.clear();
    situation_.receivers.assign(1, b.self.pose.position);
    situation_.ball = part.target.value_or(b.ball.finish);
    for (const auto& taker : b.opponents)
        situation_.takers.push_back({taker.position, taker.lagged});
    return open_->choose(situation_, settings_.evaluation.ideal_pass_m);
}

motion::BodyRequest Keeper::act_k1(const world::Beliefs& b, const motion::State& body,
                                   bool committed, Account& account) {
    choose_target(b, account);
    const KeeperConfig& c = settings_.keeper;
    const double near = nearest_taker(b, b.ball.position);
    const double pressure = std::clamp(
        (c.pressure_far - near) / std::max(c.pressure_far - c.pressure_near, 1e-6), 0.0, 1.0);
    skills::robots_of(b, settings_.skills.robot_clearance, obstacles_);
    const PossessionInput input{
        .beliefs = b,
        .body = body,
        .target = *target_,
        .pressure = pressure,
        // HOLD or kick: the one fixed decision of paper 5.1.
        .may_kick = near <= c.hold_threshold && policy_.kind != Policy::Kind::Hold,
        .committed = committed,
        .half_area = settings_.keepaway.side / 2.0 - c.stance_margin,
        .robots = obstacles_,
    };
    motion::BodyRequest request = possession_.get_skill(input);
    account.skill = possession_.state_name();
    if (auto* kick = std::get_if<motion::Kick>(&request)) {
        kick->distance = std::min(kick->distance, c.longest_kick);
        swing_ = *kick;
    }
    return request;
}

void Keeper::choose_target(const world::Beliefs& b, Account& account) {
    // A ball on its way is judged where it will be when it can be kicked.
    PassSituation& situation = situation_;
    situation.takers.clear();
    situation.receivers.clear();
    situation.ball = b.ball.moving ? b.ball.finish : b.ball.position;
    for (const auto& taker : b.opponents) situation.takers.push_back({taker.position, taker.lagged});
    for (const auto& mate : b.mates) situation.receivers.push_back(mate.position);

    const KeeperConfig& c = settings_.keeper;
    const auto room = [&](const Vec2& p) { return room_for(p, situation.ball); };
    const auto ready = [&](const Vec2& p) { return time_to_kick(p, b.self.pose, situation.ball); };
    const Haste haste{time_until_taker(situation), c.patience_s, std::ref(ready)};
    targets_in_time(grid_, std::ref(room), haste, in_time_);
    const auto& targets = in_time_.empty() ? grid_ : in_time_;
    if (policy_.kind == Policy::Kind::Random) {
        // Among the same targets as any other policy: it differs by the choice alone. (If none is in time,
        // the others take the roomiest, this one any.)
        const bool stands =
            target_ && std::find(targets.begin(), targets.end(), *target_) != targets.end();
        const int count = static_cast<int>(targets.size());
        if (!stands) target_ = targets[static_cast<std::size_t>(choices_.below(count))];
    } else {
        const double near = nearest_taker(b, b.ball.position);
        const double keep = near <= c.hold_threshold ? c.commit_margin : c.target_margin;
        const Target best = best_target(targets, situation, policy_, settings_.evaluation,
                                        std::ref(room), target_, keep, &scored_);
        account.scored = scored_;
        target_ = best.point;
        account.cost = best.cost;
    }
    k2_ = choose_k2(*target_, b.mates, k2_, settings_.keeper);
    account.target = target_;
    account.k2 = k2_;
}

double Keeper::time_until_taker(const PassSituation& situation) const {
    double near = std::numeric_limits<double>::infinity();
    for (const auto& taker : situation.takers)
        near = std::min(near, (taker.position - situation.ball).norm());
    return (near - settings_.keeper.taker_reach) / settings_.keeper.taker_speed;
}

double Keeper::time_to_kick(const Vec2& target, const Pose2& self, const Vec2& ball) const {
    const skills::Stance stance =
        skills::soonest_stance(self, ball, target, -1, kick_, settings_.skills);
    const bool kept = target_ && (*target_ - target).norm() < 1e-6;
    return stance.time + settings_.keeper.kick_time_s - (kept ? settings_.keeper.change_s : 0.0);
}

double Keeper::room_for(const Vec2& target, const Vec2& ball) const {
    const KeeperConfig& c = settings_.keeper;
    const double half = settings_.keepaway.side / 2.0;
    const Vec2 shot = target - ball;
    const double yaw = yaw_of(shot);
    const double reach = kick_.reach(shot.norm());
    const Vec2 stance = kick_.stand_pose(0, ball, yaw).position;
    const Vec2 landing = ball + direction(yaw) * reach;
    double lane = std::numeric_limits<double>::infinity();
    for (const auto& taker : situation_.takers)
        lane = std::min(lane, lane_past(taker.position - ball, direction(yaw), c));
    return std::min({lane - c.lane_margin, half - c.stance_margin - stance.cwiseAbs().maxCoeff(),
                     half - c.landing_margin - landing.cwiseAbs().maxCoeff(),
                     c.landing_error - std::abs(reach - shot.norm())});
}

motion::BodyRequest Keeper::walk_and_watch(const world::Beliefs& b, const Vec2& place) {
    skills::robots_of(b, settings_.skills.robot_clearance, obstacles_);
    if (b.ball.known) obstacles_.push_back({b.ball.position, settings_.skills.ball_clearance});
    const double half = settings_.keepaway.side / 2.0 - settings_.keeper.area_margin;
    const Vec2 goal = within_square(place, half);
    const double yaw = yaw_of(b.ball.position - b.self.pose.position);
    return go_to_.step(b.self.pose, {goal, yaw}, obstacles_, settings_.skills);
}

}  // namespace k3d::agent::decision

// SPDX-License-Identifier: BSD-3-Clause
// One skill at a time.
#include "agent/decision/drill/drill.h"

#include <array>

#include "agent/skills/look.h"

namespace k3d::agent::decision {
namespace {

constexpr double kToppleRate = 2.5;  // rad/s of the ankles: over within half a second

motion::Topple topple_to(const std::string& way) {
    if (way == "front") return {kToppleRate, 0.0};
    if (way == "back") return {-kToppleRate, 0.0};
    return {0.0, way == "left" ? kToppleRate : -kToppleRate};
}

}  // namespace

Drill::Drill(const DrillConfig& config, const PossessionConfig& possession,
             const skills::SkillConfig& skills, const skills::KickGeometry& kick,
             RandomStream places)
    : config_(config),
      skills_(skills),
      possession_(make_possession(possession, skills, kick, places)),
      places_(places) {}

Decision Drill::decide(const world::Beliefs& b, const motion::State& body) {
    Decision d;
    d.account.role = "drill";
    d.account.skill = config_.task;
    const bool kicks = config_.task == "kick" || config_.task == "possess";
    const bool near = (b.self.pose.position - b.ball.position).norm() < 0.8;
    d.request.body = act(b, body, d.account);
    d.request.head = skills::look(b, body, kicks && near, skills_);
    return d;
}

motion::BodyRequest Drill::act(const world::Beliefs& b, const motion::State& body,
                               Account& account) {
    if (config_.task == "walk") return motion::Walk{config_.forward, config_.left, config_.turn};
    if (config_.task == "get_up") return fall(body);
    if (config_.task == "stand" || !b.self.upright) return motion::Stand{};
    if (config_.task == "go_to") return go_to(b, body, account);
    return kick(b, body, account);
}

motion::BodyRequest Drill::go_to(const world::Beliefs& b, const motion::State& body,
                                 Account& account) {
    if (config_.fall_every > 0.0) {
        if (fall_at_ == 0.0 || body.falls > falls_) {
            fall_at_ = b.now + config_.fall_every;
            falls_ = body.falls;
        }
        constexpr std::array<const char*, 4> kWays{"front", "back", "left", "right"};
        if (b.now >= fall_at_) return topple_to(kWays[static_cast<std::size_t>(falls_) % kWays.size()]);
    }
    if (b.now >= place_until_) {
        const double half = config_.half_area;
        place_.position = {config_.centre_x + places_.uniform(-half, half),
                           config_.centre_y + places_.uniform(-half, half)};
        place_.yaw = places_.uniform(-kPi, kPi);
        place_until_ = b.now + places_.uniform(config_.shortest, config_.longest);
        go_to_.reset();
    }
    account.target = place_.position;
    if (!b.self.localised) return motion::Stand{};
    return go_to_.step(b.self.pose, place_, {}, skills_);
}

motion::BodyRequest Drill::kick(const world::Beliefs& b, const motion::State& body,
                                Account& account) {
    const Vec2 target(config_.target_x, config_.target_y);
    account.target = target;
    if (body.activity == motion::Activity::Kicking && swing_) return *swing_;
    done_ = done_ || body.kick_done;
    const bool committed = swing_.has_value();
    swing_.reset();
    if (done_) return motion::Stand{};
    if (const auto turn = skills::search_turn(b, skills_)) return *turn;
    if (!b.self.localised || !b.ball.known) return motion::Stand{};
    const PossessionInput input{.beliefs = b,
                                .body = body,
                                .target = target,
                                .may_kick = config_.task == "kick",
                                .committed = committed,
                                .robots = {}};
    const motion::BodyRequest request = possession_.get_skill(input);
    account.skill = possession_.state_name();
    if (const auto* swing = std::get_if<motion::Kick>(&request)) swing_ = *swing;
    return request;
}

motion::BodyRequest Drill::fall(const motion::State& body) {
    done_ = done_ || body.falls > 0;
    if (done_) return motion::Stand{};
    return topple_to(config_.fall);
}

}  // namespace k3d::agent::decision

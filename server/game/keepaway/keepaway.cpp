// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/keepaway/keepaway.h"

#include <cmath>

#include "common/field/field.h"

namespace k3d::server::game {

namespace {

constexpr double kStrayDistance = 0.5;  // m from its start spot, before kick-off
constexpr double kDropHeight = 0.001;   // m, soles above the ground when placed

const Pose2& start_pose(const Start& start, const body::Player& player) {
    const auto& poses = player.team == wire::Side::Left ? start.keepers : start.takers;
    return poses.at(static_cast<std::size_t>(player.unum - 1));
}

void place(body::Player& player, const Pose2& pose) {
    const double height = player.robot->model().standing_height + kDropHeight;
    player.robot->place({pose.position.x(), pose.position.y(), height}, pose.yaw);
}

bool in_torso_column(nao::Part part) {
    return part == nao::Part::Torso || part == nao::Part::Neck || part == nao::Part::Head;
}

}  // namespace

Keepaway::Keepaway(const KeepawayConfig& config, std::uint64_t seed, body::Scene& scene)
    : config_(config),
      seed_(seed),
      start_(make_start(config, RandomStream(seed, "keepaway", "start"))),
      log_((place_everybody(scene), scene)) {}

void Keepaway::place_everybody(body::Scene& scene) {
    for (const auto& player : scene.players) place(*player, start_pose(start_, *player));
    scene.ball.move({start_.ball.x(), start_.ball.y(), field::kBallRadius});
    scene.ball.set_velocity(Vec3::Zero());
}

void Keepaway::return_strayed(body::Scene& scene) {
    for (const auto& player : scene.players) {
        const Pose2& pose = start_pose(start_, *player);
        const Vec2 away = player->robot->torso_position().head<2>() - pose.position;
        if (away.norm() > kStrayDistance) place(*player, pose);
    }
}

void Keepaway::before_step(body::Scene& scene) {
    if (state_.mode != PlayMode::BeforeKickOff) return;
    return_strayed(scene);
    scene.ball.move({start_.ball.x(), start_.ball.y(), field::kBallRadius});
    scene.ball.set_velocity(Vec3::Zero());
}

void Keepaway::after_step(body::Scene& scene) {
    state_.advance();
    if (state_.mode == PlayMode::BeforeKickOff &&
        state_.mode_time >= config_.before_kick_off - 1e-9) {
        state_.enter(PlayMode::PlayOn);
        log_ = PlayerLog(scene);
        return;
    }
    if (state_.mode != PlayMode::PlayOn) return;
    count(scene);
    if (const auto reason = broken_rule(scene)) {
        end(episode::Status::Finished, *reason);
    } else if (state_.mode_time >= config_.limit - 1e-9) {
        end(episode::Status::Truncated, "time_limit");
    }
}

void Keepaway::count(const body::Scene& scene) {
    std::vector<int> keepers;
    std::vector<int> takers;
    for (const int id : ball_touchers(scene.world.contacts())) {
        for (const auto& player : scene.players) {
            if (player->id == id) (player->team == wire::Side::Left ? keepers : takers).push_back(id);
        }
    }
    passes_.update(keepers, takers, scene.ball.position().head<2>());
    log_.update(scene);
}

std::optional<std::string> Keepaway::broken_rule(const body::Scene& scene) const {
    if (taker_at_ball(scene)) return "taker_reached_ball";
    if (outside(scene.ball.position())) return "ball_out";
    for (const auto& player : scene.players) {
        if (player->team == wire::Side::Left && outside(player->robot->torso_position())) {
            return "keeper_out";
        }
    }
    return std::nullopt;
}

bool Keepaway::taker_at_ball(const body::Scene& scene) const {
    const bool any_part = config_.taker_part == "any_part";
    const Vec2 ball = scene.ball.position().head<2>();
    for (const auto& player : scene.players) {
        if (player->team != wire::Side::Right) continue;
        const auto& bodies = player->robot->model().bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (!any_part && !in_torso_column(bodies[i].part)) continue;
            const Vec2 part = player->robot->position(i).head<2>();
            if ((part - ball).norm() < config_.taker_reach) return true;
        }
    }
    return false;
}

bool Keepaway::outside(const Vec3& point) const {
    const double half = config_.side / 2.0;
    return std::abs(point.x()) > half || std::abs(point.y()) > half;
}

void Keepaway::abort(episode::Status status, const std::string& reason) { end(status, reason); }

void Keepaway::end(episode::Status status, const std::string& reason) {
    if (over()) return;
    status_ = status;
    reason_ = reason;
    state_.enter(PlayMode::GameOver);
}

episode::Result Keepaway::result() const {
    episode::Result result;
    result.game = "keepaway";
    result.seed = seed_;
    result.status = status_;
    result.reason = reason_;
    result.hold_time_s = std::round(state_.time * 50.0) / 50.0;  // whole cycles
    result.kicks = passes_.kicks();
    result.passes_completed = passes_.passes();
    result.players = log_.results(result.hold_time_s);
    result.metrics = {{"side_m", config_.side}};
    return result;
}

}  // namespace k3d::server::game

// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/keepaway/keepaway.h"

#include <cmath>

#include "common/field/field.h"
#include "server/game/keepaway/league_rules.h"
#include "server/game/keepaway/paper_rules.h"

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
        state_.mode_time >= config_.before_kick_off - kTimeSlack) {
        state_.enter(PlayMode::PlayOn);
        log_ = PlayerLog(scene);
        return;
    }
    if (state_.mode != PlayMode::PlayOn) return;
    count(scene);
    if (const auto reason = broken_rule(scene)) {
        end(episode::Status::Finished, *reason);
    } else if (state_.mode_time >= config_.limit - kTimeSlack) {
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
    return config_.league() ? broken_league_rule(config_, scene, state_.time)
                            : broken_paper_rule(config_, scene);
}

double Keepaway::side() const {
    return config_.league() ? league_side(config_, state_.time) : config_.side;
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
    result.metrics = {{"side_m", side()}};
    return result;
}

}  // namespace k3d::server::game

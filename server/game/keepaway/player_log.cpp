// SPDX-License-Identifier: BSD-3-Clause
#include "server/game/keepaway/player_log.h"

namespace k3d::server::game {

namespace {
constexpr int kPathSampleCycles = 25;  // coarse enough that a walk's sway adds no path
constexpr double kDownTilt = 0.5;      // cosine of the torso's tilt: 60 degrees
constexpr double kUpTilt = 0.85;

Vec2 on_ground(const body::Player& player) { return player.robot->torso_position().head<2>(); }

double uprightness(const body::Player& player) {
    return (player.robot->torso_rotation() * Vec3::UnitZ()).z();
}
}  // namespace

PlayerLog::PlayerLog(const body::Scene& scene) {
    for (const auto& player : scene.players) {
        episode::PlayerResult result;
        result.team = wire::side_name(player->team);
        result.unum = player->unum;
        entries_.push_back({player->id, result, on_ground(*player)});
    }
}

void PlayerLog::update(const body::Scene& scene) {
    const bool sample = ++cycles_ % kPathSampleCycles == 0;
    for (Entry& entry : entries_) {
        const body::Player* player = scene.find(entry.id);
        if (player == nullptr) continue;  // taken off the field: its figures stay as they are
        const double up = uprightness(*player);
        if (!entry.down && up < kDownTilt) {
            entry.down = true;
            ++entry.result.falls;
        } else if (entry.down && up > kUpTilt) {
            entry.down = false;
        }
        if (!sample) continue;
        const Vec2 now = on_ground(*player);
        entry.result.distance_m += (now - entry.sampled).norm();
        entry.sampled = now;
    }
}

std::vector<episode::PlayerResult> PlayerLog::results(double hold_time_s) const {
    std::vector<episode::PlayerResult> all;
    for (const Entry& entry : entries_) {
        all.push_back(entry.result);
        if (hold_time_s > 0.0) all.back().mean_speed = entry.result.distance_m / hold_time_s;
    }
    return all;
}

}  // namespace k3d::server::game

// SPDX-License-Identifier: BSD-3-Clause
#include "agent/world/player_tracks.h"

namespace k3d::agent::world {

namespace {

constexpr double kInView = 0.2;        // s: seen this lately, a player is taken to walk on ...
constexpr double kUnseenDecay = 2.0;   // 1/s: ... later to slow down, since nobody walks for ever
constexpr double kStartSpeedSd = 0.5;  // m/s
constexpr double kHeardSd = 0.15;      // m: message grid and delay
constexpr double kGate = 25.0;         // squared deviations; beyond, the player was moved
constexpr double kJump = 0.5;          // m: a smaller surprise is no move

bool is_unum(int unum) {
    return unum >= 1 && unum <= wire::kMaxUnum;
}

}  // namespace

PlayerTracks::PlayerTracks(const PlayersConfig& players, const TakerConfig& taker)
    : players_(players), taker_(taker) {}

void PlayerTracks::reset() {
    *this = PlayerTracks(players_, taker_);
}

void PlayerTracks::predict(double now) {
    const double dt = now - now_;
    now_ = now;
    if (dt <= 0.0 || dt > players_.memory) return;
    for (Team& team : teams_) {
        for (Track& track : team) {
            const double unseen = now - track.seen;
            if (unseen > players_.memory) continue;
            track.filter.predict(dt, unseen > kInView ? kUnseenDecay : 0.0,
                                 players_.acceleration_sd);
        }
    }
}

void PlayerTracks::measure(Track& track, const Vec2& position, double sd, double now) {
    const bool forgotten = now - track.seen > players_.memory;
    const bool moved = track.filter.surprise(position, sd) > kGate &&
                       (position - track.filter.position()).norm() > kJump;
    if (forgotten || moved) {
        track.filter.start(position, sd, Vec2::Zero(), kStartSpeedSd);
        track.mean_sum = Vec2::Zero();
        track.mean_weight = 0.0;
    } else {
        track.filter.measure(position, sd);
    }
    const double kept = std::exp(-std::max(0.0, now - track.mean_time) / taker_.lambda);
    track.mean_sum = kept * track.mean_sum + track.filter.position();
    track.mean_weight = kept * track.mean_weight + 1.0;
    track.mean_time = track.seen = now;
}

void PlayerTracks::see(bool mate, int unum, const Vec2& position, double sd,
                       std::optional<bool> fallen, double now) {
    if (!is_unum(unum)) return;
    Track& track = teams_[mate ? 1 : 0][static_cast<std::size_t>(unum - 1)];
    measure(track, position, sd, now);
    track.eyes = now;
    if (fallen) track.fallen = *fallen;
}

void PlayerTracks::hear(int unum, const Vec2& position, bool fallen, double now) {
    if (!is_unum(unum)) return;
    Track& track = teams_[1][static_cast<std::size_t>(unum - 1)];
    if (now - track.eyes > players_.hear_after) measure(track, position, kHeardSd, now);
    track.seen = now;
    track.fallen = fallen;
}

void PlayerTracks::hear_of_opponent(int unum, const Vec2& position, double now) {
    if (!is_unum(unum)) return;
    Track& track = teams_[0][static_cast<std::size_t>(unum - 1)];
    if (now - track.eyes > players_.hear_after) measure(track, position, kHeardSd, now);
}

void PlayerTracks::reseat(const Pose2& from, const Pose2& to) {
    for (Team& team : teams_) {
        for (Track& track : team) {
            track.filter.reseat(from, to);
            if (track.mean_weight <= 0.0) continue;
            const Vec2 mean = track.mean_sum / track.mean_weight;
            track.mean_sum = to.to_global(from.to_local(mean)) * track.mean_weight;
        }
    }
}

void PlayerTracks::report_team(const Team& team, bool mate, double now, int left_out,
                               std::vector<Player>& players) const {
    players.clear();
    players.reserve(wire::kMaxUnum);
    for (int unum = 1; unum <= wire::kMaxUnum; ++unum) {
        const Track& track = team[static_cast<std::size_t>(unum - 1)];
        if (unum == left_out || now - track.seen > players_.memory) continue;
        const Vec2 lagged = track.mean_weight > 0.0 ? Vec2(track.mean_sum / track.mean_weight)
                                                    : track.filter.position();
        players.push_back({unum, mate, track.seen, track.eyes, track.filter.position(),
                           track.filter.velocity(), lagged, track.fallen});
    }
}

void PlayerTracks::report(double now, int own_unum, std::vector<Player>& mates,
                          std::vector<Player>& opponents) const {
    report_team(teams_[1], true, now, own_unum, mates);
    report_team(teams_[0], false, now, 0, opponents);
}

}  // namespace k3d::agent::world

// SPDX-License-Identifier: BSD-3-Clause
// EpisodeResult: one JSON object a line, written by the server and read by the optimizer.
//
// The server fills everything but `attempts`, which only the keepers' telemetry knows.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace k3d::episode {

inline constexpr int kSchemaVersion = 1;

/// finished: by a rule of the game; truncated: by the time limit; diverged: the physics broke;
/// agent_lost: a player died or hung, or a trainer killed it. Only the first two may become a
/// fitness.
enum class Status { Finished, Truncated, Diverged, AgentLost };

struct PlayerResult {
    std::string team;         ///< "left" or "right"
    int unum = 0;
    int falls = 0;            ///< torso tilted beyond 60 degrees, counted once until upright again
    double distance_m = 0.0;  ///< path of the torso on the ground during PlayOn
    double mean_speed = 0.0;  ///< m/s over PlayOn
};

struct Result {
    int schema = kSchemaVersion;
    std::string game;  ///< "keepaway", "soccer", or "drill_" and a drill's name
    std::uint64_t seed = 0;
    Status status = Status::Finished;
    std::string reason;            ///< taker_reached_ball, ball_out, keeper_out, time_limit, ...
    double hold_time_s = 0.0;      ///< simulated time in PlayOn
    std::optional<int> attempts;   ///< kick motions begun by keepers (the paper's passes)
    int kicks = 0;                 ///< keeper-ball contacts after which the ball left
    int passes_completed = 0;      ///< kicks whose next toucher was another keeper, ball moved >= 1.5 m
    std::vector<PlayerResult> players;
    std::map<std::string, double> metrics;
    std::string state_hash;        ///< 16 hex digits over every cycle's full physics state
    std::string code_version;
};

class ResultError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::string_view name(Status status);
std::string to_line(const Result& result);       ///< one line, no newline at its end
Result from_line(std::string_view line);         ///< throws ResultError naming the bad field

}  // namespace k3d::episode

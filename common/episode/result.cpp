// SPDX-License-Identifier: BSD-3-Clause
// EpisodeResult <-> JSON.
#include "common/episode/result.h"

#include <array>
#include <nlohmann/json.hpp>

namespace k3d::episode {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> kNames{"finished", "truncated", "diverged",
                                                 "agent_lost"};

Status status_of(const std::string& text) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (kNames[i] == text) return static_cast<Status>(i);
    }
    throw ResultError("episode result: status '" + text + "' is none of finished, truncated, "
                      "diverged, agent_lost");
}

Json player_json(const PlayerResult& p) {
    return {{"team", p.team},
            {"unum", p.unum},
            {"falls", p.falls},
            {"distance_m", p.distance_m},
            {"mean_speed", p.mean_speed}};
}

PlayerResult player_of(const Json& j) {
    return {j.at("team").get<std::string>(), j.at("unum").get<int>(), j.at("falls").get<int>(),
            j.at("distance_m").get<double>(), j.at("mean_speed").get<double>()};
}

}  // namespace

std::string_view name(Status status) { return kNames[static_cast<std::size_t>(status)]; }

std::string to_line(const Result& r) {
    Json players = Json::array();
    for (const PlayerResult& p : r.players) players.push_back(player_json(p));
    const Json j{{"schema", r.schema},
                 {"game", r.game},
                 {"seed", r.seed},
                 {"status", name(r.status)},
                 {"reason", r.reason},
                 {"hold_time_s", r.hold_time_s},
                 {"attempts", r.attempts ? Json(*r.attempts) : Json(nullptr)},
                 {"kicks", r.kicks},
                 {"passes_completed", r.passes_completed},
                 {"players", players},
                 {"metrics", r.metrics},
                 {"state_hash", r.state_hash},
                 {"code_version", r.code_version}};
    return j.dump();
}

Result from_line(std::string_view line) {
    try {
        const Json j = Json::parse(line);
        Result r;
        r.schema = j.at("schema").get<int>();
        if (r.schema != kSchemaVersion) {
            throw ResultError("episode result: schema " + std::to_string(r.schema) +
                              ", this program reads " + std::to_string(kSchemaVersion));
        }
        r.game = j.at("game").get<std::string>();
        r.seed = j.at("seed").get<std::uint64_t>();
        r.status = status_of(j.at("status").get<std::string>());
        r.reason = j.at("reason").get<std::string>();
        r.hold_time_s = j.at("hold_time_s").get<double>();
        if (!j.at("attempts").is_null()) r.attempts = j.at("attempts").get<int>();
        r.kicks = j.at("kicks").get<int>();
        r.passes_completed = j.at("passes_completed").get<int>();
        for (const Json& p : j.at("players")) r.players.push_back(player_of(p));
        r.metrics = j.at("metrics").get<std::map<std::string, double>>();
        r.state_hash = j.at("state_hash").get<std::string>();
        r.code_version = j.at("code_version").get<std::string>();
        return r;
    } catch (const nlohmann::json::exception& error) {
        throw ResultError(std::string("episode result: ") + error.what());
    }
}

}  // namespace k3d::episode

// SPDX-License-Identifier: BSD-3-Clause
// EpisodeResult <-> JSON.
#include "common/episode/result.h"

#include <array>
#include <concepts>
#include <nlohmann/json.hpp>
#include <utility>

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

template <class Value>
constexpr std::string_view kWanted = "a text";
template <>
constexpr std::string_view kWanted<double> = "a number";
template <>
constexpr std::string_view kWanted<int> = "a whole number of 32 bits";
template <>
constexpr std::string_view kWanted<std::uint64_t> = "a whole number from 0 to 2^64 - 1";

/// Whether the conversion keeps the value: nlohmann's makes 3 of 3.7, 1 of true, 2^64 - 1 of -1.
template <class Value>
bool is(const Json& j) {
    if constexpr (std::integral<Value>) {
        return j.is_number_unsigned()
                   ? std::in_range<Value>(j.get<std::uint64_t>())
                   : j.is_number_integer() && std::in_range<Value>(j.get<std::int64_t>());
    } else if constexpr (std::floating_point<Value>) {
        return j.is_number();
    } else {
        return j.is_string();
    }
}

template <class Value>
Value value_of(const Json& j, std::string_view name) {
    if (is<Value>(j)) return j.get<Value>();
    throw ResultError("episode result: " + std::string(name) + " is " + j.dump(-1, ' ', true) +
                      ", not " + std::string(kWanted<Value>));
}

const Json& member(const Json& object, const char* key) {
    if (!object.is_object()) {
        throw ResultError("episode result: " + object.dump(-1, ' ', true) + " is no object");
    }
    const auto found = object.find(key);
    if (found != object.end()) return *found;
    throw ResultError("episode result: no " + std::string(key));
}

template <class Value>
Value read(const Json& object, const char* key) {
    return value_of<Value>(member(object, key), key);
}

PlayerResult player_of(const Json& j) {
    return {read<std::string>(j, "team"), read<int>(j, "unum"), read<int>(j, "falls"),
            read<double>(j, "distance_m"), read<double>(j, "mean_speed")};
}

std::vector<PlayerResult> players_of(const Json& list) {
    if (!list.is_array()) throw ResultError("episode result: players is no list");
    std::vector<PlayerResult> players;
    for (const Json& player : list) players.push_back(player_of(player));
    return players;
}

std::map<std::string, double> metrics_of(const Json& object) {
    if (!object.is_object()) throw ResultError("episode result: metrics is no object");
    std::map<std::string, double> metrics;
    for (const auto& [name, value] : object.items()) {
        metrics[name] = value_of<double>(value, "metrics." + name);
    }
    return metrics;
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
        r.schema = read<int>(j, "schema");
        if (r.schema != kSchemaVersion) {
            throw ResultError("episode result: schema " + std::to_string(r.schema) +
                              ", this program reads " + std::to_string(kSchemaVersion));
        }
        r.game = read<std::string>(j, "game");
        r.seed = read<std::uint64_t>(j, "seed");
        r.status = status_of(read<std::string>(j, "status"));
        r.reason = read<std::string>(j, "reason");
        r.hold_time_s = read<double>(j, "hold_time_s");
        if (!member(j, "attempts").is_null()) r.attempts = read<int>(j, "attempts");
        r.kicks = read<int>(j, "kicks");
        r.passes_completed = read<int>(j, "passes_completed");
        r.players = players_of(member(j, "players"));
        r.metrics = metrics_of(member(j, "metrics"));
        r.state_hash = read<std::string>(j, "state_hash");
        r.code_version = read<std::string>(j, "code_version");
        return r;
    } catch (const nlohmann::json::exception& error) {
        throw ResultError(std::string("episode result: ") + error.what());
    }
}

}  // namespace k3d::episode

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/episode/telemetry.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace k3d::optimizer::episode {

namespace {

constexpr const char* kKickAttempt = "kick_attempt";

bool is_attempt(const std::string& line) {
    const nlohmann::json record = nlohmann::json::parse(line, nullptr, false);
    if (!record.is_object()) throw std::invalid_argument("not a JSON object");
    if (!record.contains("time") || !record["time"].is_number()) {
        throw std::invalid_argument("no numeric 'time'");
    }
    return record.value("event", nlohmann::json()) == kKickAttempt;
}

}  // namespace

int count_attempts(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw TelemetryError("no telemetry: " + file);
    int attempts = 0;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        try {
            if (in.eof()) throw std::invalid_argument("the line has no end");
            if (is_attempt(line)) ++attempts;
        } catch (const std::invalid_argument& error) {
            throw TelemetryError(fmt::format("{}:{}: {}", file, number, error.what()));
        }
    }
    return attempts;
}

}  // namespace k3d::optimizer::episode

// SPDX-License-Identifier: BSD-3-Clause
// Turns beliefs and decisions into JSON lines.
#include "agent/action/telemetry.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace k3d::agent::action {
namespace {

using json = nlohmann::ordered_json;

/// Millimetres are plenty, and keep the lines short.
double rounded(double value) { return std::round(value * 1000.0) / 1000.0; }

/// Team frame -> absolute field frame.
struct Absolute {
    double sign;

    json point(const Vec2& p) const {
        return {{"x", rounded(sign * p.x())}, {"y", rounded(sign * p.y())}};
    }
    double yaw_deg(double yaw) const {
        return rounded(wrap_degrees(degrees(yaw) + (sign < 0.0 ? 180.0 : 0.0)));
    }
};

const char* name_of(motion::Activity activity) {
    switch (activity) {
        case motion::Activity::Standing: return "standing";
        case motion::Activity::Walking: return "walking";
        case motion::Activity::Kicking: return "kicking";
        case motion::Activity::Falling: return "falling";
        case motion::Activity::GettingUp: return "getting_up";
    }
    return "?";
}

json pose(const world::Self& self, const Absolute& absolute) {
    json out = absolute.point(self.pose.position);
    out["yaw_deg"] = absolute.yaw_deg(self.pose.yaw);
    out["sd"] = rounded(std::min(self.position_sd, 999.0));
    out["yaw_sd_deg"] = rounded(std::min(degrees(self.yaw_sd), 999.0));
    out["localised"] = self.localised;
    return out;
}

json ball(const world::Beliefs& b, const Absolute& absolute) {
    if (!b.ball.known) return nullptr;
    const json finish = absolute.point(b.ball.finish);
    json out = absolute.point(b.ball.position);
    out["vx"] = rounded(absolute.sign * b.ball.velocity.x());
    out["vy"] = rounded(absolute.sign * b.ball.velocity.y());
    out["finish_x"] = finish["x"];
    out["finish_y"] = finish["y"];
    out["seen"] = rounded(std::min(b.now - b.ball.seen, 999.0));
    return out;
}

json target(const decision::Account& account, const Absolute& absolute) {
    if (!account.target) return nullptr;
    return absolute.point(*account.target);
}

json scored(const decision::Account& account, const Absolute& absolute) {
    json out = json::array();
    for (const decision::Scored& place : account.scored) {
        const json point = absolute.point(place.point);
        out.push_back({point["x"], point["y"], rounded(place.cost)});
    }
    return out;
}

/// Right after the fault: the reason is errno's.
std::string cannot_write(const std::string& path) {
    return "cannot write telemetry to " + path + ": " + std::strerror(errno);
}

}  // namespace

Telemetry::Telemetry(const std::string& path, const std::string& team, double belief_interval,
                     bool targets)
    : path_(path), team_(team), belief_interval_(belief_interval), targets_(targets) {
    if (path.empty()) return;
    file_.open(path, std::ios::trunc);
    if (!file_) throw std::invalid_argument(cannot_write(path));
}

void Telemetry::record(const world::Beliefs& b, const motion::State& body,
                       const decision::Decision& d) {
    if (!file_.is_open() || b.game.side == wire::Side::None) return;
    const Absolute absolute{b.game.side == wire::Side::Right ? -1.0 : 1.0};
    const decision::Account& account = d.account;
    const auto write = [&](const char* event, const json& more) {
        json line{{"time", rounded(b.now)}, {"event", event}};
        line.update(more);
        // The server's words (the play mode) may be any bytes; JSON is UTF-8.
        file_ << line.dump(-1, ' ', false, json::error_handler_t::replace) + "\n" << std::flush;
        if (!file_) throw std::runtime_error(cannot_write(path_));
    };

    if (!started_) {
        started_ = true;
        write("start", {{"team", team_}, {"unum", b.game.unum}});
    }
    if (body.kick_started) {
        ++kicks_;
        write("kick_attempt", {{"pose", pose(b.self, absolute)},
                               {"ball", ball(b, absolute)},
                               {"target", target(account, absolute)},
                               {"taker_distance", rounded(account.taker_distance)}});
    }
    if (body.kick_done) write("kick_end", {{"pose", pose(b.self, absolute)}});
    if (body.upright != upright_) {
        upright_ = body.upright;
        write(upright_ ? "got_up" : "fall", {{"pose", pose(b.self, absolute)}, {"falls", body.falls}});
    }
    if (account.role != role_) {
        write("role", {{"from", role_}, {"to", account.role}});
        role_ = account.role;
    }
    if (b.now + 1e-9 < next_belief_) return;
    next_belief_ = b.now + belief_interval_;
    json belief{{"game_time", rounded(b.game.time)},
                {"mode", b.game.play_mode},
                {"pose", pose(b.self, absolute)},
                {"upright", body.upright},
                {"activity", name_of(body.activity)},
                {"falls", body.falls},
                {"kicks", kicks_},
                {"ball", ball(b, absolute)},
                {"role", account.role},
                {"skill", account.skill},
                {"k1", account.k1},
                {"k2", account.k2},
                {"target", target(account, absolute)},
                {"cost", rounded(account.cost)},
                {"taker_distance", rounded(account.taker_distance)}};
    if (targets_) belief["scored"] = scored(account, absolute);
    write("belief", belief);
}

}  // namespace k3d::agent::action

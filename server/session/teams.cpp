// SPDX-License-Identifier: BSD-3-Clause
#include "server/session/teams.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/log/limiter.h"

namespace k3d::server::session {

namespace {
constexpr int kMaxUnum = 11;

/// Names stand in percepts, monitor streams, JSON and logs, and a frame to an agent has 8 KiB.
constexpr std::size_t kMaxNameBytes = 32;

bool is_name(std::string_view text) {
    return !text.empty() && text.size() <= kMaxNameBytes &&
           std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c <= '~'; });
}

std::size_t slot_of(wire::Side side) { return side == wire::Side::Left ? 0 : 1; }
}  // namespace

Teams::Teams(std::string left, std::string right, int left_seats, int right_seats)
    : names_{std::move(left), std::move(right)}, seats_{left_seats, right_seats} {}

tl::expected<Seat, std::string> Teams::assign(const wire::InitCommand& init) {
    if (!is_name(init.team)) {
        return tl::unexpected(fmt::format("team name '{}' is not 1 to {} bytes of visible ASCII",
                                          log::printable(init.team), kMaxNameBytes));
    }
    std::size_t slot = 0;
    if (init.team == names_[0]) {
        slot = 0;
    } else if (init.team == names_[1]) {
        slot = 1;
    } else if (names_[0].empty() || names_[1].empty()) {
        slot = names_[0].empty() ? 0 : 1;
    } else {
        return tl::unexpected(fmt::format("third team '{}': the match is '{}' against '{}'",
                                          init.team, names_[0], names_[1]));
    }
    std::set<int>& taken = taken_[slot];
    if (static_cast<int>(taken.size()) >= seats_[slot]) {
        return tl::unexpected(
            fmt::format("team '{}' already has its {} players", init.team, seats_[slot]));
    }
    int unum = init.unum;
    if (unum < 0 || unum > kMaxUnum) {
        return tl::unexpected(fmt::format("number {} is not in 0..{}", unum, kMaxUnum));
    }
    if (unum == 0) {
        for (unum = 1; taken.contains(unum);) ++unum;
    }
    // Where not all eleven numbers have a seat, a start position exists for the first ones only.
    if (unum > seats_[slot]) {
        return tl::unexpected(fmt::format("number {} of team '{}': this game has numbers 1..{}",
                                          unum, init.team, seats_[slot]));
    }
    if (!taken.insert(unum).second) {
        return tl::unexpected(fmt::format("number {} of team '{}' is taken", unum, init.team));
    }
    names_[slot] = init.team;
    return Seat{slot == 0 ? wire::Side::Left : wire::Side::Right, unum};
}

void Teams::release(const Seat& seat) { taken_[slot_of(seat.team)].erase(seat.unum); }

bool Teams::full() const {
    return static_cast<int>(taken_[0].size()) == seats_[0] &&
           static_cast<int>(taken_[1].size()) == seats_[1];
}

std::string Teams::missing() const {
    std::string text;
    for (std::size_t slot = 0; slot < 2; ++slot) {
        for (int unum = 1; unum <= seats_[slot]; ++unum) {
            if (taken_[slot].contains(unum)) continue;
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", slot == 0 ? "left" : "right",
                                unum);
        }
    }
    return text;
}

}  // namespace k3d::server::session

// SPDX-License-Identifier: BSD-3-Clause
#include "server/session/teams.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/config/config.h"
#include "common/log/limiter.h"

namespace k3d::server::session {

namespace {
using wire::kMaxUnum;

std::size_t slot_of(wire::Side side) { return side == wire::Side::Left ? 0 : 1; }

/// Nobody could ever take the seats of a team whose name is on no wire or is the other's.
void check_reserved(const std::string& left, const std::string& right) {
    for (const auto& [key, name] : {std::pair("left_team", left), std::pair("right_team", right)}) {
        const auto fault = name.empty() ? std::nullopt : fault_of_team_name(name);
        if (fault) throw config::ConfigError(fmt::format("{}: {}", key, *fault));
    }
    if (left.empty() || left != right) return;
    throw config::ConfigError(fmt::format("left_team and right_team are both '{}'", left));
}
}  // namespace

std::optional<std::string> fault_of_team_name(std::string_view name) {
    const auto fits = [](char c) { return c > ' ' && c <= '~' && c != '(' && c != ')'; };
    if (!name.empty() && name.size() <= kMaxTeamName && std::ranges::all_of(name, fits)) {
        return std::nullopt;
    }
    return fmt::format("team name '{}' is not 1 to {} bytes of visible ASCII without parentheses",
                       log::printable(name), kMaxTeamName);
}

Teams::Teams(std::string left, std::string right, int left_seats, int right_seats,
             std::optional<TypeQuotas> quotas)
    : names_{std::move(left), std::move(right)}, seats_{left_seats, right_seats}, quotas_(quotas) {
    check_reserved(names_[0], names_[1]);
}

tl::expected<Seat, std::string> Teams::assign(const wire::InitCommand& init, int type) {
    const auto slot = slot_for(init.team);
    if (!slot) return tl::unexpected(slot.error());
    const auto unum = number_for(*slot, init);
    if (!unum) return tl::unexpected(unum.error());
    if (const auto broken = broken_quota(taken_[*slot], type)) {
        return tl::unexpected(fmt::format("team '{}': {}", init.team, *broken));
    }
    taken_[*slot].emplace(*unum, type);
    names_[*slot] = init.team;
    return Seat{*slot == 0 ? wire::Side::Left : wire::Side::Right, *unum};
}

tl::expected<std::size_t, std::string> Teams::slot_for(const std::string& team) const {
    if (auto fault = fault_of_team_name(team)) return tl::unexpected(std::move(*fault));
    for (const std::size_t slot : {0, 1}) {
        if (team == names_[slot]) return slot;
    }
    for (const std::size_t slot : {0, 1}) {
        if (names_[slot].empty()) return slot;
    }
    return tl::unexpected(fmt::format("third team '{}': the match is '{}' against '{}'", team,
                                      names_[0], names_[1]));
}

tl::expected<int, std::string> Teams::number_for(std::size_t slot,
                                                 const wire::InitCommand& init) const {
    const Players& taken = taken_[slot];
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
    if (taken.contains(unum)) {
        return tl::unexpected(fmt::format("number {} of team '{}' is taken", unum, init.team));
    }
    return unum;
}

std::optional<std::string> Teams::broken_quota(const Players& players, int type) const {
    if (!quotas_) return std::nullopt;
    std::map<int, int> count;
    for (const auto& [unum, of] : players) ++count[of];
    const int same = ++count[type];
    if (same > quotas_->of_one_type) {
        return fmt::format("more than {} robots of type {}", quotas_->of_one_type, type);
    }
    for (const auto& [other, others] : count) {
        if (other != type && same + others > quotas_->of_two_types) {
            return fmt::format("more than {} robots of types {} and {}", quotas_->of_two_types,
                               other, type);
        }
    }
    const int still_to_come = kMaxUnum - static_cast<int>(players.size()) - 1;
    if (static_cast<int>(count.size()) + still_to_come < quotas_->different) {
        return fmt::format("no room would be left for {} different types", quotas_->different);
    }
    return std::nullopt;
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

// SPDX-License-Identifier: BSD-3-Clause
// Which side and number an agent gets (reference 1.6).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "common/wire/commands.h"
#include "server/session/agent_session.h"

namespace k3d::server::session {

/// A team's name stands in each See of each player: with names of at most this length a frame in which
/// all 22 are seen still fits wire::kMaxPayloadToAgent.
inline constexpr std::size_t kMaxTeamName = 32;

/// "team name 'A B' is not 1 to 32 bytes of visible ASCII without parentheses"; none if it is.
std::optional<std::string> fault_of_team_name(std::string_view name);

/// How a team of eleven must mix its robot types (reference 1.6).
struct TypeQuotas {
    int of_one_type = 7;
    int of_two_types = 9;  ///< together
    int different = 3;     ///< in a full team
};

class Teams {
  public:
    /// `left` and `right` reserve names; empty ones go to the first names that come. At most
    /// `left_seats` and `right_seats` players, numbers 1..11. Without quotas all types are welcome.
    /// Throws config::ConfigError for reserved names that no two teams can have.
    Teams(std::string left, std::string right, int left_seats, int right_seats,
          std::optional<TypeQuotas> quotas);

    /// The seat, or why there is none ("third team 'C': the match is A against B").
    tl::expected<Seat, std::string> assign(const wire::InitCommand& init, int type);
    void release(const Seat& seat);

    bool full() const;
    const std::string& left() const { return names_[0]; }
    const std::string& right() const { return names_[1]; }
    /// "left 3, right 1": the seats still free among the first numbers.
    std::string missing() const;

  private:
    using Players = std::map<int, int>;  ///< number -> robot type

    tl::expected<std::size_t, std::string> slot_for(const std::string& team) const;
    tl::expected<int, std::string> number_for(std::size_t slot, const wire::InitCommand& init) const;
    std::optional<std::string> broken_quota(const Players& players, int type) const;

    std::string names_[2];
    int seats_[2];
    std::optional<TypeQuotas> quotas_;
    Players taken_[2];
};

}  // namespace k3d::server::session

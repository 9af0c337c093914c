// SPDX-License-Identifier: BSD-3-Clause
// Which side and number an agent gets (reference 1.6).
#pragma once

#include <set>
#include <string>

#include <tl/expected.hpp>

#include "common/wire/commands.h"
#include "server/session/agent_session.h"

namespace k3d::server::session {

class Teams {
  public:
    /// `left` and `right` reserve names; empty ones go to the first names that come. At most
    /// `left_seats` and `right_seats` players, numbers 1..11.
    Teams(std::string left, std::string right, int left_seats, int right_seats);

    /// The seat, or why there is none ("third team 'C': the match is A against B").
    tl::expected<Seat, std::string> assign(const wire::InitCommand& init);
    void release(const Seat& seat);

    bool full() const;
    const std::string& left() const { return names_[0]; }
    const std::string& right() const { return names_[1]; }
    /// "left 3, right 1": the seats still free among the first numbers.
    std::string missing() const;

  private:
    std::string names_[2];
    int seats_[2];
    std::set<int> taken_[2];
};

}  // namespace k3d::server::session

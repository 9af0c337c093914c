// SPDX-License-Identifier: BSD-3-Clause
// The last message of every team-mate, with the time it was heard.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "agent/talk/message.h"
#include "common/wire/percepts.h"

namespace k3d::agent::talk {

struct Report {
    double heard = 0.0;  ///< simulation time, s
    Message message;
};

class Ears {
  public:
    /// Messages of this frame that team-mates of `team` other than number `unum` said; also kept.
    /// Own, foreign and damaged ones are ignored.
    /// Valid until the next call.
    std::span<const Message> hear(const wire::Percepts& percepts, std::string_view team, int unum);

    /// Latest report of each team-mate, by unum.
    std::span<const Report> latest() const { return latest_; }

  private:
    std::vector<Message> fresh_;
    std::vector<Report> latest_;
};

}  // namespace k3d::agent::talk

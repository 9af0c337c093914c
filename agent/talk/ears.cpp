// SPDX-License-Identifier: BSD-3-Clause
// Keeps what team-mates said last.
#include "agent/talk/ears.h"

namespace k3d::agent::talk {

std::vector<Message> Ears::hear(const wire::Percepts& percepts, std::string_view team, int unum) {
    std::vector<Message> fresh;
    for (const wire::Heard& heard : percepts.heard) {
        if (!heard.direction_deg || heard.team != team) continue;
        const std::optional<Message> message = decode(heard.text);
        if (!message || message->unum == unum) continue;
        fresh.push_back(*message);
        latest_[message->unum] = {percepts.time, *message};
    }
    return fresh;
}

std::vector<Report> Ears::latest() const {
    std::vector<Report> reports;
    for (const auto& [unum, report] : latest_) reports.push_back(report);
    return reports;
}

}  // namespace k3d::agent::talk

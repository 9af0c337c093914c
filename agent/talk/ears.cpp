// SPDX-License-Identifier: BSD-3-Clause
// Keeps what team-mates said last.
#include "agent/talk/ears.h"

#include <algorithm>

namespace k3d::agent::talk {

std::span<const Message> Ears::hear(const wire::Percepts& percepts, std::string_view team,
                                    int unum) {
    fresh_.clear();
    for (const wire::Heard& heard : percepts.heard) {
        if (!heard.direction_deg || heard.team != team) continue;
        const std::optional<Message> message = decode(heard.text);
        if (!message || message->unum == unum) continue;
        fresh_.push_back(*message);
        const auto place = std::ranges::lower_bound(
            latest_, message->unum, {}, [](const Report& report) { return report.message.unum; });
        if (place != latest_.end() && place->message.unum == message->unum) {
            *place = {percepts.time, *message};
        } else {
            latest_.insert(place, {percepts.time, *message});
        }
    }
    return fresh_;
}

}  // namespace k3d::agent::talk

// SPDX-License-Identifier: BSD-3-Clause
// Say and hear: who hears what under the capacity rules of reference 3.7.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "server/body/scene.h"

namespace k3d::server::effectors {

inline constexpr std::size_t kMaxSayBytes = 20;
inline constexpr double kHearingRange = 50.0;  // m

/// True if the text may be said: 1..20 bytes of 0x21..0x7E without parentheses.
bool sayable(std::string_view text);

/// What one listener will hear next, and how much it still can.
class Ear {
  public:
    void hear_self(std::string_view text, double game_time, std::string_view team);
    /// Drops the message if this listener's capacity for the speaker's team is used up.
    void hear_other(const body::Player& listener, const body::Player& speaker,
                    std::string_view text, double game_time);

    /// Once per percept cycle: hands out self, team-mate, opponent messages, and recovers.
    void collect(std::vector<wire::Heard>& out);

  private:
    static constexpr int kCapacity = 2;  ///< start and maximum; +1 a cycle, a message costs 2
    std::optional<wire::Heard> self_, mate_, opponent_;
    int mate_capacity_ = kCapacity;
    int opponent_capacity_ = kCapacity;
};

}  // namespace k3d::server::effectors

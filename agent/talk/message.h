// SPDX-License-Identifier: BSD-3-Clause
// The 20-byte team message: what is said, and its coding into printable bytes (reference 3.7).
//
// Frame: team frame, metres. Positions are sent on a 0.1 m grid or finer.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/math/geometry.h"

namespace k3d::agent::talk {

inline constexpr std::size_t kMessageBytes = 20;

/// An opponent that the speaker sees. Told only within kTellReach of the speaker on both axes.
struct Sighting {
    int unum = 0;                      ///< 1..11
    Vec2 position = Vec2::Zero();
};
inline constexpr double kTellReach = 6.3;  // m

/// One keeper's report to its team-mates (paper 5.1: K1 says the target and so gives the roles).
struct Message {
    int unum = 0;                      ///< speaker, 1..11
    Vec2 position = Vec2::Zero();      ///< speaker
    bool fallen = false;
    std::optional<Vec2> ball;          ///< as the speaker sees it, absent if not seen lately
    Vec2 ball_velocity = Vec2::Zero(); ///< with ball
    bool claims_k1 = false;
    std::optional<Vec2> target;        ///< K1's kick target
    int k2 = 0;                        ///< unum that K1 names K2, 0 = none
    std::optional<Sighting> opponent;  ///< one at a time
};

/// At most kMessageBytes bytes of 0x21..0x7E without parentheses. Values outside the field are
/// clamped to it.
std::string encode(const Message& message);
/// The same in place of what `text` held.
void encode(const Message& message, std::string& text);

/// None if the text is not such a message (another team's, damaged): checked by length, alphabet
/// and a check symbol.
std::optional<Message> decode(std::string_view text);

}  // namespace k3d::agent::talk

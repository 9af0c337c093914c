// SPDX-License-Identifier: BSD-3-Clause
#include "server/effectors/hearing.h"

#include <algorithm>
#include <cmath>

namespace k3d::server::effectors {

bool sayable(std::string_view text) {
    return !text.empty() && text.size() <= kMaxSayBytes &&
           std::all_of(text.begin(), text.end(),
                       [](char c) { return c > 0x20 && c < 0x7F && c != '(' && c != ')'; });
}

void Ear::hear_self(std::string_view text, double game_time, std::string_view team) {
    self_ = wire::Heard{std::string(team), game_time, std::nullopt, std::string(text)};
}

void Ear::hear_other(const body::Player& listener, const body::Player& speaker,
                     std::string_view text, double game_time) {
    const Vec3 apart = speaker.robot->torso_position() - listener.robot->torso_position();
    if (apart.norm() > kHearingRange) return;
    const bool mate = speaker.team == listener.team;
    int& capacity = mate ? mate_capacity_ : opponent_capacity_;
    if (capacity < kCapacity) return;
    capacity -= kCapacity;
    const Vec3 towards = body::flipped(apart, listener.team);
    (mate ? mate_ : opponent_) =
        wire::Heard{speaker.team_name, game_time,
                    degrees(std::atan2(towards.y(), towards.x())), std::string(text)};
}

void Ear::collect(std::vector<wire::Heard>& out) {
    for (std::optional<wire::Heard>* message : {&self_, &mate_, &opponent_}) {
        if (*message) out.push_back(std::move(**message));
        message->reset();
    }
    mate_capacity_ = std::min(mate_capacity_ + 1, kCapacity);
    opponent_capacity_ = std::min(opponent_capacity_ + 1, kCapacity);
}

}  // namespace k3d::server::effectors

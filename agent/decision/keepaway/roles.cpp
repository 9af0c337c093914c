// SPDX-License-Identifier: BSD-3-Clause
// Roles from distances and words.
#include "agent/decision/keepaway/roles.h"

#include <algorithm>
#include <array>
#include <limits>

namespace k3d::agent::decision {
namespace {

constexpr std::size_t kMostMates = 10;

struct Candidate {
    int unum;
    double distance;  ///< to the ball's finish, with handicap and head start
    bool claims;      ///< says, freshly, that it is K1
};

}  // namespace

const char* name_of(Role role) {
    switch (role) {
        case Role::K1: return "K1";
        case Role::K2: return "K2";
        case Role::K3: return "K3";
    }
    return "?";
}

Assignment RoleKeeper::update(const world::Beliefs& b, std::span<const talk::Report> reports,
                              const KeeperConfig& c) {
    const int me = b.game.unum;
    if (b.ball.known)
        k1_ = judge(b, reports, c);
    else if (k1_ == me)
        k1_ = 0;  // who does not know the ball cannot be K1; it may still follow K1's words

    Assignment result{Role::K3, k1_, std::nullopt};
    if (k1_ == me && me != 0) {
        result.role = Role::K1;
        return result;
    }
    // The word of whoever claimed K1 last gives the role, even if we would have judged otherwise.
    const talk::Report* order = nullptr;
    for (const talk::Report& r : reports)
        if (r.message.claims_k1 && b.now - r.heard <= c.order_memory &&
            (order == nullptr || r.heard > order->heard))
            order = &r;
    if (order != nullptr && order->message.target) {
        result.target = order->message.target;
        if (order->message.k2 == me) result.role = Role::K2;
    }
    return result;
}

int RoleKeeper::judge(const world::Beliefs& b, std::span<const talk::Report> reports,
                      const KeeperConfig& c) const {
    const auto says = [&](int unum, bool claims) {
        return std::any_of(reports.begin(), reports.end(), [&](const talk::Report& r) {
            return r.message.unum == unum && r.message.claims_k1 == claims &&
                   b.now - r.heard <= c.claim_memory;
        });
    };
    std::array<Candidate, 1 + kMostMates> list;
    std::size_t count = 0;
    const auto add = [&](int unum, const Vec2& position, bool fallen, bool claims) {
        const double distance = (position - b.ball.finish).norm() +
                                (fallen ? c.fallen_penalty : 0.0) -
                                (unum == k1_ ? c.role_hysteresis : 0.0);
        list[count++] = {unum, distance, claims};
    };
    const int me = b.game.unum;
    add(me, b.self.pose.position, !b.self.upright, k1_ == me);
    for (const world::Player& mate : std::span(b.mates).first(std::min(b.mates.size(), kMostMates)))
        add(mate.unum, mate.position, mate.fallen, says(mate.unum, true));

    const std::span<const Candidate> candidates(list.data(), count);
    const Candidate nearest = *std::min_element(
        candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
            return x.distance != y.distance ? x.distance < y.distance : x.unum < y.unum;
        });
    const double tie = nearest.distance + c.tie_margin;
    // Our own claim counts only against another's: alone we judge by distance.
    const bool others_claim = std::any_of(candidates.begin() + 1, candidates.end(),
                                          [](const Candidate& x) { return x.claims; });
    int claimer = 0;
    for (const Candidate& x : candidates)
        if (others_claim && x.claims && x.distance <= tie && (claimer == 0 || x.unum < claimer))
            claimer = x.unum;
    if (claimer != 0) return claimer;

    // Two keepers may each take the other for K1. Who is as near as the one it waits for, and hears
    // it speak without a claim, begins.
    const bool waits_in_vain = nearest.unum != me && says(nearest.unum, false);
    return waits_in_vain && candidates.front().distance <= tie ? me : nearest.unum;
}

int choose_k2(const Vec2& target, const std::vector<world::Player>& mates, int before,
              const KeeperConfig& c) {
    int chosen = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (const world::Player& mate : mates) {
        const double distance = (mate.position - target).norm() +
                                (mate.fallen ? c.fallen_penalty : 0.0) -
                                (mate.unum == before ? c.role_hysteresis : 0.0);
        if (distance < shortest) {
            shortest = distance;
            chosen = mate.unum;
        }
    }
    return chosen;
}

}  // namespace k3d::agent::decision

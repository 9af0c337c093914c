// SPDX-License-Identifier: BSD-3-Clause
// Roles from distances and words.
#include "agent/decision/keepaway/roles.h"

#include <algorithm>
#include <limits>

namespace k3d::agent::decision {
namespace {

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
    if (!b.ball.known) {
        // Who does not know the ball cannot judge; it may still follow K1's words.
        if (k1_ == me) k1_ = 0;
    } else {
        std::vector<Candidate> candidates;
        const auto add = [&](int unum, const Vec2& position, bool fallen, bool claims) {
            const double distance = (position - b.ball.finish).norm() +
                                    (fallen ? c.fallen_penalty : 0.0) -
                                    (unum == k1_ ? c.role_hysteresis : 0.0);
            candidates.push_back({unum, distance, claims});
        };
        add(me, b.self.pose.position, !b.self.upright, k1_ == me);
        for (const world::Player& mate : b.mates) {
            const bool claims = std::any_of(reports.begin(), reports.end(), [&](const auto& r) {
                return r.message.unum == mate.unum && r.message.claims_k1 &&
                       b.now - r.heard <= c.claim_memory;
            });
            add(mate.unum, mate.position, mate.fallen, claims);
        }
        const auto before = [](const Candidate& x, const Candidate& y) {
            return x.distance != y.distance ? x.distance < y.distance : x.unum < y.unum;
        };
        const Candidate nearest = *std::min_element(candidates.begin(), candidates.end(), before);
        // Our own claim counts only against another's: alone we judge by distance.
        const bool others_claim = std::any_of(candidates.begin() + 1, candidates.end(),
                                              [](const Candidate& x) { return x.claims; });
        int claimer = 0;
        for (const Candidate& x : candidates)
            if (others_claim && x.claims && x.distance <= nearest.distance + c.tie_margin &&
                (claimer == 0 || x.unum < claimer))
                claimer = x.unum;
        k1_ = claimer != 0 ? claimer : nearest.unum;

        // Two keepers may each take the other for K1. Who is as near as the one it waits for, and
        // hears it speak without a claim, begins.
        if (k1_ != me && claimer == 0) {
            const bool silent_rival = std::any_of(reports.begin(), reports.end(), [&](const auto& r) {
                return r.message.unum == k1_ && !r.message.claims_k1 &&
                       b.now - r.heard <= c.claim_memory;
            });
            if (silent_rival && candidates.front().distance <= nearest.distance + c.tie_margin)
                k1_ = me;
        }
    }

    Assignment result{Role::K3, k1_, std::nullopt};
    if (k1_ == me && me != 0) {
        result.role = Role::K1;
        return result;
    }
    // The word of whoever claims K1 last gives the role, even if we would have judged otherwise.
    const talk::Report* order = nullptr;
    for (const talk::Report& r : reports)
        if (r.message.claims_k1 && b.now - r.heard <= c.order_memory &&
            (order == nullptr || r.heard > order->heard))
            order = &r;
    if (order != nullptr && order->message.target && order->message.k2 == me) {
        result.role = Role::K2;
        result.target = order->message.target;
    }
    return result;
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

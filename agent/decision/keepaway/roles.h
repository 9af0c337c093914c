// SPDX-License-Identifier: BSD-3-Clause
// Who is K1, K2, K3 (paper 5.1). Each keeper judges from its own beliefs whether it is K1, the
// nearest to the ball's finish; the others learn their role from what K1 says.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "agent/decision/config.h"
#include "agent/talk/ears.h"
#include "agent/world/beliefs.h"

namespace k3d::agent::decision {

enum class Role { K1, K2, K3 };
const char* name_of(Role role);

/// What a keeper knows of its part in this cycle.
struct Assignment {
    Role role = Role::K3;
    int k1 = 0;                    ///< unum of the keeper taken for K1, 0 = nobody
    std::optional<Vec2> target;    ///< where K1 says that its pass will go, team frame
};

class RoleKeeper {
  public:
    /// Distances to the finish decide; the present K1 has a head start, the fallen a handicap.
    /// Among keepers within tie_margin the word of one who says that it is K1 counts, and among
    /// several who say so the lowest number. If nobody near says so, the nearest begins.
    Assignment update(const world::Beliefs& beliefs, std::span<const talk::Report> reports,
                      const KeeperConfig& config);

  private:
    int judge(const world::Beliefs& beliefs, std::span<const talk::Report> reports,
              const KeeperConfig& config) const;

    int k1_ = 0;
};

/// The keeper that K1 names K2: the one closest to the target, never K1 itself. The one named
/// before has a head start. 0 without team-mates.
int choose_k2(const Vec2& target, const std::vector<world::Player>& mates, int before,
              const KeeperConfig& config);

}  // namespace k3d::agent::decision

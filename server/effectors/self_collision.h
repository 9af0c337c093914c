// SPDX-License-Identifier: BSD-3-Clause
// The rule that freezes limbs which reach through one's own body (reference 4 rule 2, 7.4): limbs never
// touch physically, so overlapping boxes are a foul, and stop the joints of the arms or legs involved.
#pragma once

#include <array>
#include <optional>

#include "common/config/fields.h"
#include "server/body/robot.h"

namespace k3d::server::effectors {

struct SelfCollisionConfig {
    bool freezes = true;

    void describe(config::Fields& f) {
        f.boolean("freezes", freezes,
                  "a limb that reaches 4 cm through another part of its robot stands still for 1 s");
    }
};

inline constexpr double kOverlapTolerance = 0.04;  // m, overlap that is forgiven
inline constexpr double kFrozenTime = 1.0;         // s
inline constexpr double kImmuneTime = 2.0;         // s after thawing in which nothing freezes

/// A box in the field frame.
struct Box {
    Vec3 centre;
    Mat3 axes;  ///< columns
    Vec3 half;  ///< extents
};

/// True if no axis separates the boxes. The reference takes the nine axes that two edges span at their
/// raw length, so that boxes with nearly parallel edges never count as overlapping; so do we.
bool overlap(const Box& a, const Box& b, double tolerance);

/// One robot's limbs under the rule.
class SelfCollision {
  public:
    /// After each step in which the game runs; `now` in s. True if a limb was frozen: a foul.
    bool judge(const body::Robot& robot, double now);
    /// In a pause of the game nothing is frozen.
    void release() { *this = {}; }

    bool frozen(nao::JointId joint) const;

  private:
    enum Limb : std::size_t { RightArm, LeftArm, RightLeg, LeftLeg, kLimbCount };
    static std::optional<Limb> limb_of(nao::Part part);
    static std::optional<Limb> limb_of(nao::JointId joint);

    struct State {
        bool frozen = false;
        std::optional<double> since;  ///< when it froze last, s; none: may freeze
    };
    std::array<State, kLimbCount> limbs_;
};

}  // namespace k3d::server::effectors

// SPDX-License-Identifier: BSD-3-Clause
// A robot in the server's physics that follows one motion engine at a time, without a walk; limbs that
// reach through its own body are frozen as the server does it.
#pragma once

#include "agent/motion/joint_control.h"
#include "agent/motion/posture.h"
#include "agent/motion/walk/walk_engine.h"
#include "contract/body_rig.h"
#include "server/effectors/self_collision.h"

namespace k3d::contract {

/// The stance of the walk, in which motions begin and end.
inline nao::JointArray walk_stance(int type = 0) {
    const agent::motion::walk::Config config;
    agent::motion::JointTargets targets;
    agent::motion::walk::WalkEngine(nao::model(type), config).stance(targets);
    return targets.angle;
}

class EngineRig {
  public:
    explicit EngineRig(int type = 0) : rig(type), control_(rig.model()) { targets.angle = rig.sense().joints; }

    /// One cycle towards targets.
    void advance() {
        control_.step(rig.sense().joints, targets, rates_);
        nao::JointArray obeyed = rates_;
        for (const nao::JointDef& joint : rig.model().joints) {
            if (self_collision_.frozen(joint.id)) obeyed[nao::index(joint.id)] = 0.0;
        }
        rig.advance(obeyed);
        if (self_collision_.judge(rig.robot(), rig.time())) ++times_frozen_;
        posture_.update(rig.sense());
    }

    /// Moves to `pose` in a straight line and holds it.
    void take(const nao::JointArray& pose, double seconds, double hold_seconds) {
        const nao::JointArray from = targets.angle;
        const int moving = static_cast<int>(seconds / 0.02);
        const int all = moving + static_cast<int>(hold_seconds / 0.02);
        for (int n = 1; n <= all; ++n) {
            const double share = n < moving ? static_cast<double>(n) / moving : 1.0;
            for (std::size_t i = 0; i < pose.size(); ++i) {
                targets.angle[i] = from[i] + share * (pose[i] - from[i]);
            }
            advance();
        }
    }

    /// Runs a started engine to its end, at most `limit` s; the time it took, or the limit.
    template <class Engine>
    double run(Engine& engine, double limit) {
        double t = 0.0;
        for (bool running = true; running && t < limit; t += 0.02) {
            running = engine.step(rig.sense(), posture_.posture(), targets);
            advance();
        }
        return t;
    }

    const agent::motion::Posture& posture() const { return posture_.posture(); }
    int times_frozen() const { return times_frozen_; }  ///< cycles in which limbs were frozen anew

    BodyRig rig;
    agent::motion::JointTargets targets;

  private:
    agent::motion::PostureFilter posture_;
    agent::motion::JointControl control_;
    server::effectors::SelfCollision self_collision_;
    int times_frozen_ = 0;
    nao::JointArray rates_{};
};

}  // namespace k3d::contract

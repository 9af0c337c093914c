// SPDX-License-Identifier: BSD-3-Clause
#include "agent/motion/kick/kick_engine.h"

#include <array>

#include "agent/kinematics/leg.h"

namespace k3d::agent::kick {

namespace {

using nao::JointArray;
using enum nao::JointId;
using kinematics::kLeftLeg;
using kinematics::kRightLeg;

/// Whether mirroring turns the sign of a leg's joint; they stand in the order of LegFrames.
constexpr std::array<bool, 6> kSignTurns{false, true, false, false, false, true};

std::array<double, 6> angles_deg(const LegFrames& leg, std::size_t k) {
    return {leg.hip_yaw_pitch_deg[k], leg.hip_roll_deg[k],    leg.hip_pitch_deg[k],
            leg.knee_deg[k],          leg.ankle_pitch_deg[k], leg.ankle_roll_deg[k]};
}

double mixed(double near, double far, double far_share) {
    return near + far_share * (far - near);
}

/// Writes keyframe k of a leg, given for the kick with the right foot, onto the leg `joints`.
void set_leg(JointArray& pose, const kinematics::LegJoints& joints, const LegFrames& near,
             const LegFrames& far, std::size_t k, double far_share, bool mirrored) {
    const std::array<double, 6> near_deg = angles_deg(near, k);
    const std::array<double, 6> far_deg = angles_deg(far, k);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const double sign = mirrored && kSignTurns[i] ? -1.0 : 1.0;
        pose[nao::index(joints[i])] = sign * radians(mixed(near_deg[i], far_deg[i], far_share));
    }
}

}  // namespace

KickEngine::Mix KickEngine::mix_for(double distance) const {
    switch (strike_.way) {
        case Way::Straight: break;
        case Way::Slant: return {config_.slant.swing, config_.slant.swing, 0.0};
        case Way::Square: return {config_.square.swing, config_.square.swing, 0.0};
        case Way::Farthest: return {config_.farthest.swing, config_.farthest.swing, 0.0};
    }
    return {config_.near, config_.far, config_.far_share(distance)};
}

JointArray KickEngine::pose_of(const Mix& mix, std::size_t k) const {
    const bool mirrored = strike_.foot == Foot::Left;
    const auto& [near, far, share] = mix;
    JointArray pose = stand_;  // the arms stay
    set_leg(pose, mirrored ? kLeftLeg : kRightLeg, near.kicking, far.kicking, k, share, mirrored);
    set_leg(pose, mirrored ? kRightLeg : kLeftLeg, near.support, far.support, k, share, mirrored);
    return pose;
}

void KickEngine::start(const motion::Kick& kick, const JointArray& stand) {
    strike_ = possible_strike(config_, kick)
                  .value_or(Strike{Way::Straight, kick.ball.y() > 0.0 ? Foot::Left : Foot::Right});
    stand_ = stand;
    frames_.clear();
    const Mix mix = mix_for(kick.distance);
    const auto& [near, far, share] = mix;
    for (std::size_t k = 0; k < far.duration_s.size(); ++k) {
        frames_.push_back({mixed(near.duration_s[k], far.duration_s[k], share), pose_of(mix, k)});
    }
    frames_.push_back({mixed(near.stand_s, far.stand_s, share), stand_});
    frame_ = 0;
    cycle_ = 0;
    calm_cycles_ = 0;
    fresh_ = true;
}

bool KickEngine::step(const motion::BodySense& sense, const motion::Posture& posture,
                      motion::JointTargets& out) {
    if (frame_ >= frames_.size()) return !is_quiet(posture);
    if (fresh_) {
        fresh_ = false;
        from_ = sense.joints;
    }
    const motion::Keyframe& frame = frames_[frame_];
    const int length = motion::cycles_of(frame.duration);
    const double share = static_cast<double>(++cycle_) / length;
    for (std::size_t i = nao::index(RShoulderPitch); i < from_.size(); ++i) {
        out.angle[i] = from_[i] + share * (frame.pose[i] - from_[i]);
    }
    if (cycle_ >= length) {
        from_ = frame.pose;
        cycle_ = 0;
        ++frame_;
    }
    return true;
}

/// A walk that begins while the body still swings from the kick may fall.
bool KickEngine::is_quiet(const motion::Posture& posture) {
    calm_cycles_ = posture.rate.norm() < config_.settle_rate ? calm_cycles_ + 1 : 0;
    return calm_cycles_ >= motion::kCalmCycles ||
           ++cycle_ >= motion::cycles_of(config_.settle_limit_s);
}

}  // namespace k3d::agent::kick

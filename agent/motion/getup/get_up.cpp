// SPDX-License-Identifier: BSD-3-Clause
// Gets a fallen robot back on its feet.
#include "agent/motion/getup/get_up.h"

#include <algorithm>
#include <cmath>

namespace k3d::agent::getup {

namespace {

using nao::JointArray;
using nao::JointId;

constexpr double kUpright = 0.85;  // up.z above this: the torso stands
constexpr double kArmsDown = radians(-90.0);

/// Sets the same joint of both sides; `sign` -1 mirrors axes that point along or across the body.
void set_pair(JointArray& pose, JointId right, JointId left, double right_angle, double sign) {
    pose[nao::index(right)] = right_angle;
    pose[nao::index(left)] = sign * right_angle;
}

/// Limbs straight, arms along the body: every sequence starts from it.
JointArray straight_pose() {
    JointArray pose{};
    set_pair(pose, JointId::RShoulderPitch, JointId::LShoulderPitch, kArmsDown, 1.0);
    return pose;
}

JointArray pose_of(const Sequence& s, std::size_t k) {
    JointArray pose{};
    const auto angle = [k](const std::vector<double>& list) { return radians(list[k]); };
    using enum JointId;
    set_pair(pose, RShoulderPitch, LShoulderPitch, angle(s.shoulder_pitch_deg), 1.0);
    set_pair(pose, RShoulderYaw, LShoulderYaw, -angle(s.shoulder_spread_deg), -1.0);
    set_pair(pose, RHipYawPitch, LHipYawPitch, angle(s.hip_yaw_pitch_deg), 1.0);
    set_pair(pose, RHipRoll, LHipRoll, -angle(s.hip_roll_deg), -1.0);
    set_pair(pose, RHipPitch, LHipPitch, angle(s.hip_pitch_deg), 1.0);
    set_pair(pose, RKneePitch, LKneePitch, angle(s.knee_deg), 1.0);
    set_pair(pose, RAnklePitch, LAnklePitch, angle(s.ankle_deg), 1.0);
    set_pair(pose, RAnkleRoll, LAnkleRoll, angle(s.hip_roll_deg), -1.0);
    return pose;
}

/// Straight limbs, but the arm below reaches out in front and pushes the body onto its back.
JointArray roll_pose(const Config& config, bool on_right) {
    JointArray pose = straight_pose();
    set_pair(pose, JointId::RShoulderPitch, JointId::LShoulderPitch,
             radians(config.roll_pitch_deg), 1.0);
    const double spread = radians(config.roll_spread_deg);
    if (on_right) {
        pose[nao::index(JointId::RShoulderYaw)] = -spread;
    } else {
        pose[nao::index(JointId::LShoulderYaw)] = spread;
    }
    return pose;
}

}  // namespace

Lying lying_on(const Vec3& up) {
    if (up.z() > kUpright) return Lying::Upright;
    if (std::abs(up.x()) >= std::abs(up.y())) return up.x() > 0.0 ? Lying::OnBack : Lying::OnFront;
    return up.y() > 0.0 ? Lying::OnRight : Lying::OnLeft;
}

GetUp::GetUp(const Config& config, int type)
    : config_(config), sequences_(config.type[static_cast<std::size_t>(type)]) {
    constexpr std::size_t kRoll = 3;  // the most keyframes of any other phase
    const std::size_t longest =
        std::max(sequences_.back.duration_s.size(), sequences_.front.duration_s.size()) + 1;
    frames_.reserve(std::max(longest, kRoll));
}

void GetUp::start(const JointArray& stand) {
    stand_ = stand;
    tries_ = 0;
    fresh_ = true;
    begin(Phase::Tuck);
}

void GetUp::begin(Phase phase) {
    phase_ = phase;
    frames_.clear();
    cycle_ = 0;
    calm_cycles_ = 0;
    from_ = pose_;
    if (phase == Phase::Tuck) frames_.push_back({config_.tuck_s, straight_pose()});
}

void GetUp::add_sequence(const Sequence& sequence) {
    const double slower = std::pow(config_.retry_slower, tries_);
    for (std::size_t k = 0; k < sequence.duration_s.size(); ++k) {
        frames_.push_back({slower * sequence.duration_s[k], pose_of(sequence, k)});
    }
    frames_.push_back({slower * sequence.stand_s, stand_});
    ++tries_;
}

void GetUp::act_on(Lying lying) {
    switch (lying) {
        case Lying::Upright:
            begin(Phase::Sequence);
            frames_.push_back({sequences_.back.stand_s, stand_});
            break;
        case Lying::OnBack:
        case Lying::OnFront:
            begin(Phase::Sequence);
            add_sequence(lying == Lying::OnBack ? sequences_.back : sequences_.front);
            break;
        case Lying::OnRight:
        case Lying::OnLeft: {
            const JointArray push = roll_pose(config_, lying == Lying::OnRight);
            begin(Phase::Roll);
            frames_.push_back({config_.roll_s, push});
            frames_.push_back({config_.roll_hold_s, push});
            frames_.push_back({config_.tuck_s, straight_pose()});
            break;
        }
    }
}

/// Moves pose_ along the running keyframe; true when the last one has been reached.
bool GetUp::advance_frames() {
    if (frames_.empty()) return true;
    const motion::Keyframe& frame = frames_.front();
    const int length = motion::cycles_of(frame.duration);
    ++cycle_;
    const double share = std::min(1.0, static_cast<double>(cycle_) / length);
    for (std::size_t i = 0; i < pose_.size(); ++i) {
        pose_[i] = from_[i] + share * (frame.pose[i] - from_[i]);
    }
    if (cycle_ < length) return false;
    from_ = frame.pose;
    frames_.erase(frames_.begin());
    cycle_ = 0;
    return frames_.empty();
}

bool GetUp::lies_still(const motion::Posture& posture) {
    calm_cycles_ = posture.rate.norm() < config_.rest_rate ? calm_cycles_ + 1 : 0;
    ++cycle_;
    return calm_cycles_ >= motion::kCalmCycles || cycle_ >= motion::cycles_of(config_.rest_limit_s);
}

bool GetUp::step(const motion::BodySense& sense, const motion::Posture& posture,
                 motion::JointTargets& out) {
    if (fresh_) {
        fresh_ = false;
        pose_ = sense.joints;
        from_ = pose_;
    }
    bool running = true;
    switch (phase_) {
        case Phase::Tuck:
        case Phase::Roll:
            if (advance_frames()) begin(Phase::Rest);
            break;
        case Phase::Rest:
            if (lies_still(posture)) act_on(lying_on(posture.up));
            break;
        case Phase::Sequence:
            if (advance_frames()) begin(Phase::Settle);
            break;
        case Phase::Settle:
            if (lying_on(posture.up) != Lying::Upright) {
                begin(Phase::Tuck);
            } else {
                // A robot that still rocks may yet fall: only quiet time counts.
                cycle_ = posture.rate.norm() < config_.settle_rate ? cycle_ + 1 : 0;
                running = cycle_ < motion::cycles_of(config_.settle_s);
            }
            break;
    }
    for (std::size_t i = nao::index(JointId::RShoulderPitch); i < pose_.size(); ++i) {
        out.angle[i] = pose_[i];
    }
    return running;
}

}  // namespace k3d::agent::getup

// SPDX-License-Identifier: BSD-3-Clause
#include "agent/localisation/localiser.h"

#include <algorithm>

namespace k3d::agent::localisation {

namespace {

constexpr double kSystematicPosition = 0.01;  // m: what more views do not average away
constexpr double kSystematicYaw = 0.003;      // rad
constexpr double kSureYaw = 0.17;   // rad: with a larger spread lines may be taken for others
constexpr double kSureShare = 0.6;  // weight of a cluster that settles an ambiguity
constexpr double kClusterBonus = 0.15;
constexpr double kAmbiguous = 0.1;  // two different poses whose shares differ by less

bool same_place(const Pose2& a, const Pose2& b) {
    return (a.position - b.position).norm() < 1.0 && std::abs(wrap_angle(a.yaw - b.yaw)) < 0.4;
}

Estimate about(const Pose2& pose, double position_sd, double yaw_sd) {
    return {pose, Vec3(squared(position_sd), squared(position_sd), squared(yaw_sd)).asDiagonal()};
}

/// The larger of two axes' deviations.
double deviation(const Estimate& estimate, int a, int b) {
    return std::sqrt(std::max(estimate.covariance(a, a), estimate.covariance(b, b)));
}

}  // namespace

Localiser::Localiser(const LocalisationConfig& config, std::uint64_t seed)
    : config_(config), particles_(config, RandomStream(seed, "agent", "localisation")) {}

void Localiser::reset() {
    particles_.spread_over_field();
    estimate_ = Estimate{};
    found_ = false;
    unexplained_ = 0;
    since_view_ = Pose2{};
    position_variance_ = yaw_variance_ = 0.0;
    location_ = Location{};
}

const Location& Localiser::update(const perception::View* view, const Pose2& odometry, bool upright,
                                  wire::Side side, double dt) {
    if (side == wire::Side::None) return location_;
    if (side != side_) {
        side_ = side;
        landmarks_ = team_landmarks(side);
    }
    predict(odometry, upright, dt);
    if (view != nullptr && upright) correct(*view);
    report();
    return location_;
}

void Localiser::predict(const Pose2& odometry, bool upright, double dt) {
    const Pose2 step = upright ? odometry : Pose2{};
    const double position_rate = upright ? config_.drift_position : config_.fallen_position;
    const double yaw_rate = upright ? config_.drift_yaw : config_.fallen_yaw;
    const double length = step.position.norm();
    const double position_variance =
        squared(config_.odometry_position * length) + squared(position_rate) * dt;
    const double yaw_variance = squared(config_.odometry_yaw * step.yaw) + squared(yaw_rate) * dt;

    // The heading's error turns a step sideways.
    const Vec2 moved = rotated(step.position, estimate_.pose.yaw);
    Mat3 transition = Mat3::Identity();
    transition(0, 2) = -moved.y();
    transition(1, 2) = moved.x();
    estimate_.pose = estimate_.pose.then(step);
    estimate_.covariance = transition * estimate_.covariance * transition.transpose();
    estimate_.covariance.diagonal() += Vec3(position_variance, position_variance, yaw_variance);

    since_view_ = since_view_.then(step);
    position_variance_ += position_variance;
    yaw_variance_ += yaw_variance;
}

void Localiser::correct(const perception::View& view) {
    if (view.landmarks.empty() && view.lines.empty()) return;
    const bool sure = found_ && estimate_.covariance(2, 2) < squared(kSureYaw);
    if (sure) {
        const Fit fit = refine(view, landmarks_, estimate_);
        if (fit.share >= config_.explained_share) {
            estimate_ = fit.estimate;
            unexplained_ = 0;
            return;
        }
    }
    // Particles cost ten times the rest, and nobody asks them while the estimate explains the views:
    // they start where it is when it ceases to.
    if (found_ && unexplained_ == 0) {
        particles_.gather(estimate_.pose, deviation(estimate_, 0, 1), deviation(estimate_, 2, 2));
    } else {
        particles_.move(since_view_, std::sqrt(position_variance_), std::sqrt(yaw_variance_));
    }
    since_view_ = Pose2{};
    position_variance_ = yaw_variance_ = 0.0;
    const SensedPoses sensed = sensed_poses(view, landmarks_);
    const Cluster cluster = particles_.weigh(view, landmarks_, sensed);
    ++unexplained_;
    if (sure && unexplained_ < config_.lost_after) return;
    if (seek(view, sensed, cluster)) {
        found_ = true;
        unexplained_ = 0;
    }
}

/// Takes the best of what memory, particles and this view alone propose, if it explains the view
/// and nothing else explains it as well.
bool Localiser::seek(const perception::View& view, const SensedPoses& sensed,
                     const Cluster& cluster) {
    Fit best;
    double best_score = -1.0;
    double rival_score = -1.0;  // best score of a pose elsewhere
    const auto consider = [&](const Estimate& prior) {
        const Fit fit = refine(view, landmarks_, prior);
        if (fit.share < config_.explained_share) return;
        const bool likely =
            cluster.weight >= kSureShare && same_place(fit.estimate.pose, cluster.pose);
        const double score = fit.share + (likely ? kClusterBonus : 0.0);
        const bool elsewhere =
            best_score >= 0.0 && !same_place(fit.estimate.pose, best.estimate.pose);
        if (elsewhere) rival_score = std::max(rival_score, std::min(score, best_score));
        if (score > best_score) {
            best_score = score;
            best = fit;
        }
    };
    for (int k = 0; k < sensed.count; ++k) {
        consider(about(sensed.pose[static_cast<std::size_t>(k)], 2.0, 0.5));
    }
    consider(about(cluster.pose, 1.0, 0.3));
    if (found_) consider(estimate_);
    const bool told_apart = best_score - rival_score >= kAmbiguous;
    // Lines alone look the same from many places: without a landmark the cluster must agree.
    const bool anchored = best.landmarks > 0 || best_score > best.share;
    if (best_score < 0.0 || !told_apart || !anchored) return false;
    estimate_ = best.estimate;
    return true;
}

void Localiser::report() {
    location_.pose = estimate_.pose;
    const double variance = std::max(estimate_.covariance(0, 0), estimate_.covariance(1, 1));
    location_.position_sd = std::sqrt(variance + squared(kSystematicPosition));
    location_.yaw_sd = std::sqrt(estimate_.covariance(2, 2) + squared(kSystematicYaw));
    location_.localised = found_ && unexplained_ < config_.lost_after &&
                          location_.position_sd < config_.localised_position &&
                          location_.yaw_sd < config_.localised_yaw;
}

}  // namespace k3d::agent::localisation

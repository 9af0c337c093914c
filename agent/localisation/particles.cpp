// SPDX-License-Identifier: BSD-3-Clause
#include "agent/localisation/particles.h"

#include <algorithm>

namespace k3d::agent::localisation {

namespace {

constexpr double kHalfLength = field::kLength / 2.0;
constexpr double kHalfWidth = field::kWidth / 2.0;
constexpr double kPenaltyX = kHalfLength - field::kPenaltyLength;
constexpr double kPenaltyY = field::kPenaltyWidth / 2.0;

// Deviations as a coarse filter needs them, and what one sighting may cost at most.
constexpr double kOffsetSd = 0.10;    // m
constexpr double kDistanceSd = 0.02;  // share of the distance
constexpr double kAngleSd = 0.04;     // rad
constexpr double kHeadingSd = 0.06;   // rad, of a line
constexpr double kMaxCost = 16.0;
constexpr double kStraightLength = 1.4;  // m: longer than any chord of the centre circle
constexpr double kEndMargin = 0.5;       // m
constexpr std::size_t kMaxLines = 8;     // more add cost, not knowledge

constexpr double kSlowRate = 0.02;  // of the two means of fit
constexpr double kFastRate = 0.2;
constexpr double kSteadyInjection = 0.01;
constexpr double kSensedPositionSd = 0.3;  // m
constexpr double kSensedYawSd = 0.05;      // rad
constexpr double kJitterPosition = 0.03;   // m, after a draw: keeps copies apart
constexpr double kJitterYaw = 0.01;        // rad

/// Squared misfit of a straight sighting to the nearest straight line of the same direction. The
/// field is symmetric in both axes, so one quadrant is enough.
double line_cost(const Vec2& middle, const Vec2& heading, double offset_weight) {
    const double ax = std::abs(middle.x());
    const double ay = std::abs(middle.y());
    double off = 1e9;
    double turn = 0.0;
    if (std::abs(heading.x()) > std::abs(heading.y())) {
        turn = heading.y();
        if (ax < kHalfLength + kEndMargin) {
            off = std::abs(ay - kHalfWidth);
            if (ax > kPenaltyX - kEndMargin) off = std::min(off, std::abs(ay - kPenaltyY));
        }
    } else {
        turn = heading.x();
        if (ay < kHalfWidth + kEndMargin) {
            off = std::min(ax, std::abs(ax - kHalfLength));
            if (ay < kPenaltyY + kEndMargin) off = std::min(off, std::abs(ax - kPenaltyX));
        }
    }
    return squared(off) * offset_weight + squared(turn) * (1.0 / squared(kHeadingSd));
}

}  // namespace

Particles::Particles(const LocalisationConfig& config, RandomStream random)
    : config_(config), random_(random) {
    particles_.resize(static_cast<std::size_t>(config.particles));
    drawn_.resize(particles_.size());
    spread_over_field();
}

void Particles::spread_over_field() {
    for (Particle& particle : particles_) {
        particle.position = {random_.uniform(-kHalfLength, kHalfLength),
                             random_.uniform(-kHalfWidth, kHalfWidth)};
        particle.yaw = random_.uniform(-kPi, kPi);
        particle.weight = 1.0;
    }
    forget_fit();
}

void Particles::gather(const Pose2& pose, double position_sd, double yaw_sd) {
    const double position = position_sd + kSensedPositionSd;
    const double yaw = yaw_sd + kSensedYawSd;
    for (Particle& particle : particles_) {
        particle = {pose.position + Vec2(jitter(position), jitter(position)), pose.yaw + jitter(yaw), 1.0};
    }
    forget_fit();
}

/// As after fits that were good and are not any more: sensed poses come in at once.
void Particles::forget_fit() {
    fit_slow_ = 1.0;
    fit_fast_ = 0.0;
}

/// Triangular noise of the given deviation: as good as a normal one here, and cheaper.
double Particles::jitter(double deviation) {
    return deviation * 2.449489742783178 * (random_.uniform() + random_.uniform() - 1.0);
}

void Particles::move(const Pose2& step, double position_sd, double yaw_sd) {
    for (Particle& particle : particles_) {
        particle.position +=
            rotated(step.position, particle.yaw) + Vec2(jitter(position_sd), jitter(position_sd));
        particle.yaw += step.yaw + jitter(yaw_sd);
    }
}

void Particles::prepare(const perception::View& view, const Landmarks& landmarks) {
    marks_.clear();
    for (const auto& sight : view.landmarks) {
        const double d2 = std::max(sight.position.squaredNorm(), 0.01);
        marks_.push_back({sight.position, landmarks[static_cast<std::size_t>(sight.landmark)],
                          1.0 / d2, 1.0 / (squared(kOffsetSd) + d2 * squared(kDistanceSd)),
                          1.0 / (squared(kOffsetSd) + d2 * squared(kAngleSd))});
    }
    straights_.clear();
    for (const auto& sight : view.lines) {
        if (sight.length < kStraightLength || straights_.size() == kMaxLines) continue;
        const Vec2 middle = 0.5 * (sight.begin + sight.end);
        straights_.push_back({middle, (sight.end - sight.begin) / sight.length,
                              1.0 / squared(kOffsetSd + kAngleSd * middle.norm())});
    }
}

double Particles::cost(const Particle& particle) const {
    const double c = std::cos(particle.yaw);
    const double s = std::sin(particle.yaw);
    const auto turned = [c, s](const Vec2& v) {
        return Vec2(c * v.x() - s * v.y(), s * v.x() + c * v.y());
    };
    double sum = 0.0;
    for (const Mark& mark : marks_) {
        const Vec2 arm = turned(mark.seen);
        const Vec2 error = particle.position + arm - mark.truth;
        const double along2 = squared(error.dot(arm)) * mark.inverse_d2;
        const double across2 = std::max(error.squaredNorm() - along2, 0.0);
        sum += std::min(kMaxCost, along2 * mark.along_weight + across2 * mark.across_weight);
    }
    for (const Straight& line : straights_) {
        sum += std::min(kMaxCost, line_cost(particle.position + turned(line.middle),
                                            turned(line.heading), line.offset_weight));
    }
    return sum;
}

Cluster Particles::best_cluster() const {
    const auto best =
        std::max_element(particles_.begin(), particles_.end(),
                         [](const Particle& a, const Particle& b) { return a.weight < b.weight; });
    Vec2 offset = Vec2::Zero();
    double turn = 0.0;
    double weight = 0.0;
    double total = 0.0;
    for (const Particle& particle : particles_) {
        total += particle.weight;
        const Vec2 apart = particle.position - best->position;
        if (apart.squaredNorm() > 1.0) continue;
        const double angle = wrap_angle(particle.yaw - best->yaw);
        if (std::abs(angle) > radians(30.0)) continue;
        offset += particle.weight * apart;
        turn += particle.weight * angle;
        weight += particle.weight;
    }
    if (weight <= 0.0) return {{best->position, best->yaw}, 0.0};
    return {{best->position + offset / weight, wrap_angle(best->yaw + turn / weight)},
            weight / total};
}

void Particles::resample(const SensedPoses& sensed, double injected_share) {
    double total = 0.0;
    for (const Particle& particle : particles_) total += particle.weight;
    const double spacing = total / static_cast<double>(particles_.size());
    double mark = random_.uniform() * spacing;
    double passed = particles_.front().weight;
    std::size_t source = 0;
    for (Particle& drawn : drawn_) {
        while (passed < mark && source + 1 < particles_.size())
            passed += particles_[++source].weight;
        mark += spacing;
        if (sensed.count > 0 && random_.uniform() < injected_share) {
            const Pose2& pose = sensed.pose[static_cast<std::size_t>(random_.below(sensed.count))];
            drawn = {pose.position + Vec2(jitter(kSensedPositionSd), jitter(kSensedPositionSd)),
                     pose.yaw + jitter(kSensedYawSd), 1.0};
        } else {
            const Particle& from = particles_[source];
            drawn = {from.position + Vec2(jitter(kJitterPosition), jitter(kJitterPosition)),
                     from.yaw + jitter(kJitterYaw), 1.0};
        }
    }
    particles_.swap(drawn_);
}

Cluster Particles::weigh(const perception::View& view, const Landmarks& landmarks,
                         const SensedPoses& sensed) {
    if (view.landmarks.empty() && view.lines.empty()) return best_cluster();
    prepare(view, landmarks);
    double least = 1e18;
    for (Particle& particle : particles_) {
        particle.weight = cost(particle);  // turned into a weight below
        least = std::min(least, particle.weight);
    }
    for (Particle& particle : particles_) {
        particle.weight = std::exp(-0.5 * (particle.weight - least));
    }
    // The best particle's cost per sighting measures the fit, whatever the number of sightings.
    const auto sightings = static_cast<double>(view.landmarks.size() + view.lines.size());
    const double fit = std::exp(-0.5 * least / sightings);
    fit_slow_ += kSlowRate * (fit - fit_slow_);
    fit_fast_ += kFastRate * (fit - fit_fast_);
    const Cluster best = best_cluster();
    const double missing = std::max(0.0, 1.0 - fit_fast_ / fit_slow_);
    resample(sensed, std::min(config_.max_injection, std::max(kSteadyInjection, missing)));
    return best;
}

}  // namespace k3d::agent::localisation

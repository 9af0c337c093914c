// SPDX-License-Identifier: BSD-3-Clause
// Two poles of different length on one cart, to be balanced by pushing the cart: the benchmark of the
// NEAT paper (Stanley & Miikkulainen 2002, section 4.2; equations of A. Wieland, IJCNN 1991).
#pragma once

#include <array>
#include <cmath>
#include <deque>
#include <numeric>
#include <vector>

#include "common/network/network.h"

namespace k3d::optimizer::algorithm::testing {

/// Position m, velocity m/s of the cart; angle rad, angular velocity rad/s of long and short pole.
using PoleState = std::array<double, 6>;

constexpr double kDegree = 3.14159265358979323846 / 180.0;

inline PoleState derivative(const PoleState& s, double force) {
    constexpr double kGravity = -9.8;
    constexpr double kFriction = 2e-6;  // of the hinges
    constexpr std::array<double, 2> kHalfLength = {0.5, 0.05};
    constexpr std::array<double, 2> kMass = {0.1, 0.01};
    std::array<double, 2> sine{};
    std::array<double, 2> cosine{};
    std::array<double, 2> drag{};
    double push = force;
    double mass = 1.0;
    for (std::size_t i = 0; i < 2; ++i) {
        const double angle = s[2 + 2 * i];
        const double speed = s[3 + 2 * i];
        sine[i] = std::sin(angle);
        cosine[i] = std::cos(angle);
        const double inertia = kMass[i] * kHalfLength[i];
        drag[i] = kFriction * speed / inertia + kGravity * sine[i];
        push += inertia * speed * speed * sine[i] + 0.75 * kMass[i] * cosine[i] * drag[i];
        mass += kMass[i] * (1.0 - 0.75 * cosine[i] * cosine[i]);
    }
    const double acceleration = push / mass;
    PoleState d{s[1], acceleration, s[3], 0.0, s[5], 0.0};
    for (std::size_t i = 0; i < 2; ++i) {
        d[3 + 2 * i] = -0.75 * (acceleration * cosine[i] + drag[i]) / kHalfLength[i];
    }
    return d;
}

/// 0.02 s under a constant force: two Runge-Kutta steps of fourth order.
inline PoleState push_cart(PoleState s, double force) {
    constexpr double kStep = 0.01;
    const auto moved = [](const PoleState& from, const PoleState& along, double by) {
        PoleState to = from;
        for (std::size_t i = 0; i < 6; ++i) to[i] += by * along[i];
        return to;
    };
    for (int i = 0; i < 2; ++i) {
        const PoleState a = derivative(s, force);
        const PoleState b = derivative(moved(s, a, kStep / 2), force);
        const PoleState c = derivative(moved(s, b, kStep / 2), force);
        const PoleState d = derivative(moved(s, c, kStep), force);
        for (std::size_t k = 0; k < 6; ++k) s[k] += kStep / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    return s;
}

inline bool balanced(const PoleState& s) {
    return std::abs(s[0]) < 2.4 && std::abs(s[2]) < 36 * kDegree && std::abs(s[4]) < 36 * kDegree;
}

inline PoleState usual_start() { return {0.0, 0.0, 4.5 * kDegree, 0.0, 0.0, 0.0}; }

struct Balance {
    int steps = 0;        ///< until a limit was left, or `most`
    double wobble = 0.0;  ///< of the last 100 steps: |x| + |v| + |angle| + |rate|, summed
};

/// The network sees all six values, or the three that are no velocities; its output pushes.
inline Balance balance(const network::Network& net, PoleState s, bool velocities, int most) {
    network::State memory = net.start();
    std::deque<double> recent;
    std::vector<double> seen;
    Balance result;
    while (result.steps < most && balanced(s)) {
        if (velocities) {
            seen = {s[0] / 4.8, s[1] / 2.0, s[2] / 0.52, s[3] / 2.0, s[4] / 0.52, s[5] / 2.0};
        } else {
            seen = {s[0] / 4.8, s[2] / 0.52, s[4] / 0.52};
        }
        s = push_cart(s, 20.0 * (net.evaluate(seen, memory)[0] - 0.5));
        ++result.steps;
        if (velocities) continue;
        recent.push_back(std::abs(s[0]) + std::abs(s[1]) + std::abs(s[2]) + std::abs(s[3]));
        if (recent.size() > 100) recent.pop_front();
    }
    result.wobble = std::accumulate(recent.begin(), recent.end(), 0.0);
    return result;
}

/// Gruau's fitness: 0.1 of the time balanced and 0.9 of how calmly, over 1,000 steps.
inline double calm_fitness(const network::Network& net) {
    const Balance b = balance(net, usual_start(), false, 1000);
    const double calm = b.steps < 100 ? 0.0 : 0.75 / b.wobble;
    return 0.1 * b.steps / 1000.0 + 0.9 * calm;
}

/// Of 625 starts, five values each of position, velocity, long pole's angle and rate, how many the
/// network balances for 1,000 steps.
inline int generalisation(const network::Network& net) {
    constexpr std::array<double, 5> kShare = {0.05, 0.25, 0.5, 0.75, 0.95};
    int good = 0;
    for (const double x : kShare) {
        for (const double v : kShare) {
            for (const double angle : kShare) {
                for (const double rate : kShare) {
                    const PoleState s{4.32 * x - 2.16,       2.7 * v - 1.35,
                                      (7.2 * angle - 3.6) * kDegree, (17.2 * rate - 8.6) * kDegree,
                                      0.0,                   0.0};
                    good += balance(net, s, false, 1000).steps == 1000 ? 1 : 0;
                }
            }
        }
    }
    return good;
}

}  // namespace k3d::optimizer::algorithm::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/survival.h"

#include <algorithm>
#include <cmath>

#include "common/log/log.h"
#include "common/random/stream.h"
#include "optimizer/report/bootstrap.h"

namespace k3d::optimizer::report {

namespace {

struct Sums {
    double watched_s = 0.0;
    std::size_t ended = 0;

    void add(const Lifetime& life) {
        watched_s += life.s;
        ended += life.ended ? 1 : 0;
    }
    std::optional<double> s_per_end() const {
        if (ended == 0) return std::nullopt;
        return watched_s / static_cast<double>(ended);
    }
};

std::optional<double> ratio_of(const Sums& a, const Sums& b) {
    const auto of_a = a.s_per_end(), of_b = b.s_per_end();
    if (!of_a || !of_b || !(*of_b > 0.0)) return std::nullopt;
    return *of_a / *of_b;
}

void add_interval(const std::vector<Lifetime>& a, const std::vector<Lifetime>& b,
                  SurvivalTest& out) {
    const auto ratio = [&](const std::vector<std::size_t>& drawn) {
        Sums of_a, of_b;
        for (const std::size_t k : drawn) {
            of_a.add(a[k]);
            of_b.add(b[k]);
        }
        return ratio_of(of_a, of_b);
    };
    const auto interval = bootstrap_95(a.size(), RandomStream(1, "survival", "bootstrap"), ratio);
    if (!interval) return;
    out.ratio_low = interval->low;
    out.ratio_high = interval->high;
}

/// At each time at which one ends: how many of `a` did, less how many would have if all under watch
/// were alike.
double log_rank_p(const std::vector<Lifetime>& a, const std::vector<Lifetime>& b) {
    struct Watched {
        Lifetime life;
        bool of_a;
    };
    std::vector<Watched> all;
    for (const Lifetime& life : a) all.push_back({life, true});
    for (const Lifetime& life : b) all.push_back({life, false});
    std::stable_sort(all.begin(), all.end(),
                     [](const Watched& x, const Watched& y) { return x.life.s < y.life.s; });
    auto at_risk = static_cast<double>(all.size());
    auto at_risk_of_a = static_cast<double>(a.size());
    double excess = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < all.size();) {
        double ended = 0.0, ended_of_a = 0.0, left = 0.0, left_of_a = 0.0;
        const double now = all[i].life.s;
        for (; i < all.size() && all[i].life.s == now; ++i) {
            left += 1.0;
            left_of_a += all[i].of_a ? 1.0 : 0.0;
            ended += all[i].life.ended ? 1.0 : 0.0;
            ended_of_a += all[i].life.ended && all[i].of_a ? 1.0 : 0.0;
        }
        const double share = at_risk_of_a / at_risk;
        excess += ended_of_a - ended * share;
        if (at_risk > 1.0) {
            variance += ended * share * (1.0 - share) * (at_risk - ended) / (at_risk - 1.0);
        }
        at_risk -= left;
        at_risk_of_a -= left_of_a;
    }
    if (!(variance > 0.0)) return 1.0;
    return std::erfc(std::abs(excess) / std::sqrt(2.0 * variance));
}

}  // namespace

Survival survival(const std::vector<Lifetime>& sample) {
    Sums sums;
    for (const Lifetime& life : sample) sums.add(life);
    return {sums.ended, sample.size() - sums.ended, sums.s_per_end()};
}

std::optional<SurvivalTest> survival_test(const std::vector<Lifetime>& a,
                                          const std::vector<Lifetime>& b) {
    K3D_ASSERT(a.size() == b.size());
    if (a.size() < 2) return std::nullopt;
    Sums of_a, of_b;
    for (const Lifetime& life : a) of_a.add(life);
    for (const Lifetime& life : b) of_b.add(life);
    SurvivalTest out;
    out.pairs = a.size();
    out.ratio = ratio_of(of_a, of_b);
    if (out.ratio) add_interval(a, b, out);
    out.p_log_rank = log_rank_p(a, b);
    return out;
}

}  // namespace k3d::optimizer::report

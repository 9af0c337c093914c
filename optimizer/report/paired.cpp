// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/paired.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "common/log/log.h"
#include "common/random/stream.h"
#include "optimizer/report/bootstrap.h"
#include "optimizer/report/run_text.h"
#include "optimizer/report/statistics.h"

namespace k3d::optimizer::report {

namespace {

constexpr int kFlips = 20000;  // the smallest p that can be told is 1 / 20001
constexpr std::size_t kCountedPairs = 14;  // up to here all signs are fewer than kFlips

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// `sum` and the values, each with the sign that its bit says.
double add_signed(double sum, std::span<const double> values, std::uint64_t signs) {
    for (const double value : values) {
        sum += (signs & 1) != 0 ? value : -value;
        signs >>= 1;
    }
    return sum;
}

double drawn_signs(std::span<const double> differences, double as_far_as) {
    RandomStream stream(1, "paired", "permutation");
    int as_far = 1;  // the sample itself is one of the permutations
    for (int i = 0; i < kFlips; ++i) {
        double flipped = 0.0;
        for (std::size_t at = 0; at < differences.size(); at += 64) {
            const std::size_t count = std::min<std::size_t>(64, differences.size() - at);
            flipped = add_signed(flipped, differences.subspan(at, count), stream.next());
        }
        as_far += std::abs(flipped) >= as_far_as;
    }
    return static_cast<double>(as_far) / (kFlips + 1.0);
}

double all_signs(std::span<const double> differences, double as_far_as) {
    const std::uint64_t patterns = std::uint64_t{1} << differences.size();
    int as_far = 0;
    for (std::uint64_t signs = 0; signs < patterns; ++signs) {
        as_far += std::abs(add_signed(0.0, differences, signs)) >= as_far_as;
    }
    return static_cast<double>(as_far) / static_cast<double>(patterns);
}

double permutation(const std::vector<double>& differences) {
    double size = 0.0;
    for (const double difference : differences) size += std::abs(difference);
    // Rounding must not make a permutation of equal worth count as less.
    const double as_far_as = std::abs(sum(differences)) - 1e-12 * size;
    return differences.size() <= kCountedPairs ? all_signs(differences, as_far_as)
                                               : drawn_signs(differences, as_far_as);
}

/// Zeros are left out, ties share their ranks and lessen the variance.
double wilcoxon(std::vector<double> d) {
    std::erase(d, 0.0);
    if (d.empty()) return 1.0;
    std::sort(d.begin(), d.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
    const auto n = static_cast<double>(d.size());
    double positive = 0.0;
    double ties = 0.0;
    for (std::size_t i = 0; i < d.size();) {
        std::size_t end = i;
        while (end < d.size() && std::abs(d[end]) == std::abs(d[i])) ++end;
        const double rank = 0.5 * static_cast<double>(i + end + 1);
        const auto t = static_cast<double>(end - i);
        ties += t * t * t - t;
        for (; i < end; ++i) positive += d[i] > 0.0 ? rank : 0.0;
    }
    const double mean = n * (n + 1.0) / 4.0;
    const double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ties / 48.0;
    if (!(variance > 0.0)) return 1.0;
    const double z = std::max(0.0, std::abs(positive - mean) - 0.5) / std::sqrt(variance);
    return std::erfc(z / std::sqrt(2.0));
}

void add_ratio(const std::vector<double>& a, const std::vector<double>& b, Paired& out) {
    // A ratio says something of amounts alone.
    const auto negative = [](double value) { return value < 0.0; };
    if (std::any_of(a.begin(), a.end(), negative) || std::any_of(b.begin(), b.end(), negative)) return;
    if (!(sum(b) > 0.0)) return;
    out.ratio = sum(a) / sum(b);
    const auto ratio = [&](const std::vector<std::size_t>& drawn) -> std::optional<double> {
        double of_a = 0.0, of_b = 0.0;
        for (const std::size_t k : drawn) {
            of_a += a[k];
            of_b += b[k];
        }
        return of_b > 0.0 ? std::optional(of_a / of_b) : std::nullopt;
    };
    const auto interval = bootstrap_95(a.size(), RandomStream(1, "paired", "bootstrap"), ratio);
    if (!interval) return;
    out.ratio_low = interval->low;
    out.ratio_high = interval->high;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const Statistics of_a = statistics(a), of_b = statistics(b);
    if (!(*of_a.sd > 0.0) || !(*of_b.sd > 0.0)) return 0.0;
    double product = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) product += (a[i] - *of_a.mean) * (b[i] - *of_b.mean);
    return product / (static_cast<double>(a.size() - 1) * *of_a.sd * *of_b.sd);
}

}  // namespace

std::pair<std::vector<double>, std::vector<double>> trial_pairs(const std::map<int, double>& a,
                                                                const std::map<int, double>& b,
                                                                int scenarios) {
    struct Sums {
        double a = 0.0, b = 0.0, n = 0.0;
    };
    std::map<int, Sums> by_trial;
    for (const auto& [episode, value] : a) {
        const auto other = b.find(episode);
        if (other == b.end()) continue;
        Sums& sums = by_trial[scenarios > 0 ? episode % scenarios : episode];
        sums.a += value;
        sums.b += other->second;
        sums.n += 1.0;
    }
    std::pair<std::vector<double>, std::vector<double>> out;
    for (const auto& [trial, sums] : by_trial) {
        out.first.push_back(sums.a / sums.n);
        out.second.push_back(sums.b / sums.n);
    }
    return out;
}

std::optional<Paired> paired(const std::vector<double>& a, const std::vector<double>& b) {
    K3D_ASSERT(a.size() == b.size());
    if (a.size() < 2) return std::nullopt;
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
    const Statistics s = statistics(differences);
    Paired out;
    out.n = a.size();
    out.difference = *s.mean;
    out.low = *s.mean - *half_width_95(s);
    out.high = *s.mean + *half_width_95(s);
    out.p_permutation = permutation(differences);
    out.p_wilcoxon = wilcoxon(differences);
    out.correlation = correlation(a, b);
    add_ratio(a, b, out);
    return out;
}

std::vector<double> holm(const std::vector<double>& p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
        return p[x] != p[y] ? p[x] < p[y] : x < y;
    });
    std::vector<double> out(p.size(), 1.0);
    double least = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        least = std::max(least, p[order[i]] * static_cast<double>(p.size() - i));
        out[order[i]] = std::min(1.0, least);
    }
    return out;
}

}  // namespace k3d::optimizer::report

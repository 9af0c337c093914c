// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/coordinates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/log/log.h"
#include "optimizer/algorithm/error.h"

namespace k3d::optimizer::algorithm {
namespace {

constexpr double kMarginShare = 0.05;  // of the interval, at each end
constexpr double kLargest = 1e15;      // beyond, doubles no longer tell whole numbers apart

double margin(double lower, double upper, double scale) {
    return std::isfinite(lower) && std::isfinite(upper) ? kMarginShare * (upper - lower) : scale;
}

/// u folded like a mirror into [lower - margin, upper + margin].
double fold(double u, double low, double high) {
    if (!std::isfinite(high)) return u < low ? low + (low - u) : u;
    if (!std::isfinite(low)) return u > high ? high - (u - high) : u;
    const double period = 2.0 * (high - low);
    double phase = std::fmod(u - low, period);
    if (phase < 0.0) phase += period;
    return low + std::min(phase, period - phase);
}

[[noreturn]] void refuse(const spec::Parameter& p, const std::string& what) {
    throw AlgorithmError(fmt::format("parameter \"{}\": {}", p.name, what));
}

void check(const spec::Parameter& p) {
    if (p.name.empty()) throw AlgorithmError("a parameter has an empty name");
    if (!std::isfinite(p.start)) refuse(p, fmt::format("start {} is not finite", p.start));
    if (std::abs(p.start) > kLargest) refuse(p, fmt::format("start {} is too large", p.start));
    if (std::isnan(p.lower) || std::isnan(p.upper)) refuse(p, "a bound is not a number");
    if (p.lower >= p.upper && !p.frozen) {
        refuse(p, fmt::format("lower bound {} is not below upper bound {}", p.lower, p.upper));
    }
    if (p.start < p.lower || p.start > p.upper) {
        refuse(p, fmt::format("start {} is outside its bounds {} to {}", p.start, p.lower, p.upper));
    }
    if (p.frozen) {
        if (p.integer && p.start != std::round(p.start)) {
            refuse(p, fmt::format("start {} is not a whole number", p.start));
        }
        return;
    }
    if (!std::isfinite(p.deviation) || p.deviation <= 0.0) {
        refuse(p, fmt::format("deviation {} is not above 0", p.deviation));
    }
    if (p.integer && std::floor(p.upper) < std::ceil(p.lower)) {
        refuse(p, fmt::format("no whole number lies within {} to {}", p.lower, p.upper));
    }
}

}  // namespace

double into_bounds(double u, double lower, double upper, double scale) {
    if (!std::isfinite(lower) && !std::isfinite(upper)) return u;
    const double m = margin(lower, upper, scale);
    const double x = fold(u, lower - m, upper + m);
    if (x < lower + m) return std::max(lower, lower + (x - (lower - m)) * (x - (lower - m)) / (4.0 * m));
    if (x > upper - m) return std::min(upper, upper - (x - (upper + m)) * (x - (upper + m)) / (4.0 * m));
    return x;
}

double out_of_bounds(double x, double lower, double upper, double scale) {
    if (!std::isfinite(lower) && !std::isfinite(upper)) return x;
    const double m = margin(lower, upper, scale);
    if (x < lower + m) return lower - m + 2.0 * std::sqrt(m * (x - lower));
    if (x > upper - m) return upper + m - 2.0 * std::sqrt(m * (upper - x));
    return x;
}

Coordinates::Coordinates(std::vector<spec::Parameter> parameters)
    : parameters_(std::move(parameters)) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
        const spec::Parameter& p = parameters_[i];
        check(p);
        if (!names.insert(p.name).second) refuse(p, "the name is used twice");
        if (!p.frozen) free_.push_back(i);
    }
    if (free_.empty()) throw AlgorithmError("there is no parameter to search: none, or all frozen");
    least_deviation_ = Eigen::VectorXd::Zero(dimension());
    for (int i = 0; i < dimension(); ++i) {
        const spec::Parameter& p = parameters_[free_[static_cast<std::size_t>(i)]];
        if (p.integer) least_deviation_[i] = 0.25 / p.deviation;
    }
}

Eigen::VectorXd Coordinates::start() const {
    Eigen::VectorXd point(dimension());
    for (int i = 0; i < dimension(); ++i) {
        const spec::Parameter& p = parameters_[free_[static_cast<std::size_t>(i)]];
        point[i] = (out_of_bounds(p.start, p.lower, p.upper, p.deviation) - p.start) / p.deviation;
    }
    return point;
}

Eigen::VectorXd Coordinates::random_start(RandomStream& stream) const {
    Eigen::VectorXd point(dimension());
    for (int i = 0; i < dimension(); ++i) {
        const spec::Parameter& p = parameters_[free_[static_cast<std::size_t>(i)]];
        const bool bounded = std::isfinite(p.lower) && std::isfinite(p.upper);
        const double x = bounded ? stream.uniform(p.lower, p.upper)
                                 : into_bounds(p.start + p.deviation * stream.normal(), p.lower,
                                               p.upper, p.deviation);
        point[i] = (out_of_bounds(x, p.lower, p.upper, p.deviation) - p.start) / p.deviation;
    }
    return point;
}

std::vector<double> Coordinates::values(const Eigen::VectorXd& point) const {
    K3D_ASSERT(point.size() == dimension());
    std::vector<double> values;
    for (const spec::Parameter& p : parameters_) values.push_back(p.start);
    for (int i = 0; i < dimension(); ++i) {
        const std::size_t index = free_[static_cast<std::size_t>(i)];
        const spec::Parameter& p = parameters_[index];
        double x = into_bounds(p.start + p.deviation * point[i], p.lower, p.upper, p.deviation);
        if (p.integer) x = std::clamp(std::round(x), std::ceil(p.lower), std::floor(p.upper));
        values[index] = x;
    }
    return values;
}

}  // namespace k3d::optimizer::algorithm

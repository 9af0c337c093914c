// SPDX-License-Identifier: BSD-3-Clause
// Functions with known minima, and runs of an algorithm on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "optimizer/algorithm/algorithm.h"

namespace k3d::optimizer::algorithm::testing {

using Values = std::vector<double>;
using Function = std::function<double(const Values&)>;

inline double sphere(const Values& x) {
    double sum = 0.0;
    for (const double v : x) sum += v * v;
    return sum;
}

/// Axes between 1 and sqrt(condition), the last the steepest.
inline double ellipsoid(const Values& x, double condition = 1e6) {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(x.size() - 1);
        sum += std::pow(condition, share) * x[i] * x[i];
    }
    return sum;
}

inline double rosenbrock(const Values& x) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double bend = x[i + 1] - x[i] * x[i];
        sum += 100.0 * bend * bend + (1.0 - x[i]) * (1.0 - x[i]);
    }
    return sum;
}

inline spec::VectorProblem box(int n, double start, double deviation) {
    spec::VectorProblem problem;
    for (int i = 0; i < n; ++i) {
        spec::Parameter p;
        p.name = "x" + std::to_string(i);
        p.start = start;
        p.deviation = deviation;
        problem.push_back(p);
    }
    return problem;
}

struct Run {
    std::vector<double> best;  ///< of each generation, as minima
    double evaluations = 0;    ///< until the target was first met, or in all
    bool reached = false;
    std::string reason;
};

/// Minimises f until it is at most `target`, or `most` evaluations are spent.
inline Run minimise(Algorithm& algorithm, const Function& f, double target, double most) {
    Run run;
    while (!algorithm.finished() && run.evaluations < most) {
        double best = std::numeric_limits<double>::infinity();
        for (const Request& request : algorithm.ask()) {
            const double value = f(std::get<Values>(request.payload));
            algorithm.tell(request.candidate, request.pool, {-value, 0.0, 1});
            run.evaluations += 1;
            best = std::min(best, value);
            if (best <= target) {
                run.reached = true;
                return run;
            }
        }
        run.best.push_back(best);
        algorithm.advance();
    }
    run.reason = algorithm.finished().value_or("evaluations");
    return run;
}

inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace k3d::optimizer::algorithm::testing

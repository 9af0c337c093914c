// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/cmaes/distribution.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "common/log/log.h"

namespace k3d::optimizer::algorithm::cmaes {
namespace {

/// ln((lambda + 1) / 2) - ln i, the better half scaled to sum 1, the worse half as far below 0 as
/// keeps the covariance positive definite.
void set_weights(Constants& c, bool active) {
    const double n = c.n;
    Eigen::VectorXd raw(c.population);
    for (int i = 0; i < c.population; ++i) {
        raw[i] = std::log((c.population + 1.0) / 2.0) - std::log(i + 1.0);
    }
    c.parents = c.population / 2;
    const Eigen::VectorXd good = raw.head(c.parents);
    const Eigen::VectorXd bad = raw.tail(c.population - c.parents);
    c.mu_eff = good.sum() * good.sum() / good.squaredNorm();
    c.c_1 = 2.0 / ((n + 1.3) * (n + 1.3) + c.mu_eff);
    c.c_mu = std::min(1.0 - c.c_1, 2.0 * (0.25 + c.mu_eff + 1.0 / c.mu_eff - 2.0) /
                                       ((n + 2.0) * (n + 2.0) + c.mu_eff));
    if (c.separable) {
        // A diagonal has n unknowns instead of n^2 / 2: it may be learned faster.
        c.c_1 = std::min(1.0, c.c_1 * (n + 2.0) / 3.0);
        c.c_mu = std::min(1.0 - c.c_1, c.c_mu * (n + 2.0) / 3.0);
    }
    c.weights = Eigen::VectorXd::Zero(c.population);
    c.weights.head(c.parents) = good / good.sum();
    const double bad_sum = -bad.sum();
    if (!active || bad_sum <= 0.0) return;
    const double bad_mu_eff = bad_sum * bad_sum / bad.squaredNorm();
    double size = 1.0 + 2.0 * bad_mu_eff / (c.mu_eff + 2.0);
    if (c.c_mu > 0.0) {
        size = std::min({size, 1.0 + c.c_1 / c.c_mu, (1.0 - c.c_1 - c.c_mu) / (n * c.c_mu)});
    }
    c.weights.tail(c.population - c.parents) = bad / bad_sum * std::max(size, 0.0);
}

/// Axes and lengths of the covariance; false if it is no longer positive definite.
bool decompose(const Constants& c, Distribution& d) {
    if (c.separable) {
        if (!(d.covariance.minCoeff() > 0.0) || !d.covariance.allFinite()) return false;
        d.lengths = d.covariance.col(0).cwiseSqrt();
        return true;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(d.covariance);
    if (solver.info() != Eigen::Success || !(solver.eigenvalues().minCoeff() > 0.0)) return false;
    d.axes = solver.eigenvectors();
    d.lengths = solver.eigenvalues().cwiseSqrt();
    return true;
}

/// C^(-1/2) y
Eigen::VectorXd whiten(const Constants& c, const Distribution& d, const Eigen::VectorXd& y) {
    if (c.separable) return y.cwiseQuotient(d.lengths);
    return d.axes * (d.axes.transpose() * y).cwiseQuotient(d.lengths);
}

void update_covariance(const Constants& c, Distribution& d, const Eigen::MatrixXd& ranked,
                       double missing) {
    // Negative weights count per unit of Mahalanobis length: one long step must not turn C around.
    Eigen::VectorXd w = c.weights;
    for (int i = 0; i < c.population; ++i) {
        if (w[i] >= 0.0) continue;
        const double length = whiten(c, d, ranked.col(i)).squaredNorm();
        w[i] *= length > 0.0 ? c.n / length : 0.0;
    }
    const double keep = 1.0 + c.c_1 * missing - c.c_1 - c.c_mu * c.weights.sum();
    if (c.separable) {
        Eigen::VectorXd diagonal = keep * d.covariance.col(0) + c.c_1 * d.path_c.cwiseAbs2();
        diagonal += c.c_mu * (ranked.cwiseAbs2() * w);
        d.covariance = diagonal;
        return;
    }
    d.covariance *= keep;
    d.covariance += c.c_1 * d.path_c * d.path_c.transpose();
    d.covariance += c.c_mu * ranked * w.asDiagonal() * ranked.transpose();
    d.covariance = (0.5 * (d.covariance + d.covariance.transpose())).eval();
}

}  // namespace

int default_population(int n) { return 4 + static_cast<int>(std::floor(3.0 * std::log(n))); }

Constants constants(int n, int population, bool active, bool separable) {
    K3D_ASSERT(n >= 1 && population >= 2);
    Constants c;
    c.n = n;
    c.population = population;
    c.separable = separable;
    set_weights(c, active);
    c.c_sigma = (c.mu_eff + 2.0) / (n + c.mu_eff + 5.0);
    c.d_sigma = 1.0 + 2.0 * std::max(0.0, std::sqrt((c.mu_eff - 1.0) / (n + 1.0)) - 1.0) + c.c_sigma;
    c.c_c = (4.0 + c.mu_eff / n) / (n + 4.0 + 2.0 * c.mu_eff / n);
    c.chi_n = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
    return c;
}

Distribution start(const Constants& c, const Eigen::VectorXd& mean, double sigma) {
    Distribution d;
    d.mean = mean;
    d.sigma = sigma;
    if (c.separable) {
        d.covariance = Eigen::VectorXd::Ones(c.n);
    } else {
        d.covariance = Eigen::MatrixXd::Identity(c.n, c.n);
        d.axes = Eigen::MatrixXd::Identity(c.n, c.n);
    }
    d.lengths = Eigen::VectorXd::Ones(c.n);
    d.path_sigma = Eigen::VectorXd::Zero(c.n);
    d.path_c = Eigen::VectorXd::Zero(c.n);
    return d;
}

Eigen::MatrixXd draw_steps(const Constants& c, const Distribution& d, RandomStream& stream) {
    Eigen::MatrixXd steps(c.n, c.population);
    for (int k = 0; k < c.population; ++k) {
        for (int i = 0; i < c.n; ++i) steps(i, k) = d.lengths[i] * stream.normal();
    }
    if (!c.separable) steps = (d.axes * steps).eval();
    return steps;
}

Eigen::VectorXd deviations(const Constants& c, const Distribution& d) {
    if (c.separable) return d.covariance.col(0).cwiseSqrt();
    return d.covariance.diagonal().cwiseSqrt();
}

Eigen::VectorXd step_factors(const Constants& c, const Distribution& d,
                             const Eigen::VectorXd& least) {
    const Eigen::VectorXd now = d.sigma * deviations(c, d);
    Eigen::VectorXd factors = Eigen::VectorXd::Ones(c.n);
    for (int i = 0; i < c.n; ++i) {
        if (now[i] < least[i]) factors[i] = least[i] / now[i];
    }
    return factors;
}

void update(const Constants& c, Distribution& d, const Eigen::MatrixXd& ranked,
            const Eigen::VectorXd& factors) {
    const Eigen::VectorXd step = ranked.leftCols(c.parents) * c.weights.head(c.parents);
    d.mean += d.sigma * factors.cwiseProduct(step);
    d.generation += 1;

    d.path_sigma = (1.0 - c.c_sigma) * d.path_sigma +
                   std::sqrt(c.c_sigma * (2.0 - c.c_sigma) * c.mu_eff) * whiten(c, d, step);
    // A path that is too long says that sigma lags behind: the covariance must not learn from it.
    const double settled =
        std::sqrt(1.0 - std::pow(1.0 - c.c_sigma, 2.0 * d.generation));
    const double length = d.path_sigma.norm();
    const bool steady = length / settled < (1.4 + 2.0 / (c.n + 1.0)) * c.chi_n;
    d.path_c *= 1.0 - c.c_c;
    if (steady) d.path_c += std::sqrt(c.c_c * (2.0 - c.c_c) * c.mu_eff) * step;
    update_covariance(c, d, ranked, steady ? 0.0 : c.c_c * (2.0 - c.c_c));
    d.sigma *= std::exp(std::min(1.0, c.c_sigma / c.d_sigma * (length / c.chi_n - 1.0)));

    // The axes change slowly; n^3 work once in a while costs no more than the n^2 of every update.
    const double interval = 1.0 / (10.0 * c.n * (c.c_1 + c.c_mu));
    if (c.separable || d.generation - d.decomposed_at >= interval) {
        if (!decompose(c, d)) {  // rounding beat it: the shape is lost, position and size are not
            const Distribution fresh = start(c, d.mean, d.sigma * d.lengths.mean());
            d.covariance = fresh.covariance;
            d.axes = fresh.axes;
            d.lengths = fresh.lengths;
            d.path_c = fresh.path_c;
            d.sigma = fresh.sigma;
        }
        d.decomposed_at = d.generation;
    }
}

}  // namespace k3d::optimizer::algorithm::cmaes

// SPDX-License-Identifier: BSD-3-Clause
// The normal distribution of CMA-ES and its update from one ranked generation.
// Source: N. Hansen, The CMA Evolution Strategy: A Tutorial, arXiv 1604.00772 (constants of its
// table 1, update of its figure 6); separable: R. Ros & N. Hansen, PPSN X, 2008. The step of
// whole-number coordinates has a floor, as N. Hansen, INRIA RR-7751, 2011, advises.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/random/stream.h"
#include "optimizer/algorithm/state_json.h"

namespace k3d::optimizer::algorithm::cmaes {

/// What follows from the dimension and the population alone.
struct Constants {
    int n = 0;               ///< dimension
    int population = 0;      ///< lambda
    int parents = 0;         ///< mu: those with weights above 0
    bool separable = false;  ///< covariance without correlations
    Eigen::VectorXd weights;  ///< one per rank; the positive ones sum to 1
    double mu_eff = 0.0;
    double c_sigma = 0.0;
    double d_sigma = 0.0;
    double c_c = 0.0;
    double c_1 = 0.0;
    double c_mu = 0.0;
    double chi_n = 0.0;  ///< expected length of a standard normal vector
};

int default_population(int n);  ///< 4 + floor(3 ln n)

/// population >= 2, n >= 1. Active: the worse half has negative weights.
Constants constants(int n, int population, bool active, bool separable);

/// Mean, step size, covariance and paths: what changes from generation to generation.
struct Distribution {
    Eigen::VectorXd mean;
    double sigma = 1.0;
    Eigen::MatrixXd covariance;  ///< n x n; separable: its diagonal, n x 1
    Eigen::MatrixXd axes;        ///< eigenvectors in columns; separable: empty
    Eigen::VectorXd lengths;     ///< roots of the eigenvalues
    Eigen::VectorXd path_sigma;
    Eigen::VectorXd path_c;
    int generation = 0;          ///< updates so far
    int decomposed_at = 0;       ///< axes and lengths are of the covariance of this generation
};

Distribution start(const Constants& c, const Eigen::VectorXd& mean, double sigma);

/// Steps of one generation: columns y ~ N(0, C), a candidate is mean + sigma * factors * y.
Eigen::MatrixXd draw_steps(const Constants& c, const Distribution& d, RandomStream& stream);

/// 1, but more where sigma times the deviation of a coordinate is below `least`.
Eigen::VectorXd step_factors(const Constants& c, const Distribution& d, const Eigen::VectorXd& least);

/// `ranked`: the steps from the best candidate to the worst.
void update(const Constants& c, Distribution& d, const Eigen::MatrixXd& ranked,
            const Eigen::VectorXd& factors);

/// Standard deviation per coordinate, without sigma.
Eigen::VectorXd deviations(const Constants& c, const Distribution& d);

nlohmann::json save(const Distribution& d);
Distribution read_distribution(const Reader& reader, const Constants& c);

}  // namespace k3d::optimizer::algorithm::cmaes

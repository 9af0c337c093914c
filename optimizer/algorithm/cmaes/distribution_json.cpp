// SPDX-License-Identifier: BSD-3-Clause
// The distribution of CMA-ES as JSON.
#include <limits>

#include "optimizer/algorithm/cmaes/distribution.h"
#include "optimizer/algorithm/matrix_json.h"

namespace k3d::optimizer::algorithm::cmaes {

nlohmann::json save(const Distribution& d) {
    return {{"mean", exact_matrix(d.mean)},
            {"sigma", exact(d.sigma)},
            {"covariance", exact_matrix(d.covariance)},
            {"axes", exact_matrix(d.axes)},
            {"lengths", exact_matrix(d.lengths)},
            {"path_sigma", exact_matrix(d.path_sigma)},
            {"path_c", exact_matrix(d.path_c)},
            {"generation", d.generation},
            {"decomposed_at", d.decomposed_at}};
}

Distribution read_distribution(const Reader& reader, const Constants& c) {
    Distribution d;
    const int columns = c.separable ? 1 : c.n;
    d.mean = read_matrix(reader["mean"], c.n, 1);
    d.sigma = reader["sigma"].finite();
    if (d.sigma <= 0.0) reader["sigma"].fail("is not above 0");
    d.covariance = read_matrix(reader["covariance"], c.n, columns);
    d.axes = read_matrix(reader["axes"], c.separable ? 0 : c.n, c.separable ? 0 : c.n);
    d.lengths = read_matrix(reader["lengths"], c.n, 1);
    if (!(d.lengths.minCoeff() > 0.0)) reader["lengths"].fail("holds a length that is not above 0");
    const Eigen::VectorXd variances =
        c.separable ? Eigen::VectorXd(d.covariance.col(0)) : Eigen::VectorXd(d.covariance.diagonal());
    if (!(variances.minCoeff() > 0.0)) {
        reader["covariance"].fail("holds a variance that is not above 0");
    }
    d.path_sigma = read_matrix(reader["path_sigma"], c.n, 1);
    d.path_c = read_matrix(reader["path_c"], c.n, 1);
    d.generation = reader["generation"].integer(0, std::numeric_limits<int>::max() - 1);
    d.decomposed_at = reader["decomposed_at"].integer(0, d.generation);
    return d;
}

}  // namespace k3d::optimizer::algorithm::cmaes

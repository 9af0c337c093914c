// SPDX-License-Identifier: BSD-3-Clause
// From the space that vector algorithms search to parameter values, and back to a start.
//
// The search space has one coordinate per parameter that is not frozen, in first deviations from the
// start, and no bounds: u = start + deviation * y, then a smooth map takes u into the bounds. Inside
// the map is the identity; within a margin of a bound it is a parabola that meets the bound with
// slope 0; beyond, the space repeats as in a mirror. Clamping would pile samples up on the bound and
// spoil the covariance. Whole-number parameters are rounded last.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/random/stream.h"
#include "optimizer/spec/algorithm_spec.h"

namespace k3d::optimizer::algorithm {

class Coordinates {
  public:
    /// Throws AlgorithmError naming the parameter and the value that makes no sense.
    explicit Coordinates(std::vector<spec::Parameter> parameters);

    int dimension() const { return static_cast<int>(free_.size()); }
    /// The point whose values are the start (of whole-number parameters, before rounding).
    Eigen::VectorXd start() const;
    /// A start for a new attempt: uniform within bounds, normal about the start where there are none.
    Eigen::VectorXd random_start(RandomStream& stream) const;
    /// One value per parameter, frozen ones too, within the bounds.
    std::vector<double> values(const Eigen::VectorXd& point) const;
    /// Least useful standard deviation per coordinate: a quarter of a step where only whole numbers
    /// count, else 0. With less, all samples would round to the same number.
    const Eigen::VectorXd& least_deviation() const { return least_deviation_; }
    const std::vector<spec::Parameter>& parameters() const { return parameters_; }

  private:
    std::vector<spec::Parameter> parameters_;
    std::vector<std::size_t> free_;  // indices of parameters that are searched
    Eigen::VectorXd least_deviation_;
};

/// The map into [lower, upper], either of which may be infinite; `scale` > 0 gives the margin at a
/// bound whose opposite is infinite. Smooth, and monotone between the bounds.
double into_bounds(double u, double lower, double upper, double scale);
/// The u nearest the bounds with into_bounds(u) == x, for x within the bounds.
double out_of_bounds(double x, double lower, double upper, double scale);

}  // namespace k3d::optimizer::algorithm

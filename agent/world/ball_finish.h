// SPDX-License-Identifier: BSD-3-Clause
// Where a rolling ball will stop: the estimate of paper section 3.2.
//
// ballvel_i = (ballpos_i - ballpos_{i-1}) / (t_i - t_{i-1}); ballfinish_i = ballpos_i +
// alpha * ballvel_i; the answer is the discounted mean of these points, a point's weight falling
// with its age as exp(-age / lambda). Metres and seconds, any frame that stands still.
#pragma once

#include <optional>

#include "common/math/geometry.h"

namespace k3d::agent::world {

class BallFinish {
  public:
    BallFinish(double alpha, double lambda) : alpha_(alpha), lambda_(lambda) {}

    /// A new roll begins.
    void reset();
    /// A seen position; times must not decrease (an equal or earlier one is ignored).
    void add(const Vec2& position, double time);
    /// None until two positions of this roll were seen.
    std::optional<Vec2> estimate() const;

  private:
    double alpha_;   // s
    double lambda_;  // s
    std::optional<Vec2> last_;
    double last_time_ = 0.0;
    Vec2 sum_ = Vec2::Zero();  ///< numerator and denominator of the mean
    double weight_ = 0.0;
};

}  // namespace k3d::agent::world

// SPDX-License-Identifier: BSD-3-Clause
// Counts kicks and completed passes from ball contacts alone, so that any team's agents can be
// judged. Field frame, m.
#pragma once

#include <optional>
#include <vector>

#include "common/math/geometry.h"

namespace k3d::server::game {

/// The ball has left its toucher when it is this far from where it was last touched.
inline constexpr double kLeftDistance = 0.5;
/// A pass must have moved the ball this far from the kick.
inline constexpr double kPassDistance = 1.5;

class PassCounter {
  public:
    /// One cycle: who touched the ball, keepers and takers by id, and where it is.
    void update(const std::vector<int>& keepers, const std::vector<int>& takers, const Vec2& ball);

    int kicks() const { return kicks_; }
    int passes() const { return passes_; }

  private:
    void touched_by_keeper(int id, const Vec2& ball);

    struct Touch {
        int keeper;
        Vec2 ball;
        bool left;  ///< the ball has gone: this was a kick
    };
    std::optional<Touch> last_;
    int kicks_ = 0;
    int passes_ = 0;
};

}  // namespace k3d::server::game

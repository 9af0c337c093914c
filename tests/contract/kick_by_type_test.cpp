// SPDX-License-Identifier: BSD-3-Clause
// The kicks of types 1 and 3 in the server's physics; that the other types keep the common one.
#include <gtest/gtest.h>

#include "agent/motion/kick/kick_engine.h"
#include "agent/motion/kick_by_type.h"
#include "common/config/config.h"
#include "common/random/stream.h"
#include "contract/engine_rig.h"

namespace k3d::contract {
namespace {

using agent::motion::KickByType;
using agent::motion::kick_of_type;

/// Where the ball comes to rest ahead of its place, and whether the robot fell.
struct Outcome {
    double distance;
    bool fell;
};

Outcome kick_once(int type, bool left, const Vec2& ball_off) {
    const agent::kick::Config config = kick_of_type({}, {}, type);
    const KickByType by_type;
    const auto& own = type == 1 ? by_type.type_1 : by_type.type_3;
    const Vec2 place(own.ball_forward, left ? own.ball_outward : -own.ball_outward);
    EngineRig r(type);
    r.take(walk_stance(type), 0.5, 0.4);
    const Vec2 ball = r.rig.pose().to_global(place + ball_off);
    r.rig.ball().move({ball.x(), ball.y(), 0.0403});
    agent::kick::KickEngine engine{config};
    engine.start({place, 0.0, 5.0}, walk_stance(type));
    r.run(engine, 3.0);
    r.take(walk_stance(type), 0.0, 4.0);
    const Vec3 end = r.rig.ball().position();
    return {(Vec2(end.x(), end.y()) - ball).norm(), r.rig.tilt() > radians(20.0)};
}

class TypeWithAKick : public testing::TestWithParam<int> {};

TEST_P(TypeWithAKick, SendsAMisplacedBallFourMetresWithEitherFoot) {
    RandomStream random(3, "kick_by_type_test", "placement");
    constexpr int kKicks = 20;
    int good = 0;
    for (int n = 0; n < kKicks; ++n) {
        const Vec2 off(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01));
        const Outcome o = kick_once(GetParam(), n % 2 == 0, off);
        if (!o.fell && o.distance >= 4.0) ++good;
    }
    EXPECT_GE(good, kKicks * 3 / 4);
}

INSTANTIATE_TEST_SUITE_P(KickByType, TypeWithAKick, testing::Values(1, 3));

TEST(KickByType, OtherTypesTakeTheCommonKickAndOnlyTypeZeroKicksAside) {
    for (const int type : {0, 2, 4}) {
        agent::kick::Config common;
        agent::kick::Config own = kick_of_type(common, {}, type);
        common.farthest.on = common.slant.on = common.square.on = type == 0;
        EXPECT_EQ(config::print(config::describing(own)), config::print(config::describing(common)));
    }
}

}  // namespace
}  // namespace k3d::contract

// SPDX-License-Identifier: BSD-3-Clause
// The robot's table against the figures of the reference, written out here a second time.
#include "common/nao/model.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace k3d::nao {
namespace {

/// Centre of a body relative to the torso at zero pose: offsets summed up to the root.
Vec3 rest_position(const Model& model, int body) {
    Vec3 position = Vec3::Zero();
    for (int i = body; i >= 0; i = model.bodies[static_cast<std::size_t>(i)].parent) {
        position += model.bodies[static_cast<std::size_t>(i)].offset;
    }
    return position;
}

int body_named(const Model& model, std::string_view name) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        if (model.bodies[i].name == name) return static_cast<int>(i);
    }
    ADD_FAILURE() << "no body " << name;
    return 0;
}

struct Placed {
    const char* name;  // right side; the left mirrors x
    Vec3 position;
    double mass;
};

const std::vector<Placed>& type0_right_side() {
    static const std::vector<Placed> rows{
        {"rshoulder", {0.098, 0, 0.075}, 0.070},    {"rupperarm", {0.108, 0.02, 0.075}, 0.150},
        {"relbow", {0.098, 0.09, 0.084}, 0.035},    {"rlowerarm", {0.098, 0.14, 0.084}, 0.200},
        {"rhip1", {0.055, -0.01, -0.115}, 0.090},   {"rhip2", {0.055, -0.01, -0.115}, 0.125},
        {"rthigh", {0.055, 0, -0.155}, 0.275},      {"rshank", {0.055, 0.005, -0.280}, 0.225},
        {"rankle", {0.055, -0.005, -0.335}, 0.125}, {"rfoot", {0.055, 0.025, -0.375}, 0.200},
    };
    return rows;
}

TEST(NaoModel, Type0BodiesStandWhereTheReferenceHasThem) {
    const Model& m = model(0);
    EXPECT_EQ(m.bodies.size(), 23U);
    EXPECT_TRUE(rest_position(m, body_named(m, "neck")).isApprox(Vec3(0, 0, 0.09), 1e-12));
    EXPECT_TRUE(rest_position(m, body_named(m, "head")).isApprox(Vec3(0, 0, 0.155), 1e-12));
    for (const Placed& row : type0_right_side()) {
        const int right = body_named(m, row.name);
        const int left = body_named(m, "l" + std::string(row.name).substr(1));
        EXPECT_LT((rest_position(m, right) - row.position).norm(), 1e-12) << row.name;
        const Vec3 mirrored(-row.position.x(), row.position.y(), row.position.z());
        EXPECT_LT((rest_position(m, left) - mirrored).norm(), 1e-12) << row.name;
        EXPECT_EQ(m.bodies[static_cast<std::size_t>(right)].mass, row.mass) << row.name;
        EXPECT_EQ(m.bodies[static_cast<std::size_t>(left)].mass, row.mass) << row.name;
    }
}

struct Hinge {
    const char* effector;
    Vec3 point;  // relative to the torso at zero pose
    Vec3 axis;
    double right_min, right_max, left_min, left_max;  // degrees
};

const std::vector<Hinge>& type0_hinges() {
    static const std::vector<Hinge> rows{
        {"rae1", {0.098, 0, 0.075}, {1, 0, 0}, -120, 120, -120, 120},
        {"rae2", {0.098, 0, 0.075}, {0, 0, 1}, -95, 1, -1, 95},
        {"rae3", {0.098, 0.09, 0.084}, {0, 1, 0}, -120, 120, -120, 120},
        {"rae4", {0.098, 0.09, 0.084}, {0, 0, 1}, -1, 90, -90, 1},
        {"rle1", {0.055, -0.01, -0.115}, {-0.7071, 0, 0.7071}, -90, 1, -90, 1},
        {"rle2", {0.055, -0.01, -0.115}, {0, 1, 0}, -45, 25, -25, 45},
        {"rle3", {0.055, -0.01, -0.115}, {1, 0, 0}, -25, 100, -25, 100},
        {"rle4", {0.055, -0.005, -0.235}, {1, 0, 0}, -130, 1, -130, 1},
        {"rle5", {0.055, -0.005, -0.335}, {1, 0, 0}, -45, 75, -45, 75},
        {"rle6", {0.055, -0.005, -0.340}, {0, 1, 0}, -25, 45, -45, 25},
    };
    return rows;
}

const JointDef& joint_named(const Model& model, std::string_view effector) {
    for (const JointDef& joint : model.joints) {
        if (joint.effector == effector) return joint;
    }
    ADD_FAILURE() << "no joint " << effector;
    return model.joints[0];
}

TEST(NaoModel, Type0HingesStandWhereTheReferenceHasThem) {
    const Model& m = model(0);
    EXPECT_EQ(m.joints.size(), 22U);
    for (const Hinge& row : type0_hinges()) {
        const JointDef& right = joint_named(m, row.effector);
        const JointDef& left = joint_named(m, "l" + std::string(row.effector).substr(1));
        EXPECT_LT((rest_position(m, right.child) + right.anchor - row.point).norm(), 1e-12)
            << row.effector;
        const Vec3 mirrored(-row.point.x(), row.point.y(), row.point.z());
        EXPECT_LT((rest_position(m, left.child) + left.anchor - mirrored).norm(), 1e-12)
            << row.effector;
        EXPECT_LT((right.axis - row.axis.normalized()).norm(), 1e-12) << row.effector;
        EXPECT_NEAR(degrees(right.min), row.right_min, 1e-9) << row.effector;
        EXPECT_NEAR(degrees(right.max), row.right_max, 1e-9) << row.effector;
        EXPECT_NEAR(degrees(left.min), row.left_min, 1e-9) << row.effector;
        EXPECT_NEAR(degrees(left.max), row.left_max, 1e-9) << row.effector;
        EXPECT_EQ(right.max_rate, 6.1395) << row.effector;
    }
    EXPECT_LT((joint_named(m, "lle1").axis - Vec3(-0.7071, 0, -0.7071).normalized()).norm(), 1e-12);
}

TEST(NaoModel, MassesAndStandingHeightsOfAllTypes) {
    constexpr double heights[kTypeCount] = {0.385, 0.42164, 0.385, 0.440737, 0.385};
    for (int type = 0; type < kTypeCount; ++type) {
        const Model& m = model(type);
        EXPECT_EQ(m.type, type);
        EXPECT_NEAR(m.total_mass, 4.6071, 1e-9) << type;
        EXPECT_NEAR(m.standing_height, heights[type], 1e-6) << type;
        // The same height from the bodies: the sole is the foot box's lower face.
        const int foot = *m.body_of(Part::RFoot);
        const double sole =
            rest_position(m, foot).z() - m.bodies[static_cast<std::size_t>(foot)].size.z() / 2.0;
        EXPECT_NEAR(m.standing_height, -sole, 1e-12) << type;
    }
}

TEST(NaoModel, LegLengthsFollowFromTheHinges) {
    for (int type = 0; type < kTypeCount; ++type) {
        const Model& m = model(type);
        const auto hinge = [&m](std::string_view effector) -> Vec3 {
            const JointDef& joint = joint_named(m, effector);
            return rest_position(m, joint.child) + joint.anchor;
        };
        EXPECT_NEAR(hinge("rle3").z() - hinge("rle4").z(), m.thigh_length, 1e-12) << type;
        EXPECT_NEAR(hinge("rle4").z() - hinge("rle5").z(), m.shank_length, 1e-12) << type;
        EXPECT_NEAR(hinge("rle3").x(), m.hip_offset_x, 1e-12) << type;
        EXPECT_NEAR(hinge("rle3").z(), m.hip_offset_z, 1e-12) << type;
        EXPECT_NEAR(hinge("rle5").z() + m.standing_height, m.ankle_height, 1e-12) << type;
    }
}

TEST(NaoModel, WhatSetsTheTypesApart) {
    EXPECT_EQ(joint_named(model(2), "lle5").max_rate, 8.80667);
    EXPECT_EQ(joint_named(model(2), "rle6").max_rate, 3.47234);
    EXPECT_EQ(model(3).hip_offset_x, 0.072954143);
    const Model& toes = model(4);
    EXPECT_EQ(toes.bodies.size(), 25U);
    EXPECT_EQ(toes.joints.size(), 24U);
    const int toe = *toes.body_of(Part::LToe);
    EXPECT_EQ(toes.bodies[static_cast<std::size_t>(toe)].size.y(), 0.035517656);
    EXPECT_FALSE(model(0).body_of(Part::LToe));
    EXPECT_FALSE(is_type(5));
    EXPECT_FALSE(is_type(-1));
}

TEST(NaoModel, JointKMovesBodyKPlusOneAndParentsComeFirst) {
    for (int type = 0; type < kTypeCount; ++type) {
        const Model& m = model(type);
        ASSERT_EQ(m.bodies.size(), m.joints.size() + 1);
        for (std::size_t k = 0; k < m.joints.size(); ++k) {
            EXPECT_EQ(m.joints[k].child, static_cast<int>(k) + 1);
            EXPECT_LE(m.bodies[k + 1].parent, static_cast<int>(k));
        }
    }
}

TEST(NaoModel, NamesAreUniqueAndFoundBothWays) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < kJointCount; ++i) {
        const auto id = static_cast<JointId>(i);
        names.insert(effector_name(id));
        names.insert(perceptor_name(id));
        EXPECT_EQ(joint_by_effector(effector_name(id)), id);
        EXPECT_EQ(joint_by_perceptor(perceptor_name(id)), id);
    }
    EXPECT_EQ(names.size(), 2 * kJointCount);
    EXPECT_FALSE(joint_by_effector("rlj3"));
    EXPECT_FALSE(joint_by_perceptor(""));
    EXPECT_EQ(effector_name(JointId::RHipPitch), "rle3");
    EXPECT_EQ(perceptor_name(JointId::LElbow), "laj4");
}

}  // namespace
}  // namespace k3d::nao

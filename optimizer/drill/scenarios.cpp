// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/drill/scenarios.h"

#include <array>

#include "common/log/log.h"

namespace k3d::optimizer::drill {

namespace {

/// Ball velocity and target. Drawn once: balls that come to rest up to 2 m from the robot, most of
/// them in front, and targets 6 m from there, up to 100 degrees off the robot's first heading.
struct Row {
    double vx, vy, target_x, target_y;
};
using Table = std::array<Row, kScenarios>;

constexpr Table kTrain{{
    {-4.12, 2.11, 2.35, 4.52},
    {-6.23, 1.66, -3.41, -4.82},
    {-3.77, -0.59, 0.19, -5.74},
    {-4.47, -2.27, 2.76, -3.10},
    {-5.83, -2.07, -1.02, 3.83},
    {-5.64, 2.39, -0.09, 6.32},
    {-6.62, 1.71, -0.74, 5.85},
    {-3.32, -1.62, -1.05, 4.78},
    {-5.10, -2.05, 1.87, 1.37},
    {-3.96, -0.51, 2.71, -2.98},
    {-3.66, 0.81, 3.29, -1.12},
    {-4.23, 0.20, -0.40, 5.61},
}};

constexpr Table kValidation{{
    {-4.96, -1.02, -1.77, -6.47},
    {-5.62, -0.56, 1.13, 3.02},
    {-4.30, -1.23, 0.11, 4.35},
    {-3.70, 0.71, 3.50, 0.52},
    {-4.86, -1.06, -0.53, -6.05},
    {-4.56, 2.17, 2.81, 0.38},
    {-4.32, 0.72, -0.46, -4.98},
    {-5.35, 1.19, -2.04, -4.98},
    {-5.87, -2.01, -4.51, 4.62},
    {-4.92, -0.85, 1.03, 3.54},
    {-4.54, -1.32, -1.51, 4.90},
    {-5.61, -1.67, 2.14, -0.29},
}};

constexpr Table kTest{{
    {-5.70, -1.54, 1.65, 1.34},
    {-5.36, -2.42, -1.20, 3.85},
    {-6.54, -2.16, 0.57, -4.78},
    {-5.40, -1.40, -0.63, -6.13},
    {-6.09, -1.33, 1.53, -2.91},
    {-5.87, 0.56, 0.22, -3.91},
    {-3.82, -0.90, 2.66, -3.53},
    {-3.96, -0.23, 2.98, 1.82},
    {-4.83, -0.62, 2.48, 1.29},
    {-4.79, -2.15, 2.45, -3.34},
    {-5.01, -2.21, 1.39, -5.12},
    {-6.37, -0.88, 0.60, -4.04},
}};

const Pose2 kRobot{{-4.0, 0.0}, 0.0};

const Table& table(const std::string& name) {
    if (name == "train") return kTrain;
    if (name == "validation") return kValidation;
    K3D_ASSERT(name == "test");
    return kTest;
}

}  // namespace

Scenario scenario_of(const std::string& name, int index) {
    const Row& row = table(name)[static_cast<std::size_t>(index % kScenarios)];
    return {kRobot, {row.vx, row.vy}, {row.target_x, row.target_y}};
}

}  // namespace k3d::optimizer::drill

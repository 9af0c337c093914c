// SPDX-License-Identifier: BSD-3-Clause
// From an episode's result to the one number that is maximised.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "common/episode/result.h"
#include "optimizer/spec/task_spec.h"

namespace k3d::optimizer::fitness {

/// Name of what the task maximises: a figure, or of a drill the task's own fitness (drills.h).
std::string measure(const spec::TaskSpec& task);

/// A figure of the result by name: hold_time_s, attempts, kicks, passes_completed, falls (of all
/// players), or one of its metrics; "-" in front: less is better. The reason if it has none, or if
/// it is not finite: then the episode has given no valid result.
tl::expected<double, std::string> figure(const k3d::episode::Result& result,
                                         const std::string& name);

/// What the task maximises.
tl::expected<double, std::string> fitness(const spec::TaskSpec& task,
                                          const k3d::episode::Result& result);

/// Simulated time that the episode took, s: the metric of this name, else its time in play.
double simulated_s(const k3d::episode::Result& result);

}  // namespace k3d::optimizer::fitness

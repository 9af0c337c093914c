// SPDX-License-Identifier: BSD-3-Clause
// The figures that an episode of a task may be judged by.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace k3d::optimizer::spec {

/// Names of all figures that a result of the task can have, as `task.fitness` takes them, sorted. Not
/// every result has each of them: without a kick there is no time to it.
std::vector<std::string> figures_of(std::string_view task);

}  // namespace k3d::optimizer::spec

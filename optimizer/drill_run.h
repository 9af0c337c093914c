// SPDX-License-Identifier: BSD-3-Clause
// The subcommand `drill`: its flags, and its runs one after another.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace k3d::optimizer {

/// Adds the subcommand; what it returns carries it out, once parsed, and gives the exit code.
std::function<int()> add_drill_command(CLI::App& app);

}  // namespace k3d::optimizer

// SPDX-License-Identifier: BSD-3-Clause
// The subcommand `drill`: its flags, and its runs one after another.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace k3d::optimizer {

/// Adds it; when it is on the command line, `chosen` becomes what it does, and gives the exit code.
void add_drill_command(CLI::App& app, std::function<int()>& chosen);

}  // namespace k3d::optimizer

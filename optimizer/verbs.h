// SPDX-License-Identifier: BSD-3-Clause
// The subcommands around runs of experiments: run, resume, show, best, report, worker.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace k3d::optimizer {

/// Adds them; when one is on the command line, `chosen` becomes what it does, and gives the exit
/// code.
void add_run_verbs(CLI::App& app, std::function<int()>& chosen);

}  // namespace k3d::optimizer

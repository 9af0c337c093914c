// SPDX-License-Identifier: BSD-3-Clause
// The subcommand `reproduce`: the paper's experiments from one command.
//
//     OUT/search/NAME-RUN/      a run of an experiment, as `k3d-optimizer run` makes it
//     OUT/test/TABLE/ROW/       ledger of the test episodes of a row
//     OUT/report.html, tables.txt, tables.csv, searches.csv
//
// Whatever is finished is not done again; the same command goes on after an interruption.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace k3d::optimizer {

void add_reproduce_verb(CLI::App& app, std::function<int()>& chosen);

}  // namespace k3d::optimizer

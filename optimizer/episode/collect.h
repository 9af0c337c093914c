// SPDX-License-Identifier: BSD-3-Clause
// From the files that an episode's processes leave: its result, or why there is none.
#pragma once

#include <string>

#include "common/process/child.h"
#include "optimizer/episode/commands.h"
#include "optimizer/episode/task.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer::episode {

inline constexpr int kServerLostAnAgent = 3;  ///< exit code of k3d-server

/// The last line of a program's log that says something, "" if there is none.
std::string last_line(const std::string& log_file);

/// The end of a program that should not have ended: "keeper 2: exit code 2: unknown flag --x".
std::string describe_end(const std::string& name, const process::Exit& exit,
                         const std::string& log_file);

/// After the server has ended in `exit`, and the agents too: reads its result line, checks that it
/// is that of this task, and adds the keepers' attempts.
Ending collect(const spec::MatchSpec& spec, const Task& task, const std::string& folder,
               const process::Exit& exit);

}  // namespace k3d::optimizer::episode

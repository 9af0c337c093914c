// SPDX-License-Identifier: BSD-3-Clause
// Our programs asked before anything is played: what they can be told, and whether they take it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/process/child.h"
#include "optimizer/spec/settings.h"
#include "optimizer/spec/task_spec.h"

namespace k3d::optimizer::spec {

/// `wanted`, or if that is empty the program `name` in this program's own folder.
std::string program_path(const std::string& wanted, const char* name);

/// Of what one of our programs has printed, the last line that tells what was amiss.
std::string last_words(const std::string& text);

struct Answer {
    std::optional<process::Exit> exit;  ///< none: it did not end in half a minute, and was killed
    std::string text;                   ///< all that it printed
};

/// Runs a program and its flags. Throws process::StartError if it cannot be started.
Answer ask(const std::vector<std::string>& words);

/// Throws config::ConfigError, `what` and the program's own words, if a program of the task refuses
/// its settings: else the first episode that plays with them would tell, and that may be the test
/// after days of search. A program that cannot be asked here may be there where episodes are
/// played.
void require_taken(const std::string& what, const TaskSpec& task, const Settings& settings);

}  // namespace k3d::optimizer::spec

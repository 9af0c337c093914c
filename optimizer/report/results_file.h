// SPDX-License-Identifier: BSD-3-Clause
// The --results file: one EpisodeResult line per episode, in the order of episodes.
#pragma once

#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "optimizer/episode/task.h"

namespace k3d::optimizer::report {

/// Episodes end in any order; a line waits until all before it are settled, so that the file is the
/// same whatever ran beside what.
class ResultsFile {
  public:
    /// Empties the file; no path: writes nothing. Throws std::runtime_error naming a file that
    /// cannot be written.
    explicit ResultsFile(const std::string& path);

    /// Episode `index` is settled; one without any result leaves no line.
    void settle(int index, const std::optional<episode::Result>& result);

    /// Writes what waits still behind episodes that were never settled.
    void close();

  private:
    void write(const std::optional<episode::Result>& result);

    std::string path_;
    std::ofstream file_;
    int next_ = 0;
    std::map<int, std::optional<episode::Result>> waiting_;
};

}  // namespace k3d::optimizer::report

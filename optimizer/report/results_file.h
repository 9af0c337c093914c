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
///
/// What the file held before goes when there is a line to take its place, or at close(): a command
/// that comes to nothing, for a misspelt setting, costs no results of another one.
class ResultsFile {
  public:
    /// No path: writes nothing. Throws std::runtime_error naming a file that cannot be written.
    explicit ResultsFile(const std::string& path);
    /// Writes what waits still, if it can: after an error it is all there will be.
    ~ResultsFile();
    ResultsFile(const ResultsFile&) = delete;
    ResultsFile& operator=(const ResultsFile&) = delete;

    /// Episode `index` is settled; one without any result leaves no line.
    void settle(int index, const std::optional<episode::Result>& result);

    /// Writes what waits still behind episodes that were never settled.
    void close();

  private:
    void write(const std::optional<episode::Result>& result);
    void write_waiting();
    void forget_old();

    std::string path_;
    std::ofstream file_;
    bool holds_old_ = true;  ///< lines of an earlier command
    int next_ = 0;
    std::map<int, std::optional<episode::Result>> waiting_;
};

}  // namespace k3d::optimizer::report

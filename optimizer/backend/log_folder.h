// SPDX-License-Identifier: BSD-3-Clause
// Where the processes of a run write: one folder per try, FOLDER/seed-7/try-1/.
#pragma once

#include <string>

#include "optimizer/episode/task.h"

namespace k3d::optimizer::backend {

/// Makes it, if it is not there, and returns its absolute path. Throws std::runtime_error naming a
/// folder that cannot be made.
std::string make_log_folder(const std::string& path);
/// A new one among the temporary files, whose name begins with `name`. Throws the same.
std::string make_temporary_log_folder(const std::string& name);

/// A folder asked for by name keeps everything. Without a name there is a temporary one, of which
/// only failed tries stay.
class LogFolder {
  public:
    /// Throws std::runtime_error naming a folder that cannot be made.
    explicit LogFolder(const std::string& wanted);
    ~LogFolder();  ///< an empty temporary folder is removed
    LogFolder(const LogFolder&) = delete;
    LogFolder& operator=(const LogFolder&) = delete;

    /// A new folder for this try. Those that another run left for the same seed are removed.
    std::string begin(const episode::Task& task);
    void end(const std::string& folder, bool failed);

  private:
    std::string path_;
    bool temporary_;
};

}  // namespace k3d::optimizer::backend

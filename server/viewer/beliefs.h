// SPDX-License-Identifier: BSD-3-Clause
// What agents write about their own beliefs, for the page to draw over the truth: the newest line of
// every *.telemetry.jsonl in a folder. The server passes lines on and does not read their meaning.
#pragma once

#include <map>
#include <string>

namespace k3d::server::viewer {

class Beliefs {
  public:
    explicit Beliefs(std::string folder) : folder_(std::move(folder)) {}

    /// Reads what has been written since the last call. {"kind":"beliefs","players":{"NAME":LINE}}
    /// with the newest belief line of each file, NAME its name up to the first dot; empty text if
    /// nothing is new. Files that vanish or cannot be read are left out; half a line waits for its
    /// end, one that is no belief or longer than 64 kB is skipped.
    std::string news();

  private:
    struct File {
        std::size_t read = 0;   ///< bytes
        std::string rest;       ///< of a line without its end
        std::string newest;
    };
    bool follow(const std::string& path, File& file) const;

    std::string folder_;
    std::map<std::string, File> files_;  ///< by name
};

}  // namespace k3d::server::viewer

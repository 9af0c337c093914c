// SPDX-License-Identifier: BSD-3-Clause
// A recording's inputs, step by step, as connections that need no sockets.
#pragma once

#include <deque>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/net/net.h"
#include "server/recording/record_reader.h"

namespace k3d::server::recording {

/// What came in during one step, and the state at its end.
struct ReplayStep {
    struct Arrival {
        Accepted accepted;
        std::unique_ptr<net::Connection> connection;  ///< gives the recorded frames, step by step
    };
    std::vector<Arrival> arrivals;
    std::vector<Left> left;
    std::uint64_t digest = 0;
};

/// Must outlive the connections it makes.
class Replay {
  public:
    /// Throws RecordError if the file cannot be read or is no recording.
    explicit Replay(const std::string& file);

    const Header& header() const { return reader_.header(); }
    /// None at the end of the recording. Throws RecordError where the file is damaged.
    std::optional<ReplayStep> next_step();
    /// Whether the recording has come to its own end, rather than to that of a killed server's file.
    bool complete() const { return complete_; }

  private:
    std::ifstream file_;
    std::string name_;
    RecordReader reader_;
    std::map<int, std::deque<std::string>> inboxes_;  ///< by connection
    bool complete_ = false;
};

}  // namespace k3d::server::recording

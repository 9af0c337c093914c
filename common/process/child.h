// SPDX-License-Identifier: BSD-3-Clause
// Owned child processes: each in a process group of its own, output to a file, ended with its
// owner. No kill by name, no sleeps: readiness is a line the child prints.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/types.h>

namespace k3d::process {

class ProcessError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The program is missing here, or no further process or file is to be had.
class StartError : public ProcessError {
    using ProcessError::ProcessError;
};

/// How a child ended.
struct Exit {
    int code = 0;        ///< exit code, or 128 + signal
    bool signalled = false;
    std::string text() const;  ///< "exit code 2", "killed by signal 9"
};

struct Spawn {
    std::vector<std::string> arguments;  ///< arguments[0] is the program (path, or looked up in PATH)
    std::string log_file;                ///< stderr (and stdout unless captured) goes here; empty: inherit
    bool capture_stdout = false;         ///< read by wait_ready()
    /// Its waking up interrupts nobody (SCHED_BATCH), nor that of its children: of programs that answer each
    /// other all the time, more get done per CPU second, and the single answer comes later.
    bool batch = false;
};

/// The port of this name in the pairs of a ready line; none if it is not told or is no number from
/// 1 to 65535.
std::optional<int> port_in(const std::map<std::string, std::string>& ready,
                           const std::string& name);

class Child {
  public:
    /// Starts it in a new process group that is killed if the owner dies. Throws StartError with
    /// the program's name if it cannot be started.
    explicit Child(const Spawn& spawn);
    ~Child();  ///< kill() if still running
    Child(Child&&) noexcept;
    Child& operator=(Child&&) noexcept;

    pid_t pid() const;

    /// Waits for a line `ready name=value ...` on captured stdout and returns its pairs, e.g.
    /// {"agent": "40123"}. Throws ProcessError on exit (with the log's last lines) or deadline.
    std::map<std::string, std::string> wait_ready(std::chrono::milliseconds patience);

    /// The same without waiting: none until the line has been printed. The end is poll()'s to tell.
    std::optional<std::map<std::string, std::string>> poll_ready();

    std::optional<Exit> poll();                                    ///< none while running
    std::optional<Exit> wait(std::chrono::milliseconds patience);  ///< none if still running then
    void terminate();  ///< SIGTERM to the group
    void kill();       ///< SIGKILL to the group, and reap

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace k3d::process

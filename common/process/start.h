// SPDX-License-Identifier: BSD-3-Clause
// Starting a program: fork, own process group, file descriptors, exec. Private to common/process.
#pragma once

#include <unistd.h>

#include <utility>

#include "common/process/child.h"

namespace k3d::process {

/// A file descriptor and its close().
class Fd {
  public:
    Fd() = default;
    explicit Fd(int fd) : fd_(fd) {}
    ~Fd() { reset(); }
    Fd(Fd&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Fd& operator=(Fd&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }

    explicit operator bool() const { return fd_ >= 0; }
    int get() const { return fd_; }
    void reset() {
        if (fd_ >= 0) ::close(fd_);
        fd_ = -1;
    }

  private:
    int fd_ = -1;
};

struct Started {
    pid_t pid = -1;
    Fd pidfd;  ///< readable once the child has ended; none on kernels without
    Fd out;    ///< read end of captured standard output, non-blocking
    Fd log;
    bool captured = false;
};

/// Throws StartError if the program cannot be started.
Started start(const Spawn& spawn);

}  // namespace k3d::process

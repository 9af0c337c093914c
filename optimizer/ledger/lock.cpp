// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/ledger/lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "optimizer/ledger/ledger.h"

namespace k3d::optimizer::ledger {

namespace {

std::string first_line(int fd) {
    std::array<char, 64> text{};
    const ssize_t count = ::pread(fd, text.data(), text.size() - 1, 0);
    if (count <= 0) return "?";
    const std::string all(text.data(), static_cast<std::size_t>(count));
    return all.substr(0, all.find('\n'));
}

}  // namespace

Lock::Lock(const std::string& folder) {
    const std::string path = folder + "/lock";
    fd_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (fd_ < 0) throw LedgerError(fmt::format("{}: {}", path, std::strerror(errno)));
    if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) {
        const std::string owner = first_line(fd_);
        ::close(fd_);
        throw LedgerError(fmt::format("{}: another k3d-optimizer is at work here, process {}",
                                      folder, owner));
    }
    const std::string owner = std::to_string(::getpid()) + "\n";
    // Who holds it is told as a help only; the lock is the system's.
    if (::ftruncate(fd_, 0) == 0) {
        [[maybe_unused]] const auto written = ::pwrite(fd_, owner.data(), owner.size(), 0);
    }
}

Lock::~Lock() {
    ::close(fd_);
}

}  // namespace k3d::optimizer::ledger

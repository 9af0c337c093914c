// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "common/net/loop_impl.h"

namespace k3d::net {

Loop::Loop() : impl_(std::make_unique<Impl>()) {}
Loop::~Loop() = default;

namespace {

/// Handlers run in one go; a round over some hundred busy sockets.
constexpr int kBatch = 500;
constexpr std::chrono::milliseconds kLongestSleep{100};

}  // namespace

void Loop::poll() {
    impl_->io.restart();
    for (int i = 0; i < kBatch && impl_->io.poll_one() > 0; ++i) {
    }
}

bool Loop::wait(Clock::time_point deadline, const std::function<bool()>& done) {
    // Without work of its own, an io_context with nothing to do would return at once.
    const auto work = boost::asio::make_work_guard(impl_->io);
    poll();
    while (!done()) {
        const auto now = Clock::now();
        if (now >= deadline) return false;
        impl_->io.restart();
        impl_->io.run_one_until(std::min(deadline, now + kLongestSleep));
        poll();
    }
    return true;
}

}  // namespace k3d::net

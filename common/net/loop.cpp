// SPDX-License-Identifier: BSD-3-Clause
#include "common/net/loop_impl.h"

namespace k3d::net {

Loop::Loop() : impl_(std::make_unique<Impl>()) {}
Loop::~Loop() = default;

void Loop::poll() {
    impl_->io.restart();
    impl_->io.poll();
}

bool Loop::wait(Clock::time_point deadline, const std::function<bool()>& done) {
    // Without work of its own, an io_context with nothing to do would return at once.
    const auto work = boost::asio::make_work_guard(impl_->io);
    poll();
    while (!done()) {
        if (Clock::now() >= deadline) return false;
        impl_->io.restart();
        impl_->io.run_one_until(deadline);
        impl_->io.poll();
    }
    return true;
}

}  // namespace k3d::net

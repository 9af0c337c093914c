// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/backend/wakeups.h"

#include <algorithm>
#include <initializer_list>

namespace k3d::optimizer::backend {

Wakeups::Wakeups() {
    ::sigemptyset(&awaited_);
    for (const int number : {SIGCHLD, SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&awaited_, number);
    ::sigprocmask(SIG_BLOCK, &awaited_, &before_);
}

Wakeups::~Wakeups() {
    // The wish to stop has been met, or was never seen: either way it must not strike now.
    const timespec at_once{};
    while (::sigtimedwait(&awaited_, nullptr, &at_once) > 0) {
    }
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

void Wakeups::wait(std::chrono::steady_clock::time_point deadline) {
    using namespace std::chrono;
    const auto rest = deadline - steady_clock::now();
    const auto nanos = std::max<long long>(0, duration_cast<nanoseconds>(rest).count());
    const timespec timeout{static_cast<time_t>(nanos / 1'000'000'000),
                           static_cast<long>(nanos % 1'000'000'000)};
    const int number = ::sigtimedwait(&awaited_, nullptr, &timeout);
    if (number > 0 && number != SIGCHLD) stop_wanted_ = true;
}

}  // namespace k3d::optimizer::backend

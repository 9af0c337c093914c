// SPDX-License-Identifier: BSD-3-Clause
#include "common/log/limiter.h"

#include <algorithm>

namespace k3d::log {

bool Limiter::allows(spdlog::level::level_enum level, Clock::time_point now) {
    if (now - second_ >= std::chrono::seconds(1)) {
        report();
        second_ = now;
        lines_[0] = lines_[1] = 0;
    }
    int& lines = lines_[level >= spdlog::level::warn ? 1 : 0];
    if (lines < lines_per_second_) {
        ++lines;
        return true;
    }
    ++left_out_;
    return false;
}

void Limiter::report() {
    if (left_out_ > 0) spdlog::warn("{} further lines about peers left out", left_out_);
    left_out_ = 0;
}

std::string printable(std::string_view text) {
    constexpr std::size_t kLongest = 120;
    std::string shown(text.substr(0, kLongest));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    if (text.size() > kLongest) shown += "...";
    return shown;
}

}  // namespace k3d::log

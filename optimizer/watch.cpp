// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/watch.h"

#include <fmt/format.h>

namespace k3d::optimizer {

namespace {
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kAnswer{40};
constexpr std::chrono::milliseconds kStatus{500};

/// As a URL names it: any address is told as the loopback one, and IPv6 stands in brackets.
std::string host_of(const std::string& address) {
    if (address == "0.0.0.0") return "127.0.0.1";
    if (address == "::") return "[::1]";
    return address.find(':') == std::string::npos ? address : "[" + address + "]";
}
}  // namespace

void Watch::serve(const std::string& address, std::uint16_t port) {
    page_ = std::make_unique<report::RunPage>(address, port, report::run_page_folder());
    progress_.say(fmt::format("page: http://{}:{}/", host_of(address), page_->port()));
    publish_course();
}

void Watch::publish_course() {
    page_->publish_course(report::course_json(
        {run_.ledger(), run_.experiment(), run_.algorithm().champion(), run_.ended()}));
}

void Watch::show(Round& round, const std::string& backend) {
    const report::RunView view = run_.view(round);
    progress_.show(view, round.take_news(), backend);
    if (!page_) return;
    if (Clock::now() >= told_ + kStatus) {
        told_ = Clock::now();
        page_->publish_status(report::status_json(view, backend, progress_.rates()));
    }
    page_->poll();
}

void Watch::closed(const std::vector<nlohmann::json>& log) {
    for (const nlohmann::json& line : log) progress_.closed(line);
    if (page_) publish_course();
}

Clock::time_point Watch::next_look() const {
    return page_ ? Clock::now() + kAnswer : Clock::time_point::max();
}

}  // namespace k3d::optimizer

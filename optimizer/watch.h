// SPDX-License-Identifier: BSD-3-Clause
// Those who watch a run: the terminal, and browsers if there is a page.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "optimizer/report/run_page.h"
#include "optimizer/report/run_progress.h"
#include "optimizer/run.h"

namespace k3d::optimizer {

class Watch {
  public:
    Watch(Run& run, report::RunProgress& progress) : run_(run), progress_(progress) {}

    /// Opens the page; port 0 = any. Throws net::NetError, e.g. for a busy port.
    void serve(const std::string& address, std::uint16_t port);

    /// After each wait: what has come in since the last call.
    void show(Round& round, const std::string& backend);
    /// A round is closed, and with it these generations.
    void closed(const std::vector<nlohmann::json>& log);
    /// When show() is due, since somebody may have asked for the page.
    std::chrono::steady_clock::time_point next_look() const;

  private:
    void publish_course();

    Run& run_;
    report::RunProgress& progress_;
    std::unique_ptr<report::RunPage> page_;
    std::chrono::steady_clock::time_point told_{};
};

}  // namespace k3d::optimizer

// SPDX-License-Identifier: BSD-3-Clause
// What the user sees while a run goes on: on a terminal one line that changes, else plain lines.
#pragma once

#include <chrono>
#include <ostream>
#include <string>

#include "optimizer/backend/local.h"
#include "optimizer/report/run.h"
#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer::report {

class Progress {
  public:
    Progress(const spec::MatchSpec& spec, std::ostream& out, bool terminal);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { end(); }

    void page(int port);
    void done(const backend::Finished& finished);
    void failed(const backend::Finished& finished, bool again);
    /// The changing line, when there is one. Call after each change, and now and then.
    void show(const Run& run, std::size_t running);
    /// Wipes the changing line.
    void end();

  private:
    void line(const std::string& text);
    double simulated_per_second() const;

    const spec::MatchSpec& spec_;
    std::ostream& out_;
    bool terminal_;
    bool line_open_ = false;
    bool page_shown_ = false;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double simulated_s_ = 0.0;
};

}  // namespace k3d::optimizer::report

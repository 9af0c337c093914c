// SPDX-License-Identifier: BSD-3-Clause
// The live page of a run: its curves, species and champion, for any number of browsers.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "optimizer/report/run_progress.h"
#include "optimizer/report/run_report.h"

namespace k3d::optimizer::report {

/// {"course": {...}}: all that changes only when a generation is closed.
std::string course_json(const RunFacts& run);
/// {"status": {...}}: how far the present round is.
std::string status_json(const RunView& view, const std::string& backend, const std::string& rates);

/// The folder that the build puts the page into: ../run-page as seen from this program's own folder.
std::string run_page_folder();

class RunPage {
  public:
    /// Port 0: any. Throws net::NetError if it cannot listen there, std::runtime_error if there is no
    /// page in `folder`.
    RunPage(const std::string& address, std::uint16_t port, const std::string& folder);
    ~RunPage();

    std::uint16_t port() const;
    /// What those who come from now on are told first, and all others next.
    void publish_course(std::string json);
    void publish_status(std::string json);
    /// Answers browsers, without waiting. Call it some times a second.
    void poll();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace k3d::optimizer::report

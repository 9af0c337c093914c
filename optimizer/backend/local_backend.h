// SPDX-License-Identifier: BSD-3-Clause
// Jobs on this machine, in the order in which they are handed over.
#pragma once

#include <deque>
#include <string>

#include "optimizer/backend/backend.h"
#include "optimizer/backend/job_pool.h"

namespace k3d::optimizer::backend {

class LocalBackend : public Backend {
  public:
    LocalBackend(int jobs, const std::string& log_folder) : pool_(jobs, log_folder) {}

    void submit(const episode::Job& job) override { waiting_.push_back(job); }
    std::vector<episode::Outcome> poll() override;
    void confirm() override {}
    episode::Clock::time_point next_look() const override;
    std::string state() const override;

  private:
    void fill();

    JobPool pool_;
    std::deque<episode::Job> waiting_;
};

}  // namespace k3d::optimizer::backend

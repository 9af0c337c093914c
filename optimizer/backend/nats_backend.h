// SPDX-License-Identifier: BSD-3-Clause
// Jobs for workers anywhere, by way of nats-server. The queue is only a cache of the ledger: what it
// loses is published again, what it delivers twice is the same.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "optimizer/backend/backend.h"
#include "optimizer/backend/nats_link.h"

namespace k3d::optimizer::backend {

class NatsBackend : public Backend {
  public:
    /// `lease`: a job that no worker says anything about for so long is given to another one.
    /// Throws NatsError if the server cannot be reached.
    NatsBackend(const std::string& url, const std::string& run, std::chrono::milliseconds lease);
    ~NatsBackend() override;

    void submit(const episode::Job& job) override;
    std::vector<episode::Outcome> poll() override;
    void confirm() override;
    episode::Clock::time_point next_look() const override;
    std::string state() const override;

  private:
    void publish();
    void publish_all_again();
    void forget(const episode::Outcome& outcome);

    std::string run_;
    episode::Clock::duration patience_;
    NatsLink link_;
    NatsSource outcomes_;
    std::map<episode::Key, episode::Job> outstanding_;
    std::deque<episode::Key> unpublished_;
    std::vector<NatsMessage> unconfirmed_;
    episode::Clock::time_point heard_ = episode::Clock::now();
    episode::Clock::time_point next_publish_{};
    int losses_ = 0;      ///< of the link, that have been made good
    bool ready_ = false;  ///< the link, at the last poll()
};

}  // namespace k3d::optimizer::backend

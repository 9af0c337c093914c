// SPDX-License-Identifier: BSD-3-Clause
// Where episodes are played: on this machine, or by workers anywhere. The daemon hands jobs over and
// gets outcomes back, some of them twice, in any order; it settles them with the ledger.
#pragma once

#include <string>
#include <vector>

#include "optimizer/episode/episode.h"
#include "optimizer/episode/job.h"

namespace k3d::optimizer::backend {

class Backend {
  public:
    virtual ~Backend() = default;

    virtual void submit(const episode::Job& job) = 0;
    /// Does what is due, without waiting, and returns what has ended since the last call.
    virtual std::vector<episode::Outcome> poll() = 0;
    /// All that poll() has returned is in the ledger: it need not be delivered again.
    virtual void confirm() = 0;
    /// When poll() is due at the latest, unless a child ends before that.
    virtual episode::Clock::time_point next_look() const = 0;
    /// For the user, a few words: "2 running, 10 waiting".
    virtual std::string state() const = 0;
};

}  // namespace k3d::optimizer::backend

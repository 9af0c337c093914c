// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/daemon.h"

#include <algorithm>

namespace k3d::optimizer {

Ended optimise(Run& run, backend::Backend& backend, backend::Wakeups& wakeups,
               Watch& watch) {
    while (auto round = run.next_round()) {
        // 1. What the algorithm wants to know, less what the ledger knows already.
        for (const episode::Job& job : round->missing()) backend.submit(job);
        // 2. Episodes come in; each is in the ledger before it is confirmed.
        while (!round->complete()) {
            wakeups.wait(std::min(backend.next_look(), watch.next_look()));
            if (wakeups.stop_wanted()) return Ended::Stopped;
            for (const episode::Job& again : round->take(backend.poll(), run.ledger())) {
                backend.submit(again);
            }
            backend.confirm();
            watch.show(*round, backend.state());
        }
        // 3. The algorithm learns from all of them at once, and its state is saved.
        watch.closed(run.close(*round));
    }
    return Ended::Done;
}

}  // namespace k3d::optimizer

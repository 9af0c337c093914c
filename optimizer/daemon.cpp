// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/daemon.h"

namespace k3d::optimizer {

Ended optimise(Run& run, backend::Backend& backend, backend::Wakeups& wakeups,
               report::RunProgress& progress) {
    while (auto round = run.next_round()) {
        // 1. What the algorithm wants to know, less what the ledger knows already.
        for (const episode::Job& job : round->missing()) backend.submit(job);
        // 2. Episodes come in; each is in the ledger before it is confirmed.
        while (!round->complete()) {
            wakeups.wait(backend.next_look());
            if (wakeups.stop_wanted()) return Ended::Stopped;
            for (const episode::Job& again : round->take(backend.poll(), run.ledger())) {
                backend.submit(again);
            }
            backend.confirm();
            progress.show(run.view(*round), round->take_news(), backend.state());
        }
        // 3. The algorithm learns from all of them at once, and its state is saved.
        for (const nlohmann::json& line : run.close(*round)) progress.closed(line);
    }
    return Ended::Done;
}

}  // namespace k3d::optimizer

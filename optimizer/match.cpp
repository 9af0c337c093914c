// SPDX-License-Identifier: BSD-3-Clause
// The match loop: episodes that are due start, episodes that end are counted or tried again.
#include "optimizer/match.h"

#include <optional>

#include "optimizer/backend/local.h"
#include "optimizer/backend/wakeups.h"
#include "optimizer/episode/queue.h"
#include "optimizer/report/results_file.h"

namespace k3d::optimizer {

report::Run play_match(const spec::MatchSpec& spec, report::Progress& progress) {
    spec::check(spec);
    report::ResultsFile lines(spec.results);
    backend::Wakeups wakeups;
    backend::LocalPool pool(spec);
    episode::Queue queue(spec.seed, spec.episodes);
    report::Run run;
    while (run.settled() < static_cast<std::size_t>(spec.episodes)) {
        // 1. Fill the free slots.
        while (pool.has_room() && !queue.empty()) pool.start(queue.take());
        // 2. Sleep until a child ends or something is due.
        wakeups.wait(pool.next_look());
        if ((run.interrupted = wakeups.stop_wanted())) break;
        // 3. Take in what has ended: a valid result, another try, or given up.
        for (const backend::Finished& finished : pool.poll()) {
            const episode::Task& task = finished.task;
            if (finished.ending) {
                run.results.emplace(task.index, *finished.ending);
                lines.settle(task.index, *finished.ending);
                progress.done(finished);
                continue;
            }
            const episode::Failure& failure = finished.ending.error();
            if (failure.hopeless && run.results.empty()) {
                throw HopelessRun(failure.reason + "; logs in " + finished.folder,
                                  *failure.hopeless);
            }
            const bool again = task.attempt <= spec.retries;
            progress.failed(finished, again);
            if (again) {
                queue.put_back(task);
            } else {
                run.failures.emplace(task.index, failure);
                lines.settle(task.index, failure.result);
            }
        }
        // 4. Say so.
        if (const auto port = pool.page_port()) progress.page(*port);
        progress.show(run, pool.running());
    }
    lines.close();
    return run;
}

}  // namespace k3d::optimizer

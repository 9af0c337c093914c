// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/round.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/log/log.h"
#include "common/version/version.h"
#include "optimizer/fitness/fitness.h"
#include "optimizer/report/statistics.h"

namespace k3d::optimizer {

namespace {

episode::Key key_of(episode::Phase phase, const algorithm::Request& request, int episode) {
    const bool train = phase == episode::Phase::Train;
    return {phase, train ? request.generation : 0, request.candidate, episode};
}

}  // namespace

episode::Phase phase_of(algorithm::Pool pool) {
    switch (pool) {
        case algorithm::Pool::Train: return episode::Phase::Train;
        case algorithm::Pool::Validation: return episode::Phase::Validation;
        case algorithm::Pool::Test: return episode::Phase::Test;
    }
    return episode::Phase::Train;
}

episode::Job JobMaker::job(const std::optional<algorithm::Payload>& payload, episode::Phase phase,
                           const algorithm::Request& request, int episode) const {
    episode::Job job;
    job.run = run;
    job.key = key_of(phase, request, episode);
    job.seed = algorithm::scenario_seed(experiment.seed, request.pool, request.generation, episode);
    job.task = experiment.task;
    job.task.taker = spec::taker_of(experiment.task, episode);
    job.code_version = code_version();
    if (episode::is_test(phase)) job.task.settings = spec::test_settings(experiment);
    if (!payload) return job;
    if (const auto* values = std::get_if<std::vector<double>>(&*payload)) {
        if (experiment.start_network) {
            job.network_path = experiment.network.path;
            job.network = network::to_json(spec::with_weights(*experiment.start_network, *values));
            return job;
        }
        for (const auto& [path, value] : spec::settings_of(experiment, *values)) {
            job.settings.push_back(path + "=" + value);
        }
    } else {
        job.network_path = experiment.network.path;
        job.network = network::to_json(std::get<network::Definition>(*payload));
    }
    return job;
}

void Round::add(const episode::Job& job, const ledger::Ledger& ledger) {
    Episode episode{job, ledger.find(job.key)};
    if (episode.row) {
        ++known_;
        if (episode.row->seed != job.seed ||
            episode.row->fingerprint != episode::fingerprint(job)) {
            throw ledger::LedgerError(fmt::format(
                "episode {} of the ledger was played with another candidate, task or seed",
                job.key.text()));
        }
    } else {
        episode.job.attempt = ledger.count_failed(job.key) + 1;
    }
    episodes_.emplace(job.key, std::move(episode));
}

std::vector<episode::Job> Round::missing() const {
    std::vector<episode::Job> jobs;
    for (const auto& [key, episode] : episodes_) {
        if (!episode.row) jobs.push_back(episode.job);
    }
    return jobs;
}

std::vector<episode::Job> Round::take(const std::vector<episode::Outcome>& outcomes,
                                      ledger::Ledger& ledger) {
    std::vector<ledger::Row> rows;
    std::vector<ledger::FailedTry> failed;
    std::vector<episode::Job> again;
    for (const episode::Outcome& outcome : outcomes) {
        const auto found = episodes_.find(outcome.key);
        if (found == episodes_.end()) continue;  // of a round before: a late copy
        Episode& episode = found->second;
        if (outcome.fingerprint != episode::fingerprint(episode.job) ||
            outcome.seed != episode.job.seed) {
            spdlog::warn("an outcome of {} from {} is of another job; ignored", outcome.key.text(),
                         outcome.worker);
            continue;
        }
        std::string invalid;
        if (outcome.ending) {
            const auto worth = fitness::fitness(experiment_.task, *outcome.ending);
            if (worth) {
                settle(episode, outcome, *worth, rows);
                continue;
            }
            invalid = worth.error();
        }
        // A late failure of an earlier try says nothing about the one that is under way.
        if (episode.row || outcome.attempt != episode.job.attempt) continue;
        const episode::Failure failure =
            outcome.ending ? episode::Failure{invalid, {}, {}} : outcome.ending.error();
        end_if_hopeless(outcome.key, failure, ledger);
        if (fail(episode, outcome, failure, rows, failed)) again.push_back(episode.job);
    }
    if (rows.empty() && failed.empty()) return again;
    for (const ledger::Row& row : ledger.add(rows, failed)) {
        spdlog::warn("episode {} has come out in two ways; the first one counts, this is {}: {}",
                     row.key.text(), row.worker, row.result);
    }
    return again;
}

void Round::settle(Episode& episode, const episode::Outcome& outcome, double worth,
                   std::vector<ledger::Row>& rows) {
    const episode::Result& result = *outcome.ending;
    ledger::Row row{outcome.key,
                    outcome.seed,
                    outcome.fingerprint,
                    std::string(k3d::episode::name(result.status)),
                    result.reason,
                    worth,
                    fitness::simulated_s(result),
                    k3d::episode::to_line(result),
                    outcome.attempt,
                    outcome.wall_s,
                    outcome.worker};
    rows.push_back(row);  // a second copy too: the ledger tells whether it says the same
    if (episode.row) return;
    episode.row = row;
    news_.push_back(std::move(row));
    ++known_;
}

/// Where the run has played before, it is one worker that cannot, and others may. A test has
/// settings of its own, so of it the search says nothing.
void Round::end_if_hopeless(const episode::Key& key, const episode::Failure& failure,
                            const ledger::Ledger& ledger) const {
    if (!failure.hopeless) return;
    const bool plays = std::any_of(episodes_.begin(), episodes_.end(), [](const auto& entry) {
        return entry.second.row && entry.second.row->status != "failed";
    });
    if (plays || ledger.has_result(episode::is_test(key.phase))) return;
    throw HopelessRun(fmt::format("episode {}: {}", key.text(), failure.reason), *failure.hopeless);
}

bool Round::fail(Episode& episode, const episode::Outcome& outcome,
                 const episode::Failure& failure, std::vector<ledger::Row>& rows,
                 std::vector<ledger::FailedTry>& failed) {
    spdlog::warn("episode {}: try {} of {} failed: {}", outcome.key.text(), outcome.attempt, kTries,
                 failure.reason);
    failed.push_back({outcome.key, outcome.attempt, failure.reason, outcome.worker});
    if (++episode.job.attempt <= kTries) return true;
    episode.row = ledger::Row{outcome.key,
                              outcome.seed,
                              outcome.fingerprint,
                              "failed",
                              fmt::format("no valid result in {} tries", kTries),
                              experiment_.task.worst,
                              0.0,
                              "",
                              outcome.attempt,
                              outcome.wall_s,
                              outcome.worker};
    rows.push_back(*episode.row);
    news_.push_back(*episode.row);
    ++known_;
    return false;
}

const ledger::Row& Round::row(const algorithm::Request& request, int episode) const {
    return *episodes_.at(key_of(phase_of(request.pool), request, episode)).row;
}

bool Round::failed(const algorithm::Request& request) const {
    for (int i = 0; i < request.episodes; ++i) {
        if (row(request, i).status != "failed") return false;
    }
    return true;
}

algorithm::Score Round::score(const algorithm::Request& request) const {
    std::vector<double> sample;
    for (int i = 0; i < request.episodes; ++i) {
        sample.push_back(row(request, i).fitness);
    }
    const report::Statistics s = report::statistics(sample);
    return {*s.mean, s.se.value_or(0.0), static_cast<int>(s.n)};
}

std::vector<ledger::Row> Round::take_news() {
    return std::exchange(news_, {});
}

}  // namespace k3d::optimizer

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/test_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "common/version/version.h"
#include "optimizer/backend/local_backend.h"
#include "optimizer/ledger/lock.h"
#include "optimizer/round.h"
#include "optimizer/run.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer {

namespace fs = std::filesystem;

namespace {

/// The same for all rows: they meet the same scenarios. The test pool has no seed of any training or
/// validation pool, whatever seed those were drawn with.
constexpr std::uint64_t kTestSeed = 1;

ledger::Ledger open_row(const spec::TableSpec& table, const spec::RowSpec& row,
                        const RowPlayer& player, const std::string& folder) {
    const std::string file = ledger_file(folder);
    if (!fs::exists(file)) {
        return ledger::Ledger::create(file, {{"id", fmt::format("test-{}-{}", table.name, row.key)},
                                             {"name", table.name + " " + row.key},
                                             {"who", player.who},
                                             {"code_version", std::string(code_version())}});
    }
    auto ledger = ledger::Ledger::open(file, ledger::Ledger::Access::Write);
    const ledger::Facts facts = ledger.facts();
    for (const auto& [fact, now] :
         {std::pair{"who", player.who}, std::pair{"code_version", std::string(code_version())}}) {
        if (facts.at(fact) == now) continue;
        throw ledger::LedgerError(
            fmt::format("{}: begun with {} '{}', this is '{}': the row would be of two. Delete the "
                        "folder to play it anew", folder, fact, facts.at(fact), now));
    }
    return ledger;
}

bool is_finished(const std::string& folder, const std::string& who, int episodes) {
    if (!fs::exists(ledger_file(folder))) return false;
    const auto ledger = ledger::Ledger::open(ledger_file(folder), ledger::Ledger::Access::Read);
    return ledger.facts().at("who") == who &&
           ledger.rows().size() >= static_cast<std::size_t>(episodes);
}

/// The experiment whose candidate the player is, on the table's task.
spec::Experiment experiment_for(const spec::TableSpec& table, const RowPlayer& player) {
    spec::Experiment experiment = player.found ? player.found->experiment : spec::Experiment();
    experiment.name = table.name;
    experiment.seed = kTestSeed;
    experiment.task = table.task;
    experiment.test.settings.clear();
    return experiment;
}

}  // namespace

bool play_row(const spec::TableSpec& table, const spec::RowSpec& row, const RowPlayer& player,
              const std::string& folder, int jobs, backend::Wakeups& wakeups,
              report::RunProgress& progress) {
    if (is_finished(folder, player.who, table.episodes)) return true;
    fs::create_directories(folder);
    const ledger::Lock lock(folder);
    ledger::Ledger ledger = open_row(table, row, player, folder);
    const spec::Experiment experiment = experiment_for(table, player);
    const JobMaker maker{experiment, ledger.facts().at("id")};
    std::optional<algorithm::Payload> payload;
    if (player.found) payload = player.found->champion->payload;
    Round round(experiment);
    const algorithm::Request request{0, 0, algorithm::Pool::Test, table.episodes, {}};
    for (int i = 0; i < table.episodes; ++i) {
        episode::Job job = maker.job(payload, episode::Phase::Test, request, i);
        for (const std::string& word : spec::split_words(row.settings)) job.settings.push_back(word);
        round.add(job, ledger);
    }
    progress.say(fmt::format("{}: {}", table.title, row.label));
    backend::LocalBackend backend(jobs, folder + "/logs");
    for (const episode::Job& job : round.missing()) backend.submit(job);
    while (!round.complete()) {
        wakeups.wait(backend.next_look());
        if (wakeups.stop_wanted()) return false;
        for (const episode::Job& again : round.take(backend.poll(), ledger)) backend.submit(again);
        backend.confirm();
        progress.show({true, 0, 0, round.known(), round.episodes()}, round.take_news(),
                      backend.state());
    }
    return true;
}

report::ComparedRow read_row(const spec::RowSpec& row, const std::string& folder) {
    report::ComparedRow out{row, "", {}};
    if (!fs::exists(ledger_file(folder))) return out;
    const auto ledger = ledger::Ledger::open(ledger_file(folder), ledger::Ledger::Access::Read);
    const ledger::Facts facts = ledger.facts();
    out.origin = fmt::format("{}; tested by version {}", facts.at("who"), facts.at("code_version"));
    out.rows = ledger.rows();
    return out;
}

}  // namespace k3d::optimizer

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/test_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "common/config/config.h"
#include "common/network/network.h"
#include "common/version/version.h"
#include "optimizer/backend/local_backend.h"
#include "optimizer/ledger/lock.h"
#include "optimizer/round.h"
#include "optimizer/run.h"
#include "optimizer/spec/ask.h"
#include "optimizer/spec/settings.h"
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
    if (fs::exists(file)) return ledger::Ledger::open(file, ledger::Ledger::Access::Write);
    return ledger::Ledger::create(file, {{"id", fmt::format("test-{}-{}", table.name, row.key)},
                                         {"name", table.name + " " + row.key},
                                         {"who", player.who},
                                         {"code_version", std::string(code_version())}});
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

/// What an experiment fixed for the agents while it searched belongs to what it found.
std::vector<std::string> fixed_settings(const RowPlayer& player) {
    if (!player.found) return {};
    return spec::parse_settings(player.found->experiment.task.settings).keeper;
}

std::vector<std::string> settings_of(const spec::RowSpec& row) {
    std::vector<std::string> settings;
    if (!row.settings_file.empty()) settings = config::assignments_of_file(row.settings_file);
    const std::vector<std::string> words = spec::split_words(row.settings);
    settings.insert(settings.end(), words.begin(), words.end());
    return settings;
}

/// All episodes of the row, as the code version played them that began it. Throws LedgerError if the
/// ledger has one of another candidate or task.
Round round_of(const spec::TableSpec& table, const spec::RowSpec& row, const RowPlayer& player,
               const spec::Experiment& experiment, const ledger::Ledger& ledger) {
    const ledger::Facts facts = ledger.facts();
    if (facts.at("who") != player.who) {
        throw ledger::LedgerError(
            fmt::format("played by '{}', this is '{}'", facts.at("who"), player.who));
    }
    const JobMaker maker{experiment, facts.at("id")};
    std::optional<algorithm::Payload> payload;
    if (player.found) payload = player.found->champion->payload;
    const algorithm::Request request{0, 0, algorithm::Pool::Test, table.episodes, {}};
    const std::vector<std::string> fixed = fixed_settings(player);
    const std::vector<std::string> own = settings_of(row);
    const std::string network =
        row.network.empty() ? "" : network::to_json(network::load_file(row.network));
    Round round(experiment);
    for (int i = 0; i < table.episodes; ++i) {
        episode::Job job = maker.job(payload, episode::Phase::Test, request, i);
        job.settings.insert(job.settings.begin(), fixed.begin(), fixed.end());  // what was tuned wins
        job.settings.insert(job.settings.end(), own.begin(), own.end());
        if (!network.empty()) {
            job.network_path = row.network_path;
            job.network = network;
        }
        job.code_version = facts.at("code_version");
        round.add(job, ledger);
    }
    if (!round.complete() && facts.at("code_version") != code_version()) {
        throw ledger::LedgerError(fmt::format("begun by version {}, this is {}",
                                              facts.at("code_version"), code_version()));
    }
    return round;
}

/// Throws LedgerError for a result that no figure can be read from.
void check_results(const std::vector<ledger::Row>& rows, const std::string& file) {
    for (const ledger::Row& row : rows) {
        try {
            if (!row.result.empty()) k3d::episode::from_line(row.result);
        } catch (const k3d::episode::ResultError& error) {
            throw ledger::LedgerError(
                fmt::format("{}: episode {}: {}", file, row.key.text(), error.what()));
        }
    }
}

/// Without episodes if it has none yet, and then without origin; or if it cannot be read.
report::ComparedRow read_row(const spec::RowSpec& row, const std::string& file) {
    report::ComparedRow out{row, "", {}, ""};
    try {
        const auto ledger = ledger::Ledger::open(file, ledger::Ledger::Access::Read);
        std::vector<ledger::Row> rows = ledger.rows();
        if (rows.empty()) return out;
        check_results(rows, file);
        const ledger::Facts facts = ledger.facts();
        out.version = facts.at("code_version");
        out.origin = fmt::format("{}; tested by version {}", facts.at("who"), out.version);
        out.rows = std::move(rows);
    } catch (const std::exception& error) {
        out.origin = std::string("cannot be read: ") + error.what();
    }
    return out;
}

}  // namespace

void check_settings(const spec::TableSpec& table) {
    spec::require_taken(table.name, table.task, spec::parse_settings(table.task.settings));
    for (const spec::RowSpec& row : table.rows) {
        const std::string& file = row.settings_file;
        spec::require_taken(file.empty() ? table.name + ", row " + row.key : file, table.task,
                            {.server = {}, .keeper = settings_of(row), .taker = {}});
    }
}

bool play_row(const spec::TableSpec& table, const spec::RowSpec& row, const RowPlayer& player,
              const std::string& folder, int jobs, backend::Wakeups& wakeups,
              report::RunProgress& progress) {
    fs::create_directories(folder);
    const ledger::Lock lock(folder);
    ledger::Ledger ledger = open_row(table, row, player, folder);
    const spec::Experiment experiment = experiment_for(table, player);
    std::optional<Round> round;
    try {
        round.emplace(round_of(table, row, player, experiment, ledger));
    } catch (const ledger::LedgerError& error) {
        throw ledger::LedgerError(fmt::format(
            "{}: {}: the row would be of two. Delete the folder to play it anew", folder, error.what()));
    }
    if (round->complete()) return true;
    progress.begin(fmt::format("{}: {}", table.title, row.label));
    backend::LocalBackend backend(jobs, folder + "/logs");
    for (const episode::Job& job : round->missing()) backend.submit(job);
    while (!round->complete()) {
        wakeups.wait(backend.next_look());
        if (wakeups.stop_wanted()) return false;
        for (const episode::Job& again : round->take(backend.poll(), ledger)) backend.submit(again);
        backend.confirm();
        progress.show({true, 0, 0, round->known(), round->episodes()}, round->take_news(),
                      backend.state());
    }
    return true;
}

std::vector<report::ComparedRow> read_rows(
    const spec::TableSpec& table,
    const std::function<std::string(const spec::RowSpec&)>& folder_of) {
    std::vector<report::ComparedRow> rows;
    std::string version;
    for (const spec::RowSpec& row : table.rows) {
        const std::string file = ledger_file(folder_of(row));
        if (!fs::exists(file)) continue;
        report::ComparedRow read = read_row(row, file);
        if (read.origin.empty()) continue;
        if (!is_unreadable(read)) version = read.version;
        rows.push_back(std::move(read));
    }
    for (report::ComparedRow& row : rows) {
        if (is_unreadable(row)) row.version = version;  // else the table warns of two
    }
    return rows;
}

bool is_unreadable(const report::ComparedRow& row) {
    return row.rows.empty();
}

}  // namespace k3d::optimizer

// SPDX-License-Identifier: BSD-3-Clause
// The whole state of a run as JSON, version 1, and back.
#include <fmt/format.h>

#include <limits>
#include <set>

#include "common/config/config.h"
#include "optimizer/algorithm/algorithm_impl.h"

namespace k3d::optimizer::algorithm {
namespace {

constexpr std::string_view kFormat = "keepaway3d-algorithm";
constexpr int kVersion = 1;

using nlohmann::json;

json save_champion(const Champion& champion) {
    return {{"candidate", champion.candidate},
            {"generation", champion.generation},
            {"payload", algorithm::save(champion.payload)},
            {"score", algorithm::save(champion.score)},
            {"validated", champion.validated}};
}

Champion read_champion(const Reader& reader, const spec::Problem& problem) {
    return Champion{reader["candidate"].unsigned_integer(),
                    reader["generation"].integer(0, std::numeric_limits<int>::max()),
                    read_payload(reader["payload"], problem), read_score(reader["score"]),
                    reader["validated"].flag()};
}

std::optional<std::string> read_reason(const Reader& reader) {
    if (reader.is_null()) return std::nullopt;
    return reader.text();
}

spec::AlgorithmSpec read_spec(const Reader& reader) {
    spec::AlgorithmSpec spec;
    try {
        config::load_text(config::describing(spec), reader.text(), "spec");
    } catch (const config::ConfigError& error) {
        reader.fail(error.what());
    }
    return spec;
}

/// What the parts cannot know of each other.
void check_entries(const Reader& reader, const std::vector<Entry>& entries, std::uint64_t next_id,
                   bool training, std::size_t size) {
    if (training && entries.size() != size) {
        reader.fail(fmt::format("has {} candidates, the search has {}", entries.size(), size));
    }
    std::set<std::uint64_t> seen;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i].id >= next_id || !seen.insert(entries[i].id).second || (i > 0 && training && entries[i].id <= entries[i - 1].id)) {
            reader.entry(i)["id"].fail(fmt::format("is {}, which is out of order", entries[i].id));
        }
    }
}

}  // namespace

json Algorithm::save() const {
    const Impl& s = *impl_;
    spec::AlgorithmSpec spec = s.spec;
    json entries = json::array();
    for (const Entry& entry : s.entries) entries.push_back(algorithm::save(entry));
    json fame = json::array();
    for (const Champion& champion : s.fame) fame.push_back(save_champion(champion));
    return {{"format", kFormat},
            {"version", kVersion},
            {"spec", config::print(config::describing(spec))},
            {"problem", algorithm::save(s.problem)},
            {"seed", s.seed},
            {"search", std::visit([](const auto& search) { return search.save(); }, s.search)},
            {"generation", s.generation},
            {"phase", name_of(s.phase)},
            {"round", s.round},
            {"entries", entries},
            {"next_id", s.next_id},
            {"episodes", s.episodes},
            {"hall_of_fame", fame},
            {"log", s.log},
            {"line", s.line},
            {"pending", s.pending ? json(*s.pending) : json()},
            {"finished", s.finished ? json(*s.finished) : json()}};
}

Algorithm Algorithm::restore(const json& state, std::string_view source) {
    const Reader reader(state, std::string(source), "");
    if (const std::string format = reader["format"].text(); format != kFormat) {
        reader["format"].fail(fmt::format("is \"{}\", expected \"{}\"", format, kFormat));
    }
    if (const int version = reader["version"].integer(0, 1000000); version != kVersion) {
        reader["version"].fail(fmt::format("is {}, this program reads {}", version, kVersion));
    }
    std::unique_ptr<Impl> impl;
    try {
        impl = std::make_unique<Impl>(read_spec(reader["spec"]), read_problem(reader["problem"]),
                                      reader["seed"].unsigned_integer());
    } catch (const AlgorithmError& error) {
        const std::string what = error.what();  // settings alone do not know their file
        if (what.rfind(std::string(source), 0) == 0) throw;
        throw AlgorithmError(fmt::format("{}: {}", source, what));
    }
    Impl& s = *impl;
    const Reader search = reader["search"];
    std::visit([&search](auto& inner) { inner.load(search); }, s.search);
    s.generation = reader["generation"].integer(0, std::numeric_limits<int>::max() - 1);
    const std::string phase = reader["phase"].text();
    if (phase != "train" && phase != "validation") {
        reader["phase"].fail(fmt::format("is \"{}\", expected train or validation", phase));
    }
    s.phase = phase == "train" ? Pool::Train : Pool::Validation;
    s.round = reader["round"].integer(0, 1000000);
    s.pending = read_reason(reader["pending"]);
    s.finished = read_reason(reader["finished"]);
    s.next_id = reader["next_id"].unsigned_integer();
    s.episodes = reader["episodes"].unsigned_integer();
    s.entries.clear();
    reader["entries"].each(
        [&s](const Reader& entry) { s.entries.push_back(read_entry(entry, s.problem)); });
    if (s.phase == Pool::Validation && !s.finished &&
        (s.entries.empty() || s.spec.sampling.validation_episodes == 0)) {
        reader["phase"].fail("is validation, but there is nothing to validate");
    }
    if (s.finished && !s.entries.empty()) reader["entries"].fail("is not empty in a finished run");
    check_entries(reader["entries"], s.entries, s.next_id, !s.finished && s.phase == Pool::Train,
                  std::visit([](const auto& inner) { return inner.size(); }, s.search));
    s.fame.clear();
    reader["hall_of_fame"].each(
        [&s](const Reader& entry) { s.fame.push_back(read_champion(entry, s.problem)); });
    if (s.fame.size() > kMostFame) reader["hall_of_fame"].fail("is too long");
    if (!s.fame.empty()) s.champion = s.fame.back();
    s.log.clear();
    reader["log"].each([&s](const Reader& line) { s.log.push_back(line.json()); });
    s.line = reader["line"].json();
    return Algorithm(std::move(impl));
}

Algorithm Algorithm::restore_text(std::string_view text, std::string_view source) {
    json state;
    try {
        state = json::parse(text);
    } catch (const json::exception& error) {
        throw AlgorithmError(fmt::format("{}: not JSON: {}", source, error.what()));
    }
    return restore(state, source);
}

}  // namespace k3d::optimizer::algorithm

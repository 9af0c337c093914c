// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/run.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "common/version/version.h"
#include "optimizer/spec/ask.h"
#include "optimizer/spec/settings.h"

namespace k3d::optimizer {

namespace fs = std::filesystem;

namespace {

std::string content(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in || fs::is_directory(path)) throw std::runtime_error("cannot read " + path);
    return text.str();
}

/// Of the agent that the experiment names: what can be tuned has to be known before it can be read.
spec::AgentFields fields_for(const std::string& toml, const spec::Overrides& overrides) {
    constexpr std::string_view kPath = "task.agent_program";
    std::string program = config::text_at(toml, kPath).value_or("");
    for (const std::string& text : overrides) {
        const auto equals = text.find('=');
        if (text.substr(0, equals) == kPath && equals != std::string::npos) {
            program = text.substr(equals + 1);
        }
    }
    return spec::ask_agent_fields(program);
}

/// Tells this run's jobs on a queue from those of any other, so it must not follow from a seed.
std::string fresh_id(const std::string& name) {
    std::random_device device;
    std::string id = fmt::format("{}-{:08x}", name, device());
    for (char& c : id) {
        if (c == '.') c = '_';  // separates the parts of a subject
    }
    return id;
}

std::string now_text() {
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::time(nullptr)));
}

std::string payload_json(const algorithm::Payload& payload) {
    if (const auto* values = std::get_if<std::vector<double>>(&payload)) {
        return nlohmann::json(*values).dump();
    }
    return network::to_json(std::get<network::Definition>(payload));
}

algorithm::Algorithm new_algorithm(const spec::Experiment& e, const std::string& file) {
    try {
        return algorithm::Algorithm(e.algorithm, spec::problem_of(e), e.seed);
    } catch (const algorithm::AlgorithmError& error) {
        throw config::ConfigError(file + ": " + error.what());
    }
}

/// Everything that shows before an episode is played: what an algorithm or a program will not take.
void require_sound(const spec::Experiment& e, const std::string& file) {
    new_algorithm(e, file);
    spec::require_taken(file + ": task.settings", e.task, spec::parse_settings(e.task.settings));
    if (e.test.settings.empty()) return;
    spec::require_taken(file + ": task.settings and test.settings", e.task,
                        spec::parse_settings(spec::test_settings(e)));
}

std::string experiment_text(const std::string& file) {
    try {
        return content(file);
    } catch (const std::runtime_error& error) {
        throw config::ConfigError(error.what());
    }
}

/// What the ledger of a run says of its experiment. Throws what parse_experiment() throws, and
/// ConfigError naming a file that cannot be read.
ledger::Facts facts_of(const std::string& file, const spec::Overrides& overrides) {
    const std::string text = experiment_text(file);
    std::string network;
    const auto read = [&](const std::string& name) {
        return network = content((fs::path(file).parent_path() / name).string());
    };
    spec::parse_experiment(text, file, fields_for(text, overrides), read, overrides);
    return {{"experiment", text},
            {"file", file},
            {"overrides", nlohmann::json(overrides).dump()},
            {"network", network}};
}

const std::string& fact(const ledger::Facts& facts, const std::string& name) {
    const auto found = facts.find(name);
    if (found == facts.end()) {
        throw ledger::LedgerError(fmt::format("the ledger does not tell '{}'", name));
    }
    return found->second;
}

}  // namespace

std::string ledger_file(const std::string& folder) {
    return folder + "/ledger.sqlite";
}

spec::Experiment experiment_of(const ledger::Facts& facts) {
    const std::string& toml = fact(facts, "experiment");
    const auto read = [&facts](const std::string&) { return fact(facts, "network"); };
    spec::Overrides overrides;
    try {
        const auto list = nlohmann::json::parse(fact(facts, "overrides"));
        overrides = list.get<spec::Overrides>();
    } catch (const nlohmann::json::exception& error) {
        throw ledger::LedgerError(std::string("the ledger's overrides: ") + error.what());
    }
    return spec::parse_experiment(toml, fact(facts, "file"), fields_for(toml, overrides), read,
                                  overrides);
}

Run::Run(std::string folder, std::unique_ptr<ledger::Lock> lock, ledger::Ledger ledger)
    : folder_(std::move(folder)), lock_(std::move(lock)), ledger_(std::move(ledger)) {
    const ledger::Facts facts = ledger_.facts();
    id_ = fact(facts, "id");
    if (const std::string& version = fact(facts, "code_version"); version != code_version()) {
        throw ledger::LedgerError(fmt::format(
            "{}: begun by version {}, this is {}: its results would be others", folder_, version,
            code_version()));
    }
    experiment_ = experiment_of(facts);
    if (const auto round = ledger_.last_round()) {
        rounds_ = round->number;
        algorithm_ = algorithm::Algorithm::restore_text(round->state, ledger_file(folder_));
    } else {
        algorithm_ = new_algorithm(experiment_, fact(facts, "file"));
    }
}

Run Run::begin(const std::string& file, const spec::Overrides& overrides,
               const std::string& wanted_folder, const std::string& command) {
    ledger::Facts facts = facts_of(file, overrides);
    const spec::Experiment e = experiment_of(facts);
    require_sound(e, file);  // to learn of its faults before there is a folder
    const std::string folder = wanted_folder.empty() ? "runs/" + e.name : wanted_folder;
    if (fs::exists(ledger_file(folder))) {
        throw ledger::LedgerError(fmt::format(
            "{} has a run already: k3d-optimizer resume {}, or name another folder with --run",
            folder, folder));
    }
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault) throw ledger::LedgerError(fmt::format("{}: {}", folder, fault.message()));
    auto lock = std::make_unique<ledger::Lock>(folder);
    facts.merge(ledger::Facts{{"id", fresh_id(e.name)},
                              {"name", e.name},
                              {"code_version", std::string(code_version())},
                              {"command", command},
                              {"begun", now_text()}});
    return Run(folder, std::move(lock), ledger::Ledger::create(ledger_file(folder), facts));
}

void Run::check(const std::string& file, const spec::Overrides& overrides) {
    require_sound(experiment_of(facts_of(file, overrides)), file);
}

void Run::require(const std::string& folder, const std::string& file,
                  const spec::Overrides& overrides) {
    const auto ledger = ledger::Ledger::open(ledger_file(folder), ledger::Ledger::Access::Read);
    const ledger::Facts begun = ledger.facts();
    const ledger::Facts wanted = facts_of(file, overrides);
    for (const char* name : {"experiment", "network", "overrides"}) {
        if (fact(begun, name) == fact(wanted, name)) continue;
        throw ledger::LedgerError(fmt::format(
            "{}: begun with another {} than {} has now, with overrides {}. Delete the folder to search "
            "anew, or name another --out", folder, name, file, fact(wanted, "overrides")));
    }
}

Run Run::resume(const std::string& folder) {
    if (!fs::exists(ledger_file(folder))) {
        throw ledger::LedgerError(fmt::format("{} has no run: no file {}", folder,
                                              ledger_file(folder)));
    }
    auto lock = std::make_unique<ledger::Lock>(folder);
    return Run(folder, std::move(lock),
               ledger::Ledger::open(ledger_file(folder), ledger::Ledger::Access::Write));
}

bool Run::hours_are_used_up() const {
    // Counted up to the present generation alone: within it nothing changes, resumed or not.
    const double limit_s = experiment_.budget.simulated_hours * 3600.0;
    return limit_s > 0.0 && ledger_.simulated_before(algorithm_->generation()) >= limit_s;
}

std::optional<Round> Run::next_round() {
    if (!ended()) {
        if (hours_are_used_up()) algorithm_->end_after_generation("simulated_hours");
        return search_round();
    }
    Round test = test_round();
    return test.complete() ? std::nullopt : std::optional(std::move(test));
}

Round Run::search_round() {
    Round round(experiment_);
    const JobMaker maker{experiment_, id_};
    for (const algorithm::Request& request : algorithm_->ask()) {
        round.add(request);
        for (int i = 0; i < request.episodes; ++i) {
            round.add(maker.job(request.payload, phase_of(request.pool), request, i), ledger_);
        }
    }
    return round;
}

Round Run::test_round() const {
    Round round(experiment_);
    const auto champion = algorithm_->champion();
    if (!champion) return round;
    const JobMaker maker{experiment_, id_};
    const algorithm::Request request{champion->candidate, champion->generation,
                                     algorithm::Pool::Test, experiment_.test.episodes,
                                     champion->payload};
    algorithm::Request untuned = request;
    untuned.candidate = 0;
    for (int i = 0; i < request.episodes; ++i) {
        round.add(maker.job(champion->payload, episode::Phase::Test, request, i), ledger_);
        if (!experiment_.test.baseline) continue;
        round.add(maker.job(std::nullopt, episode::Phase::Baseline, untuned, i), ledger_);
    }
    return round;
}

std::vector<nlohmann::json> Run::close(const Round& round) {
    if (round.requests().empty()) return {};  // the test: nothing to learn from
    std::vector<ledger::Candidate> candidates;
    for (const algorithm::Request& request : round.requests()) {
        if (round.failed(request)) {
            algorithm_->tell_failed(request.candidate, request.pool);
        } else {
            algorithm_->tell(request.candidate, request.pool, round.score(request));
        }
        candidates.push_back(
            {request.candidate, request.generation, payload_json(request.payload)});
    }
    algorithm_->advance();
    // The log is taken first: what is saved must not depend on when the run was resumed.
    const std::vector<nlohmann::json> log = algorithm_->take_log();
    ledger_.save_round({++rounds_, algorithm_->save().dump(), log}, candidates);
    return log;
}

report::RunView Run::view(const Round& round) const {
    return {round.requests().empty(), algorithm_->generation(),
            experiment_.algorithm.max_generations, round.known(), round.episodes()};
}

}  // namespace k3d::optimizer

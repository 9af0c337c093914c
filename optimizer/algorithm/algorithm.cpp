// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/algorithm.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "common/config/config.h"
#include "optimizer/algorithm/algorithm_impl.h"

namespace k3d::optimizer::algorithm {
namespace {

/// The ranges of describe() hold for specs that were not read from a file, too.
spec::AlgorithmSpec checked(spec::AlgorithmSpec spec) {
    const std::string text = config::print(config::describing(spec));
    try {
        config::load_text(config::describing(spec), text, "algorithm");
    } catch (const config::ConfigError& error) {
        throw AlgorithmError(error.what());
    }
    return spec;
}

/// Whom halving sent home ranks behind everybody who played on: of many with few episodes each the
/// best means are the luckiest.
std::vector<std::size_t> best_trained(const std::vector<Entry>& entries, int count) {
    const std::vector<Outcome> all = outcomes(entries, Pool::Train);
    std::vector<std::size_t> order = ranking(all);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return entries[a].train.wanted > entries[b].train.wanted;
    });
    order.resize(std::min(order.size(), static_cast<std::size_t>(count)));
    std::erase_if(order, [&all](std::size_t index) { return all[index].failed; });
    return order;
}

Payload start_of(const spec::VectorProblem& problem) {
    std::vector<double> values;
    for (const spec::Parameter& parameter : problem) values.push_back(parameter.start);
    return values;
}

nlohmann::json line_of(int generation, const std::vector<Outcome>& all) {
    std::vector<double> fitness;
    for (const Outcome& outcome : all) {
        if (!outcome.failed) fitness.push_back(outcome.score.mean);
    }
    nlohmann::json line = {{"generation", generation},
                           {"candidates", all.size()},
                           {"failed", all.size() - fitness.size()}};
    if (fitness.empty()) return line;
    std::sort(fitness.begin(), fitness.end(), std::greater<>());
    const std::size_t half = fitness.size() / 2;
    line["best"] = fitness.front();
    line["median"] = fitness.size() % 2 == 1 ? fitness[half] : 0.5 * (fitness[half - 1] + fitness[half]);
    line["mean"] = std::accumulate(fitness.begin(), fitness.end(), 0.0) /
                   static_cast<double>(fitness.size());
    line["worst"] = fitness.back();
    return line;
}

}  // namespace

Algorithm::Impl::Impl(const spec::AlgorithmSpec& s, const spec::Problem& p, std::uint64_t run_seed)
    : spec(checked(s)), problem(p), seed(run_seed), search(make_search(spec, problem, seed)) {
    begin();
}

/// Opens the rounds of a new generation.
void Algorithm::Impl::begin() {
    std::visit([this](auto& s) { s.begin(generation); }, search);
    const std::size_t size = std::visit([](const auto& s) { return s.size(); }, search);
    const int episodes_each = first_episodes(search, spec.sampling);
    entries.clear();
    for (std::size_t i = 0; i < size; ++i) {
        entries.push_back({next_id++, payload_of(search, i), {episodes_each, {}, false}, {}});
    }
    phase = Pool::Train;
    round = 0;
}

void Algorithm::Impl::advance() {
    if (phase == Pool::Train) {
        if (another_training_round()) return;
        learn();  // may open a validation
        if (phase == Pool::Validation) return;
    } else {
        if (another_validation_round()) return;
        crown_winner();
    }
    end_generation();
}

/// True if candidates are to be played further before the search may learn from them.
bool Algorithm::Impl::another_training_round() {
    std::vector<std::size_t> all(entries.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (round == 0) {
        const int wanted = episodes_wanted(search, outcomes(entries, Pool::Train));
        if (wanted > 0 && want(entries, all, Pool::Train, wanted)) return true;
    }
    const auto rounds = halve(static_cast<int>(entries.size()), spec.sampling.halving_episodes);
    while (round < static_cast<int>(rounds.size())) {
        const HalvingRound next = rounds[static_cast<std::size_t>(round++)];
        bool more = false;
        for (const std::size_t index : best_trained(entries, next.survivors)) {
            const int played = entries[index].train.score->n;
            more = want(entries, {index}, Pool::Train, played + next.episodes) || more;
        }
        if (more) return true;
    }
    return false;
}

/// The search takes the generation in; the best go on to validation, or to the champion directly.
void Algorithm::Impl::learn() {
    const std::vector<Outcome> all = outcomes(entries, Pool::Train);
    line = line_of(generation, all);
    std::vector<Entry> finalists;
    for (const std::size_t index : best_trained(entries, spec.sampling.finalists)) {
        finalists.push_back(entries[index]);
    }
    const bool has_start = generation == 0 && add_start(finalists);
    std::visit([&all](auto& s) { s.update(all); }, search);
    std::visit([this](const auto& s) { s.report(line); }, search);
    pending = reason_to_end();
    if (!pending) pending = last;
    if (spec.sampling.validation_episodes == 0) {
        if (!finalists.empty()) crown(finalists.front(), *finalists.front().train.score, false);
        return;
    }
    const bool due = has_start || (generation + 1) % spec.sampling.validate_every == 0;
    if (due || pending) start_validation(std::move(finalists));
}

/// A start that is good is hard to beat: validated with the best, it is what a search returns that
/// does not. NEAT has it among its first candidates; the others search around it. False: there is
/// none.
bool Algorithm::Impl::add_start(std::vector<Entry>& finalists) {
    if (const auto* parameters = std::get_if<spec::VectorProblem>(&problem)) {
        if (spec.sampling.validation_episodes == 0) return false;
        finalists.push_back({next_id++, start_of(*parameters), {}, {}});
        return true;
    }
    const Entry& first = entries.front();
    if (!begins_with_start(search) || first.train.failed) return false;
    if (std::none_of(finalists.begin(), finalists.end(),
                     [&first](const Entry& entry) { return entry.id == first.id; })) {
        finalists.push_back(first);
    }
    return true;
}

bool Algorithm::Impl::start_validation(std::vector<Entry> finalists) {
    if (auto centre = centre_of(search)) {
        finalists.push_back({next_id++, std::move(*centre), {}, {}});
    }
    // The champion has its figures on these seeds, and an unchanged copy of it would have the same.
    std::erase_if(finalists, [this](const Entry& entry) {
        return champion && champion->payload == entry.payload;
    });
    if (finalists.empty()) return false;
    entries = std::move(finalists);
    phase = Pool::Validation;
    round = 0;
    return another_validation_round();
}

bool Algorithm::Impl::another_validation_round() {
    std::vector<std::size_t> alive(entries.size());
    std::iota(alive.begin(), alive.end(), std::size_t{0});
    // Those that halving sent home keep their few episodes; a failed one is no finalist.
    const auto rounds = finals(static_cast<int>(entries.size()), spec.sampling.validation_episodes);
    while (round < static_cast<int>(rounds.size())) {
        const HalvingRound next = rounds[static_cast<std::size_t>(round)];
        if (round > 0) {
            const int before = rounds[static_cast<std::size_t>(round - 1)].episodes;
            std::erase_if(alive, [&](std::size_t i) { return entries[i].validation.wanted < before; });
            const std::vector<Outcome> all = outcomes(entries, Pool::Validation);
            std::stable_sort(alive.begin(), alive.end(), [&all](std::size_t a, std::size_t b) {
                if (all[a].failed != all[b].failed) return all[b].failed;
                return all[a].score.mean > all[b].score.mean;
            });
            alive.resize(std::min(alive.size(), static_cast<std::size_t>(next.survivors)));
        }
        ++round;
        if (want(entries, alive, Pool::Validation, next.episodes)) return true;
    }
    return false;
}

/// The finalist that halving played to the end against the champion, on the same seeds.
void Algorithm::Impl::crown_winner() {
    for (const Entry& entry : entries) {
        const Track& track = entry.validation;
        if (track.failed || !track.score || track.wanted < spec.sampling.validation_episodes) continue;
        line["validated"] = {{"candidate", entry.id}, {"mean", track.score->mean},
                             {"se", track.score->se}, {"n", track.score->n}};
        crown(entry, *track.score, true);
    }
}

void Algorithm::Impl::crown(const Entry& entry, const Score& score, bool validated) {
    if (champion && champion->score.mean >= score.mean) return;
    champion = {entry.id, generation, entry.payload, score, validated};
    fame.push_back(*champion);
    if (fame.size() > kMostFame) fame.erase(fame.begin());
}

std::optional<std::string> Algorithm::Impl::reason_to_end() const {
    if (const auto stopped = std::visit([](const auto& s) { return s.stopped(); }, search)) {
        return stopped;
    }
    if (generation + 1 >= spec.max_generations) return "max_generations";
    if (spec.max_episodes > 0.0 && static_cast<double>(episodes) >= spec.max_episodes) {
        return "max_episodes";
    }
    return std::nullopt;
}

void Algorithm::Impl::end_generation() {
    if (champion) {
        line["champion"] = {{"candidate", champion->candidate}, {"mean", champion->score.mean},
                            {"se", champion->score.se}, {"n", champion->score.n}};
        if (champion->score.mean >= spec.target) pending = "target";
    }
    line["episodes_told"] = episodes;
    log.push_back(std::move(line));
    line = nlohmann::json();
    if (pending) {
        finished = pending;
        entries.clear();
        return;
    }
    ++generation;
    begin();
}

Algorithm::Algorithm(const spec::AlgorithmSpec& spec, const spec::Problem& problem,
                     std::uint64_t seed)
    : impl_(std::make_unique<Impl>(spec, problem, seed)) {}
Algorithm::Algorithm(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Algorithm::Algorithm(const Algorithm& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
Algorithm& Algorithm::operator=(const Algorithm& other) {
    if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
    return *this;
}
Algorithm::Algorithm(Algorithm&&) noexcept = default;
Algorithm& Algorithm::operator=(Algorithm&&) noexcept = default;
Algorithm::~Algorithm() = default;

std::vector<Request> Algorithm::ask() const {
    std::vector<Request> requests;
    for (const Entry& entry : impl_->entries) {
        const Track& track = entry.track(impl_->phase);
        if (!track.is_open()) continue;
        requests.push_back({entry.id, impl_->generation, impl_->phase, track.wanted, entry.payload});
    }
    return requests;
}

bool Algorithm::tell(std::uint64_t candidate, Pool pool, const Score& score) {
    if (candidate >= impl_->next_id) {
        throw AlgorithmError(fmt::format("result of candidate {}, which was never asked for", candidate));
    }
    for (Entry& entry : impl_->entries) {
        if (entry.id != candidate || pool != impl_->phase) continue;
        Track& track = entry.track(pool);
        if (!track.is_open()) return false;
        check_score(candidate, score, track.wanted);
        const int known = track.score ? track.score->n : 0;
        if (score.n < known) return false;
        impl_->episodes += static_cast<std::uint64_t>(score.n - known);
        track.score = score;
        return true;
    }
    return false;
}

bool Algorithm::tell_failed(std::uint64_t candidate, Pool pool) {
    if (candidate >= impl_->next_id) {
        throw AlgorithmError(fmt::format("failure of candidate {}, which was never asked for", candidate));
    }
    for (Entry& entry : impl_->entries) {
        if (entry.id != candidate || pool != impl_->phase) continue;
        Track& track = entry.track(pool);
        if (!track.is_open()) return false;
        track.failed = true;
        return true;
    }
    return false;
}

bool Algorithm::settled() const {
    return std::none_of(impl_->entries.begin(), impl_->entries.end(), [this](const Entry& entry) {
        return entry.track(impl_->phase).is_open();
    });
}

void Algorithm::advance() {
    if (impl_->finished) return;
    if (!settled()) {
        throw std::logic_error(fmt::format("advance() in generation {} with {} requests open",
                                           impl_->generation, ask().size()));
    }
    impl_->advance();
}

void Algorithm::end_after_generation(const std::string& reason) { impl_->last = reason; }

std::optional<std::string> Algorithm::finished() const { return impl_->finished; }
int Algorithm::generation() const { return impl_->generation; }
std::uint64_t Algorithm::episodes_told() const { return impl_->episodes; }
std::optional<Champion> Algorithm::champion() const { return impl_->champion; }
const std::vector<Champion>& Algorithm::hall_of_fame() const { return impl_->fame; }

std::vector<nlohmann::json> Algorithm::take_log() { return std::exchange(impl_->log, {}); }

}  // namespace k3d::optimizer::algorithm

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/sample.h"
#include "optimizer/report/paired.h"

namespace k3d::optimizer::report {

namespace {

using episode::Phase;
using Means = std::map<std::uint64_t, double>;  // by candidate

/// By generation, then candidate.
std::map<int, Means> training_means(const std::vector<ledger::Row>& rows) {
    std::map<int, std::map<std::uint64_t, std::vector<double>>> samples;
    for (const ledger::Row& row : rows) {
        if (row.key.phase != Phase::Train) continue;
        samples[row.key.generation][row.key.candidate].push_back(row.fitness);
    }
    std::map<int, Means> means;
    for (const auto& [generation, candidates] : samples) {
        for (const auto& [candidate, sample] : candidates) {
            means[generation][candidate] = *statistics(sample).mean;
        }
    }
    return means;
}

GenerationFigures figures_of(int generation, const Means& means) {
    std::vector<double> sample;
    for (const auto& [candidate, mean] : means) sample.push_back(mean);
    return {generation, *std::max_element(sample.begin(), sample.end()), quantile(sample, 0.5),
            statistics(sample)};
}

std::vector<Trace> traces(const std::map<int, Means>& means, const ledger::Ledger& ledger,
                          const std::vector<std::string>& names) {
    std::map<std::uint64_t, std::vector<double>> values;
    for (const ledger::Candidate& candidate : ledger.candidates()) {
        const auto payload = nlohmann::json::parse(candidate.payload, nullptr, false);
        if (payload.is_array() && payload.size() == names.size()) {
            values[candidate.number] = payload.get<std::vector<double>>();
        }
    }
    std::vector<Trace> all;
    for (std::size_t i = 0; i < names.size(); ++i) {
        Trace trace{names[i], {}, {}, {}};
        for (const auto& [generation, candidates] : means) {
            std::vector<double> sample;
            const auto best = std::max_element(
                candidates.begin(), candidates.end(),
                [](const auto& a, const auto& b) { return a.second < b.second; });
            for (const auto& [candidate, mean] : candidates) {
                if (values.contains(candidate)) sample.push_back(values.at(candidate)[i]);
            }
            if (sample.empty() || !values.contains(best->first)) {
                // Of a generation that is not closed yet.
                for (auto* column : {&trace.best, &trace.low, &trace.high}) {
                    column->push_back(std::numeric_limits<double>::quiet_NaN());
                }
                continue;
            }
            trace.best.push_back(values.at(best->first)[i]);
            trace.low.push_back(quantile(sample, 0.1));
            trace.high.push_back(quantile(sample, 0.9));
        }
        all.push_back(std::move(trace));
    }
    return all;
}

void read_log(const std::vector<nlohmann::json>& log, Curves& out) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < log.size(); ++i) {
        for (const auto& [name, value] : log[i].items()) {
            if (!value.is_number() || name == "generation") continue;
            auto& values = out.logged[name];
            values.resize(i, kNone);
            values.push_back(value.get<double>());
        }
        if (log[i].contains("champion") && log[i]["champion"].is_object()) {
            const auto& champion = log[i]["champion"];
            out.champion.push_back({log[i].value("generation", 0), champion.value("mean", kNone),
                                    champion.value("se", 0.0)});
        }
        if (!log[i].contains("species") || !log[i]["species"].is_array()) continue;
        for (const auto& species : log[i]["species"]) {
            auto& sizes = out.species[species.value("id", 0)];
            sizes.resize(i, 0.0);
            sizes.push_back(species.value("size", 0.0));
        }
    }
    for (auto& [id, sizes] : out.species) sizes.resize(log.size(), 0.0);
    for (auto& [name, values] : out.logged) values.resize(log.size(), kNone);
}

}  // namespace

Curves curves_of(const ledger::Ledger& ledger, const std::vector<std::string>& names) {
    Curves out;
    const auto means = training_means(ledger.rows());
    for (const auto& [generation, candidates] : means) {
        out.fitness.push_back(figures_of(generation, candidates));
    }
    out.parameters = traces(means, ledger, names);
    read_log(ledger.log(), out);
    return out;
}

Statistics paired_difference(const std::vector<ledger::Row>& rows, int scenarios) {
    std::map<int, double> champion, untuned;  // by episode, whose seed both have
    for (const ledger::Row& row : rows) {
        if (row.key.phase == Phase::Test) champion[row.key.episode] = row.fitness;
        if (row.key.phase == Phase::Baseline) untuned[row.key.episode] = row.fitness;
    }
    const auto [ours, theirs] = trial_pairs(champion, untuned, scenarios);
    std::vector<double> differences;
    for (std::size_t i = 0; i < ours.size(); ++i) differences.push_back(ours[i] - theirs[i]);
    return statistics(differences);
}

}  // namespace k3d::optimizer::report

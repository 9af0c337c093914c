// SPDX-License-Identifier: BSD-3-Clause
// What a comparison says; how it looks is comparison_text.cpp.
#include "optimizer/report/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "optimizer/fitness/fitness.h"
#include "optimizer/report/run_report.h"
#include "optimizer/report/run_text.h"

namespace k3d::optimizer::report {

namespace {

using k3d::episode::Result;
using Value = std::function<std::optional<double>(const ledger::Row&, const Result&)>;

struct Figure {
    std::string name;
    std::string title;
    Value value;
    bool is_signed = false;  ///< may be below 0: then a ratio says nothing
};

Figure plain(std::string name, std::string title) {
    Value value = [name](const ledger::Row&, const Result& r) -> std::optional<double> {
        const auto found = fitness::figure(r, name);
        return found ? std::optional(*found) : std::nullopt;
    };
    return {std::move(name), std::move(title), std::move(value)};
}

Figure signed_figure(std::string name, std::string title) {
    Figure figure = plain(std::move(name), std::move(title));
    figure.is_signed = true;
    return figure;
}

std::vector<Figure> figures_of(const spec::TaskSpec& task) {
    if (task.name == "keepaway") {
        return {plain("attempts", "Passes as the paper counts them: kick attempts"),
                plain("hold_time_s", "Hold time, s"),
                plain("passes_completed", "Passes completed, as the server sees them"),
                plain("kicks", "Kicks, as the server sees them")};
    }
    if (task.name == "possession") {
        // The drill's limit and a penalty stand for the time of an episode without a kick.
        return {{"time_s", "Time to the kick, s (30 without one)",
                 [](const ledger::Row& row, const Result&) { return std::optional(-row.fitness); }},
                plain("succeeded", "Share of good kicks"), plain("falls", "Falls")};
    }
    if (task.name == "kick") {
        return {signed_figure("fitness_capped", "Equation (1), distance at most 6 m"),
                signed_figure("fitness_literal", "Equation (1), distance at least 6 m, as printed"),
                plain("time_to_kick_s", "Time to the kick, s"), plain("distance_m", "Distance, m"),
                plain("direction_error_deg", "Direction error, degrees")};
    }
    return {plain("finish_loss", "Mean squared error of the predicted stop, m^2"),
            plain("finish_error_0.5s_m", "Its error after 0.5 s, m"),
            plain("finish_error_1.0s_m", "Its error after 1 s, m"),
            plain("finish_error_2.0s_m", "Its error after 2 s, m")};
}

/// By episode, of those with a valid result that has this figure.
std::map<int, double> values_of(const ComparedRow& row, const Figure& figure) {
    std::map<int, double> values;
    for (std::size_t i = 0; i < row.rows.size(); ++i) {
        if (!row.results[i]) continue;
        if (const auto value = figure.value(row.rows[i], *row.results[i])) {
            values[row.rows[i].key.episode] = *value;
        }
    }
    return values;
}

/// By episode, of those with a valid result.
std::map<int, Lifetime> lifetimes_of(const ComparedRow& row) {
    std::map<int, Lifetime> lives;
    for (std::size_t i = 0; i < row.rows.size(); ++i) {
        if (const auto& result = row.results[i]) {
            lives[row.rows[i].key.episode] = {result->hold_time_s,
                                              result->status != k3d::episode::Status::Truncated};
        }
    }
    return lives;
}

/// What both rows have, in the order of episodes.
template <typename T>
std::pair<std::vector<T>, std::vector<T>> pairs_of(const std::map<int, T>& a,
                                                   const std::map<int, T>& b) {
    std::pair<std::vector<T>, std::vector<T>> out;
    for (const auto& [episode, value] : a) {
        const auto other = b.find(episode);
        if (other == b.end()) continue;
        out.first.push_back(value);
        out.second.push_back(other->second);
    }
    return out;
}

template <typename T>
std::vector<T> sample_of(const std::map<int, T>& by_episode) {
    std::vector<T> sample;
    for (const auto& [episode, value] : by_episode) sample.push_back(value);
    return sample;
}

/// None if the reference row is not played.
const ComparedRow* reference_of(const Comparison& comparison) {
    const auto found = std::find_if(
        comparison.rows.begin(), comparison.rows.end(),
        [&](const ComparedRow& row) { return row.spec.key == comparison.table.reference; });
    return found == comparison.rows.end() ? nullptr : &*found;
}

void add_holm(ComparedFigure& figure) {
    std::vector<double> p;
    for (const ComparedLine& line : figure.lines) {
        if (line.against) p.push_back(line.against->p_permutation);
    }
    const std::vector<double> corrected = holm(p);
    std::size_t next = 0;
    for (ComparedLine& line : figure.lines) {
        if (line.against) line.p_holm = corrected[next++];
    }
}

/// Whether rows are runs of this search by one budget: made here, or files that one command has
/// made.
bool are_runs(const std::vector<const ComparedRow*>& rows, const std::string& search) {
    std::set<std::optional<std::string>> makers;
    std::size_t files = 0;
    for (const ComparedRow* row : rows) {
        if (row->spec.network.empty() && row->spec.settings_file.empty()) continue;
        makers.insert(command_in(row->origin, search));
        ++files;
    }
    if (files == 0) return true;
    return files == rows.size() && makers.size() == 1 && makers.begin()->has_value();
}

bool is_whole(const Comparison& comparison, const ComparedRow& row) {
    return row.rows.size() >= static_cast<std::size_t>(comparison.table.episodes);
}

/// Marks the median run of each search by this figure. An even number of runs has two in the
/// middle, neither of which is it; while a run is unfinished, nobody knows which it will be.
void mark_medians(const Comparison& comparison, ComparedFigure& figure) {
    std::map<std::string, std::vector<std::size_t>> searches;
    for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
        const auto& search = comparison.rows[i].spec.search;
        if (!search.empty()) searches[search].push_back(i);
    }
    for (auto& [search, lines] : searches) {
        std::vector<const ComparedRow*> rows;
        for (const std::size_t i : lines) rows.push_back(&comparison.rows[i]);
        if (lines.size() < 3 || lines.size() % 2 == 0 || !are_runs(rows, search)) continue;
        const bool known = std::ranges::all_of(lines, [&](std::size_t i) {
            return figure.lines[i].s.mean && is_whole(comparison, comparison.rows[i]);
        });
        if (!known) continue;
        std::stable_sort(lines.begin(), lines.end(), [&](std::size_t x, std::size_t y) {
            return *figure.lines[x].s.mean < *figure.lines[y].s.mean;
        });
        figure.lines[lines[lines.size() / 2]].label += " (median run)";
    }
}

ComparedLine line_of(const Comparison& comparison, const ComparedRow& row,
                     const ComparedRow* reference, const Figure& figure,
                     const std::map<int, double>& base) {
    const auto values = values_of(row, figure);
    ComparedLine line{row.spec.key, row.spec.label, statistics(sample_of(values)), std::nullopt};
    if (!is_whole(comparison, row)) {
        line.label +=
            fmt::format(" (unfinished: {} of {})", row.rows.size(), comparison.table.episodes);
    }
    if (&row == reference) return line;
    const int scenarios = spec::scenarios_of(comparison.table.task.name);
    const auto [ours, theirs] = trial_pairs(values, base, scenarios);
    line.against = paired(ours, theirs);
    if (line.against && figure.is_signed) line.against->ratio.reset();
    return line;
}

std::vector<ComparedFigure> figures_in(const Comparison& comparison) {
    const ComparedRow* reference = reference_of(comparison);
    std::vector<ComparedFigure> out;
    for (const Figure& figure : figures_of(comparison.table.task)) {
        ComparedFigure compared{figure.name, figure.title, {}};
        const auto base =
            reference == nullptr ? std::map<int, double>() : values_of(*reference, figure);
        for (const ComparedRow& row : comparison.rows) {
            compared.lines.push_back(line_of(comparison, row, reference, figure, base));
        }
        add_holm(compared);
        mark_medians(comparison, compared);
        out.push_back(std::move(compared));
    }
    return out;
}

std::vector<SurvivalLine> survival_in(const Comparison& comparison) {
    if (comparison.table.task.name != "keepaway") return {};
    const ComparedRow* reference = reference_of(comparison);
    const auto base = reference == nullptr ? std::map<int, Lifetime>() : lifetimes_of(*reference);
    std::vector<SurvivalLine> out;
    for (const ComparedRow& row : comparison.rows) {
        const auto lives = lifetimes_of(row);
        SurvivalLine line{row.spec.key, row.spec.label, survival(sample_of(lives)), std::nullopt};
        if (&row != reference) {
            const auto [ours, theirs] = pairs_of(lives, base);
            line.against = survival_test(ours, theirs);
        }
        out.push_back(std::move(line));
    }
    return out;
}

Circumstances circumstances_of(const ComparedRow& row) {
    Circumstances out;
    out.episodes = row.rows.size();
    std::vector<double> takers, keepers;
    std::map<std::string, int> endings;
    double falls = 0.0, minutes = 0.0;
    for (std::size_t i = 0; i < row.rows.size(); ++i) {
        ++endings[row.rows[i].reason];
        const auto& result = row.results[i];
        if (!result) {
            ++out.failed;
            continue;
        }
        out.truncated += result->status == k3d::episode::Status::Truncated;
        for (const auto& player : result->players) {
            (player.team == "right" ? takers : keepers).push_back(player.mean_speed);
            falls += player.falls;
            minutes += result->hold_time_s / 60.0;
        }
    }
    out.taker_speed = statistics(takers).mean;
    out.keeper_speed = statistics(keepers).mean;
    if (minutes > 0.0) out.falls_per_minute = falls / minutes;
    for (const auto& [reason, count] : endings) {
        out.endings += fmt::format("{}{} {}", out.endings.empty() ? "" : ", ", reason, count);
    }
    return out;
}

void read_results(ComparedRow& row) {
    row.results.clear();
    for (const ledger::Row& r : row.rows) {
        row.results.push_back(r.result.empty() ? std::nullopt
                                               : std::optional(k3d::episode::from_line(r.result)));
    }
}

}  // namespace

Comparison compare(spec::TableSpec table, std::vector<ComparedRow> rows,
                   std::vector<spec::PaperRow> paper) {
    Comparison out{std::move(table), std::move(rows), std::move(paper), {}, {}, {}};
    for (ComparedRow& row : out.rows) read_results(row);
    out.figures = figures_in(out);
    out.survival = survival_in(out);
    for (const ComparedRow& row : out.rows) out.circumstances.push_back(circumstances_of(row));
    return out;
}

std::string episodes_csv(const Comparison& comparison) {
    const std::vector<Figure> figures = figures_of(comparison.table.task);
    std::string text = "row,episode,seed,status,reason";
    for (const Figure& figure : figures) text += "," + figure.name;
    text += '\n';
    for (const ComparedRow& row : comparison.rows) {
        for (std::size_t i = 0; i < row.rows.size(); ++i) {
            const ledger::Row& r = row.rows[i];
            text += fmt::format("{},{},{},{},{}", row.spec.key, r.key.episode, r.seed, r.status,
                                csv_quoted(r.reason));
            for (const Figure& figure : figures) {
                const auto value = row.results[i] ? figure.value(r, *row.results[i]) : std::nullopt;
                text += value ? fmt::format(",{}", *value) : ",";
            }
            text += '\n';
        }
    }
    return text;
}

std::string warning(const Comparison& comparison) {
    std::set<std::string> versions;
    for (const ComparedRow& row : comparison.rows) versions.insert(row.version);
    if (versions.size() < 2) return "";
    return fmt::format(
        "Rows were played by different versions of the code: {}. Their episodes can be "
        "compared only where the versions play alike.",
        fmt::join(versions, ", "));
}

}  // namespace k3d::optimizer::report

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/run_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <map>

#include "common/config/config.h"
#include "optimizer/spec/settings.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer::report {

namespace {

using episode::Phase;

/// RFC 4180: quotes only where they are needed.
std::string cell(const std::string& text) {
    return text.find_first_of(",\"\r\n") == std::string::npos ? text : csv_quoted(text);
}

/// Figures of the EpisodeResult; empty cells for an episode without one.
std::string result_cells(const std::string& line) {
    if (line.empty()) return ",,,,,,";
    const k3d::episode::Result r = k3d::episode::from_line(line);
    int falls = 0;
    for (const auto& player : r.players) falls += player.falls;
    std::string metrics;
    for (const auto& [name, value] : r.metrics) {
        metrics += fmt::format("{}{}={}", metrics.empty() ? "" : ";", name, value);
    }
    return fmt::format("{},{},{},{},{},{},{}", r.hold_time_s,
                       r.attempts ? std::to_string(*r.attempts) : "", r.kicks, r.passes_completed,
                       falls, cell(metrics), r.state_hash);
}

/// Two-sided 95 % point of Student's t with so many degrees of freedom, at least 1.
double t_95(std::size_t freedom) {
    const boost::math::students_t t(static_cast<double>(freedom));
    return boost::math::quantile(boost::math::complement(t, 0.025));
}

std::string number(const nlohmann::json& value) {
    return value.is_number_float() ? fmt::format("{:.4g}", value.get<double>()) : value.dump();
}

std::vector<std::string> columns_of(const std::vector<nlohmann::json>& log) {
    std::vector<std::string> columns{"generation"};
    for (const nlohmann::json& line : log) {
        for (const auto& [name, value] : line.items()) {
            if (value.is_structured()) continue;
            if (std::find(columns.begin(), columns.end(), name) == columns.end()) {
                columns.push_back(name);
            }
        }
    }
    return columns;
}

std::string generations_table(const std::vector<nlohmann::json>& log) {
    if (log.empty()) return "";
    std::string text;
    const auto columns = columns_of(log);
    const auto width = [](const std::string& name) { return std::max<std::size_t>(8, name.size()); };
    for (const std::string& name : columns) text += fmt::format(" {:>{}}", name, width(name));
    text += '\n';
    for (const nlohmann::json& line : log) {
        for (const std::string& name : columns) {
            text += fmt::format(" {:>{}}", line.contains(name) ? number(line[name]) : "",
                                width(name));
        }
        text += '\n';
    }
    return text;
}

/// What --set takes as it is written, a file takes in quotes if it is a text.
std::string toml_value(const std::string& value) {
    const bool is_toml = config::line_of("value = " + value, "value").has_value();
    return is_toml ? value : spec::quote_word(value);
}

}  // namespace

std::string csv_quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

std::string csv(const std::vector<ledger::Row>& rows, bool canonical) {
    std::string text =
        "phase,generation,candidate,episode,seed,fingerprint,status,reason,fitness,simulated_s,"
        "hold_time_s,attempts,kicks,passes_completed,falls,metrics,state_hash";
    text += canonical ? "\n" : ",tries,wall_s,worker\n";
    for (const ledger::Row& row : rows) {
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}", episode::name_of(row.key.phase),
                            row.key.generation, row.key.candidate, row.key.episode, row.seed,
                            row.fingerprint, row.status, cell(row.reason), row.fitness,
                            row.simulated_s, result_cells(row.result));
        if (!canonical) {
            text += fmt::format(",{},{:.3f},{}", row.attempt, row.wall_s, cell(row.worker));
        }
        text += '\n';
    }
    return text;
}

std::string generations_csv(const std::vector<nlohmann::json>& log) {
    const auto columns = columns_of(log);
    std::string text = fmt::format("{}\n", fmt::join(columns, ","));
    for (const nlohmann::json& line : log) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const bool has = line.contains(columns[i]);
            if (i > 0) text += ',';
            if (has) text += cell(line[columns[i]].is_string() ? line[columns[i]].get<std::string>()
                                                               : line[columns[i]].dump());
        }
        text += '\n';
    }
    return text;
}

Statistics fitness_of(const std::vector<ledger::Row>& rows, Phase phase,
                      std::optional<std::uint64_t> candidate) {
    std::vector<double> sample;
    for (const ledger::Row& row : rows) {
        if (row.key.phase != phase || (candidate && row.key.candidate != *candidate)) continue;
        sample.push_back(row.fitness);
    }
    return statistics(sample);
}

std::optional<double> half_width_95(const Statistics& s) {
    return s.se ? std::optional(*s.se * t_95(s.n - 1)) : std::nullopt;
}

std::string describe(const Statistics& s) {
    if (!s.mean) return "none";
    if (!s.se) return fmt::format("{:.4g} (n {})", *s.mean, s.n);
    const double half = *half_width_95(s);
    return fmt::format("{:.4g} (n {}, sd {:.3g}, se {:.3g}, 95 % {:.4g} to {:.4g})", *s.mean, s.n,
                       *s.sd, *s.se, *s.mean - half, *s.mean + half);
}

std::string course(const ledger::Ledger& ledger, const std::optional<std::string>& ended) {
    const ledger::Facts facts = ledger.facts();
    const auto fact = [&facts](const char* name) {
        const auto found = facts.find(name);
        return found == facts.end() ? std::string("-") : found->second;
    };
    const auto totals = ledger.totals();
    const auto rows = ledger.rows();
    std::string text = fmt::format("{}: begun {} by version {}, {}\n", fact("name"), fact("begun"),
                                   fact("code_version"),
                                   ended ? "search ended: " + *ended : "search not ended");
    text += fmt::format("{} episodes, {:.2f} simulated hours, {} failed; {} failed tries\n",
                        totals.episodes, totals.simulated_s / 3600.0, totals.failed,
                        ledger.failed_tries().size());
    text += generations_table(ledger.log());
    text += "champion on test seeds: " + describe(fitness_of(rows, Phase::Test)) + "\n";
    text += "untuned on test seeds:  " + describe(fitness_of(rows, Phase::Baseline)) + "\n";
    for (const ledger::FailedTry& failed : ledger.failed_tries()) {
        text += fmt::format("failed try {} of {}: {}\n", failed.attempt, failed.key.text(),
                            failed.reason);
    }
    return text;
}

std::string champion_file(const spec::Experiment& experiment, const algorithm::Champion& champion,
                          const std::string& origin) {
    const auto* values = std::get_if<std::vector<double>>(&champion.payload);
    if (values == nullptr || experiment.start_network) {
        network::Definition learned = values == nullptr
                                          ? std::get<network::Definition>(champion.payload)
                                          : spec::with_weights(*experiment.start_network, *values);
        learned.description = origin;  // what the start network says of itself holds no longer
        return network::to_json(learned) + "\n";
    }
    // What was tuned, and what the search fixed for the agents.
    std::map<std::string, std::string> settings;
    const spec::Settings fixed = spec::parse_settings(experiment.task.settings);
    const bool takers = experiment.task.tuned == "taker";
    for (const std::string& word : takers ? fixed.taker : fixed.keeper) {
        const auto sign = word.find('=');
        settings[word.substr(0, sign)] = toml_value(word.substr(sign + 1));
    }
    for (const auto& [path, value] : spec::settings_of(experiment, *values)) settings[path] = value;
    std::map<std::string, std::string> sections;
    for (const auto& [path, value] : settings) {
        const auto dot = path.rfind('.');
        std::string& section = sections[dot == std::string::npos ? "" : path.substr(0, dot)];
        section += fmt::format("{} = {}\n",
                               dot == std::string::npos ? path : path.substr(dot + 1), value);
    }
    std::string text = "# " + origin + "\n";
    for (const auto& [name, lines] : sections) {
        if (!name.empty()) text += "\n[" + name + "]\n";
        text += lines;
    }
    return text;
}

}  // namespace k3d::optimizer::report

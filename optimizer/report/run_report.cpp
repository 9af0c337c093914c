// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/run_report.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>

#include "optimizer/fitness/fitness.h"
#include "optimizer/report/curves.h"
#include "optimizer/report/network_drawing.h"
#include "optimizer/report/run_plots.h"
#include "optimizer/report/run_text.h"
#include "optimizer/report/svg_plot.h"
#include "optimizer/report/write_file.h"

namespace k3d::optimizer::report {

namespace {

using episode::Phase;

constexpr std::string_view kStyle = R"(
:root { --ground: #ffffff; --ink: #1c2328; --dim: #5c666d; --rule: #dfe4e7; --soft: #f4f6f7; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #14191d; --ink: #e6eaed; --dim: #9aa5ad; --rule: #2f383e; --soft: #1c2328; }
}
body { margin: 0 auto; padding: 24px; max-width: 1100px; background: var(--ground);
  color: var(--ink); font: 15px/1.5 system-ui, sans-serif; }
h1 { margin: 0; font-size: 26px; } h2 { margin: 32px 0 8px; font-size: 18px; }
.figures { display: flex; flex-wrap: wrap; gap: 12px; margin: 16px 0; }
.figures div { background: var(--soft); border-radius: 8px; padding: 10px 16px; }
.figures b { display: block; font-size: 22px; } .dim { color: var(--dim); }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); gap: 16px; }
.plots > * { background: var(--soft); border-radius: 8px; padding: 8px; box-sizing: border-box; }
table { border-collapse: collapse; } .wide { overflow-x: auto; }
th, td { padding: 3px 12px; border-bottom: 1px solid var(--rule); text-align: right; }
th:first-child, td:first-child, td[colspan] { text-align: left; }
th { color: var(--dim); font-weight: 500; }
pre { background: var(--soft); border-radius: 8px; padding: 12px; overflow-x: auto; font-size: 13px; }
)";

std::string number(double value) {
    return fmt::format("{:.4g}", value);
}

std::string figure(const std::string& value, const std::string& meaning) {
    return fmt::format("<div><b>{}</b><span class=\"dim\">{}</span></div>\n", escape(value),
                       escape(meaning));
}

std::string with_interval(const Statistics& s) {
    const auto half = half_width_95(s);
    if (!s.mean) return "-";
    return half ? fmt::format("{} ± {}", number(*s.mean), number(*half)) : number(*s.mean);
}

std::string statistics_row(const std::string& name, const Statistics& s) {
    const auto cell = [](const std::optional<double>& value) {
        return value ? number(*value) : std::string("-");
    };
    const auto half = half_width_95(s);
    const std::string interval =
        half ? fmt::format("{} to {}", number(*s.mean - *half), number(*s.mean + *half)) : "-";
    return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                       escape(name), s.n, cell(s.mean), cell(s.sd), cell(s.se), interval);
}

std::string champion_table(const RunFacts& run, const std::vector<ledger::Row>& rows) {
    std::string out =
        "<h2>Champion</h2>\n<div class=\"wide\"><table id=\"champion\"><tr><th>fitness</th><th>n</th>"
        "<th>mean</th><th>sd</th><th>se</th><th>95 % interval</th></tr>\n";
    if (run.champion) {
        const auto id = run.champion->candidate;
        out += statistics_row("training seeds (it was chosen by these or after them)",
                              fitness_of(rows, Phase::Train, id));
        out += statistics_row("validation seeds (it was chosen by these)",
                              fitness_of(rows, Phase::Validation, id));
    }
    out += statistics_row("test seeds (never seen before)", fitness_of(rows, Phase::Test));
    out += statistics_row("untuned (the task's settings alone) on the test seeds",
                          fitness_of(rows, Phase::Baseline));
    const int scenarios = spec::scenarios_of(run.experiment.task.name);
    out += statistics_row(
        scenarios > 0 ? "champion less untuned, by scenario" : "champion less untuned, by seed",
        paired_difference(rows, scenarios));
    const char* trials =
        scenarios > 0 ? ", that of the difference on scenarios, each the mean of its episodes" : "";
    return out + fmt::format(
                     "</table></div>\n<p class=\"dim\">Only the test row is a claim about "
                     "the champion: the rows above it helped to choose it. Intervals are "
                     "Student's t on episodes of this one run{}.</p>\n",
                     trials);
}

std::string values_table(const RunFacts& run) {
    if (!run.champion) return "";
    const auto* values = std::get_if<std::vector<double>>(&run.champion->payload);
    if (values == nullptr) return "";
    const spec::Problem problem = spec::problem_of(run.experiment);
    const auto& parameters = std::get<spec::VectorProblem>(problem);
    std::string out =
        "<h2>Its values</h2>\n<div class=\"wide\"><table><tr><th>parameter</th><th>champion</th>"
        "<th>start</th><th>lower</th><th>upper</th></tr>\n";
    for (std::size_t i = 0; i < parameters.size() && i < values->size(); ++i) {
        const spec::Parameter& p = parameters[i];
        out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                           escape(p.name + (p.frozen ? " (frozen)" : "")), number((*values)[i]),
                           number(p.start), number(p.lower), number(p.upper));
    }
    return out + "</table></div>\n";
}

/// Of a search for networks: the champion, whose weights and nodes tell more than a table of them.
std::string network_picture(const RunFacts& run) {
    if (!run.champion) return "";
    const auto* network = std::get_if<network::Definition>(&run.champion->payload);
    if (network == nullptr) return "";
    return "<h2>Its network</h2>\n<div class=\"wide\">" + svg_network(*network) +
           "</div>\n<p class=\"dim\">Blue adds, orange takes away; broader is stronger. Point at a link "
           "for its weight.</p>\n";
}

/// How episodes ended, and all that did not.
std::string endings(const RunFacts& run, const std::vector<ledger::Row>& rows) {
    std::map<std::string, std::array<int, 4>> counts;
    for (const ledger::Row& row : rows) {
        const std::string name = row.status == "finished" ? row.reason : row.reason + " (" + row.status + ")";
        ++counts[name][static_cast<std::size_t>(row.key.phase)];
    }
    std::string out =
        "<h2>How episodes ended</h2>\n<div class=\"wide\"><table><tr><th>reason</th><th>training</th>"
        "<th>validation</th><th>test</th><th>untuned</th></tr>\n";
    for (const auto& [name, n] : counts) {
        out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                           escape(name), n[0], n[1], n[2], n[3]);
    }
    out += "</table></div>\n";
    const auto failed = run.ledger.failed_tries();
    if (failed.empty()) return out + "<p>No try of any episode failed.</p>\n";
    out += fmt::format("<p>{} tries failed and were repeated; an episode without a valid result in "
                       "all its tries counts {}.</p>\n<pre>",
                       failed.size(), number(run.experiment.task.worst));
    for (std::size_t i = 0; i < failed.size() && i < 100; ++i) {
        out += escape(fmt::format("{} try {}: {}\n", failed[i].key.text(), failed[i].attempt,
                                  failed[i].reason));
    }
    return out + "</pre>\n";
}

/// What the run had otherwise than its file says: not every command names it.
std::string overrides(const ledger::Facts& facts) {
    const auto found = facts.find("overrides");
    if (found == facts.end()) return "";
    std::string lines;
    for (const nlohmann::json& text : nlohmann::json::parse(found->second)) {
        lines += escape(text.get<std::string>()) + "\n";
    }
    if (lines.empty()) return "";
    return fmt::format("<p>Settings of this run, stronger than the file:</p>\n"
                       "<pre id=\"overrides\">{}</pre>\n",
                       lines);
}

std::string origin(const RunFacts& run, const ledger::Facts& facts) {
    const auto fact = [&facts](const char* name) {
        const auto found = facts.find(name);
        return escape(found == facts.end() ? "-" : found->second);
    };
    return fmt::format(
        "<h2>How it was made</h2>\n<pre>{}</pre>\n"
        "<p>Code version {}, begun {}, run {}. All seeds follow from seed {} of the experiment; "
        "those of every episode are in episodes.csv. The same experiment, seed and version give "
        "the same rows on any number of workers.</p>\n"
        "<details open><summary>The experiment, {}</summary><pre>{}</pre></details>\n{}",
        fact("command"), fact("code_version"), fact("begun"), fact("id"), run.experiment.seed,
        fact("file"), fact("experiment"), overrides(facts));
}

}  // namespace

std::string_view page_style() { return kStyle; }

std::vector<std::string> value_names(const spec::Experiment& experiment) {
    const spec::Problem problem = spec::problem_of(experiment);
    std::vector<std::string> names;
    if (const auto* parameters = std::get_if<spec::VectorProblem>(&problem)) {
        for (const spec::Parameter& p : *parameters) names.push_back(p.name);
    }
    return names;
}

std::string origin_of(const algorithm::Champion& champion, const ledger::Facts& facts) {
    return fmt::format(
        "candidate {} of run {}, version {}; fitness {:.4g} (se {:.3g}, n {}) on {} seeds",
        champion.candidate, facts.at("id"), facts.at("code_version"), champion.score.mean,
        champion.score.se, champion.score.n, champion.validated ? "validation" : "training");
}

std::string provenance_of(const algorithm::Champion& champion, const spec::Experiment& experiment,
                          const ledger::Ledger& ledger) {
    const ledger::Facts facts = ledger.facts();
    const auto totals = ledger.totals();
    return fmt::format(
        "{}; found by '{}', seed {}, in {} generations, {} episodes, {:.1f} simulated hours",
        origin_of(champion, facts), facts.at("command"), experiment.seed, ledger.log().size(),
        totals.episodes, totals.simulated_s / 3600.0);
}

std::optional<std::string> command_in(const std::string& provenance, const std::string& search) {
    constexpr std::string_view kBegin = "; found by '", kEnd = "', seed ";
    const auto begin = provenance.find(kBegin);
    const auto end = provenance.find(kEnd, begin);
    const auto run = provenance.find(fmt::format(" of run {}-", search));
    if (run > begin || end == std::string::npos) return std::nullopt;
    return provenance.substr(begin + kBegin.size(), end - begin - kBegin.size());
}

std::string report_html(const RunFacts& run) {
    const ledger::Facts facts = run.ledger.facts();
    const auto rows = run.ledger.rows();
    const auto totals = run.ledger.totals();
    const spec::Experiment& e = run.experiment;
    const std::string measure = fitness::measure(e.task);
    const int scenarios = spec::scenarios_of(e.task.name);
    std::string out = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width\"><title>{0}</title>\n"
        "<style>{1}{2}</style></head><body>\n<h1>{0}</h1>\n<p>{3}</p>\n<p class=\"dim\">{4} on {5}, "
        "fitness {6}; search {7}</p>\n",
        escape(e.name), kStyle, kPlotStyle, escape(e.description), escape(e.algorithm.name),
        escape(e.task.name), escape(measure),
        run.ended ? "ended: " + escape(*run.ended) : std::string("not ended"));
    out += "<div class=\"figures\">\n" +
           figure(with_interval(fitness_of(rows, Phase::Test)), "champion, test seeds") +
           figure(with_interval(fitness_of(rows, Phase::Baseline)), "untuned, same seeds") +
           figure(with_interval(paired_difference(rows, scenarios)),
                  scenarios > 0 ? "difference by scenario" : "difference by seed") +
           figure(std::to_string(totals.episodes), "episodes") +
           figure(fmt::format("{:.2f} h", totals.simulated_s / 3600.0), "simulated") +
           figure(std::to_string(totals.failed), "failed episodes") + "</div>\n";
    out += "<div class=\"plots\">\n" + plots(curves_of(run.ledger, value_names(e)), rows, measure) +
           "</div>\n";
    out += champion_table(run, rows) + values_table(run) + network_picture(run);
    out += endings(run, rows) + origin(run, facts);
    return out + "</body></html>\n";
}

std::string write_report(const RunFacts& run, const std::string& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault) throw std::runtime_error(folder + ": " + fault.message());
    write_file(folder + "/report.html", report_html(run));
    write_file(folder + "/episodes.csv", csv(run.ledger.rows(), false));
    write_file(folder + "/generations.csv", generations_csv(run.ledger.log()));
    if (run.champion) {
        const bool network = run.experiment.start_network.has_value();
        write_file(folder + (network ? "/champion.json" : "/champion.toml"),
                   champion_file(run.experiment, *run.champion,
                                 provenance_of(*run.champion, run.experiment, run.ledger)));
    }
    return folder + "/report.html";
}

}  // namespace k3d::optimizer::report

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/reproduction_page.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "optimizer/report/run_report.h"
#include "optimizer/report/run_text.h"
#include "optimizer/report/svg_plot.h"
#include "optimizer/report/write_file.h"

namespace k3d::optimizer::report {

namespace {

const std::vector<std::string> kHeads{"search", "run", "algorithm", "fitness", "generations",
                                      "episodes", "simulated h", "process h", "failed",
                                      "finished", "version", "champion"};

/// "NEAT as in the paper, run 2" for the second run of several.
std::string name_of(const SearchReport& s) {
    return fmt::format("{}, run {}", s.search.label, s.run);
}

std::vector<std::string> cells(const SearchReport& s) {
    if (!s.fault.empty()) {
        std::vector<std::string> cells(kHeads.size());
        cells[0] = s.search.name;
        cells[1] = std::to_string(s.run);
        cells.back() = "cannot be read: " + s.fault;
        return cells;
    }
    return {s.search.name,
            std::to_string(s.run),
            s.algorithm,
            s.measure,
            std::to_string(s.generations),
            std::to_string(s.totals.episodes),
            fmt::format("{:.2f}", s.totals.simulated_s / 3600.0),
            fmt::format("{:.2f}", s.totals.wall_s / 3600.0),
            std::to_string(s.totals.failed),
            s.finished ? "yes" : "no",
            s.version,
            s.champion};
}

std::string line_of(const SearchReport& s) {
    if (!s.fault.empty()) return fmt::format("  {:<52} cannot be read: {}\n", name_of(s), s.fault);
    return fmt::format("  {:<52} {:>4} generations {:>7} episodes {:>8.2f} simulated h{}\n", name_of(s),
                       s.generations, s.totals.episodes, s.totals.simulated_s / 3600.0,
                       s.finished ? "" : " (not finished)");
}

/// Best of training and the validated champion over the generations, all runs of a part.
std::string learning_plot(const Reproduction& r, const std::string& part) {
    std::map<std::string, std::vector<Series>> by_measure;
    for (const SearchReport& s : r.searches) {
        if (s.search.part != part) continue;
        // Figure 2 of the paper shows the best of each generation; champions say more of noisy ones.
        const bool drill = part == "fig2" || part == "fig3";
        Series line{name_of(s), {}, {}, {}, {}};
        if (drill) {
            for (const GenerationFigures& g : s.curves.fitness) {
                line.x.push_back(g.generation);
                line.y.push_back(g.best);
            }
        } else {
            for (const ValidatedFigures& v : s.curves.champion) {
                line.x.push_back(v.generation);
                line.y.push_back(v.mean);
                line.low.push_back(v.mean - v.se);
                line.high.push_back(v.mean + v.se);
            }
        }
        if (!line.x.empty()) by_measure[s.measure].push_back(std::move(line));
    }
    std::string out;
    for (const auto& [measure, series] : by_measure) {
        const char* title = part == "fig2" ? "Kick: best fitness of each generation (paper, Fig. 2)"
                            : part == "fig3" ? "Prediction: best fitness of each generation"
                                             : "Champion on validation seeds (band: se)";
        out += line_plot({title, "generation", measure}, series);
    }
    return out;
}

/// Paper, Fig. 3b: error of the predicted stopping point over the time since the ball was sent off.
std::string error_plot(const Comparison& table) {
    std::vector<Series> series;
    for (const ComparedRow& row : table.rows) {
        std::map<double, std::vector<double>> errors;
        for (const auto& result : row.results) {
            if (!result) continue;
            for (const auto& [name, value] : result->metrics) {
                double after = 0.0;
                if (std::sscanf(name.c_str(), "finish_error_%lfs_m", &after) == 1) {
                    errors[after].push_back(value);
                }
            }
        }
        Series line{row.spec.label, {}, {}, {}, {}};
        for (const auto& [after, sample] : errors) {
            const Statistics s = statistics(sample);
            const double half = half_width_95(s).value_or(0.0);
            line.x.push_back(after);
            line.y.push_back(*s.mean);
            line.low.push_back(*s.mean - half);
            line.high.push_back(*s.mean + half);
        }
        if (!line.x.empty()) series.push_back(std::move(line));
    }
    if (series.empty()) return "";
    return line_plot({"Error of the predicted stop (paper, Fig. 3b; band: 95 %)", "s since it rolls", "m"},
                     series);
}

/// The champion is a sentence that names the version, so it stands below its search's figures.
std::string searches_html(const Reproduction& r) {
    std::string out = "<h2>Searches</h2>\n<div class=\"wide\"><table><tr>";
    const std::size_t figures = kHeads.size() - 2;
    for (std::size_t i = 0; i < figures; ++i) out += "<th>" + kHeads[i] + "</th>";
    out += "</tr>\n";
    for (const SearchReport& s : r.searches) {
        const auto said = cells(s);
        out += "<tr>";
        for (std::size_t i = 0; i < figures; ++i) out += "<td>" + escape(said[i]) + "</td>";
        const std::string& version = said[figures];
        const std::string& champion = said[figures + 1];
        out += fmt::format("</tr>\n<tr class=\"dim\"><td colspan=\"{}\">{}</td></tr>\n", figures,
                           escape(champion.empty() ? "version " + version : champion));
    }
    return out + "</table></div>\n";
}

}  // namespace

std::string searches_csv(const Reproduction& r) {
    std::string text = fmt::format("{}\n", fmt::join(kHeads, ","));
    for (const SearchReport& s : r.searches) {
        std::string line;
        for (const std::string& cell : cells(s)) {
            line += (line.empty() ? "" : ",") + csv_quoted(cell);
        }
        text += line + "\n";
    }
    return text;
}

std::string reproduction_csv(const Reproduction& r) {
    std::string text = comparison_csv_head();
    for (const Comparison& table : r.tables) text += comparison_csv(table);
    return text;
}

std::string reproduction_text(const Reproduction& r) {
    std::string text = fmt::format("budget {}: {}\nreport by version {}\n\nSearches\n", r.budget,
                                   r.description, r.version);
    for (const SearchReport& s : r.searches) text += line_of(s);
    for (const Comparison& table : r.tables) text += "\n" + comparison_text(table);
    return text;
}

std::string reproduction_html(const Reproduction& r) {
    std::string out = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width\"><title>Reproduction</title>\n"
        "<style>{}{}</style></head><body>\n<h1>The paper's results, reproduced</h1>\n<p>Budget {}: "
        "{}</p>\n<p class=\"dim\">Champions were chosen on validation seeds and play here once, on "
        "test "
        "seeds that no search has seen, on the exact stepper with noise, six processes an episode "
        "(drills: two). All rows of a table share seeds, skills and takers. The champion "
        "of table 1 is the one with the best validated mean; each run is validated on seeds of its "
        "own. Report by version {}.</p>\n",
        page_style(), kPlotStyle, escape(r.budget), escape(r.description), escape(r.version));
    out += searches_html(r);
    for (const std::string& part : spec::kParts) {
        std::string plots = learning_plot(r, part);
        std::string tables;
        for (const Comparison& table : r.tables) {
            if (table.table.part != part) continue;
            if (part == "fig3") plots += error_plot(table);
            tables += comparison_html(table);
        }
        if (!plots.empty()) out += "<div class=\"plots\">\n" + plots + "</div>\n";
        out += tables;
    }
    return out + "</body></html>\n";
}

std::string write_reproduction(const Reproduction& r, const std::string& folder) {
    write_file(folder + "/report.html", reproduction_html(r));
    write_file(folder + "/tables.txt", reproduction_text(r));
    write_file(folder + "/tables.csv", reproduction_csv(r));
    write_file(folder + "/searches.csv", searches_csv(r));
    std::filesystem::create_directories(folder + "/episodes");
    for (const Comparison& table : r.tables) {
        write_file(folder + "/episodes/" + table.table.name + ".csv", episodes_csv(table));
    }
    return folder + "/report.html";
}

}  // namespace k3d::optimizer::report

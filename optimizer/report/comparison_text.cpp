// SPDX-License-Identifier: BSD-3-Clause
// A comparison as text, CSV and HTML.
#include <fmt/format.h>

#include <algorithm>

#include "optimizer/report/comparison.h"
#include "optimizer/report/run_text.h"
#include "optimizer/report/svg_plot.h"

namespace k3d::optimizer::report {

namespace {

std::string number(const std::optional<double>& value, int digits = 2) {
    return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string p_value(double p) {
    return p < 1e-4 ? "<0.0001" : fmt::format("{:.4f}", p);
}

std::string interval(const Statistics& s) {
    const auto half = half_width_95(s);
    return half ? fmt::format("{:.2f}..{:.2f}", *s.mean - *half, *s.mean + *half) : "-";
}

/// What is said of a line, cell by cell; the heads are kHeads.
std::vector<std::string> cells(const ComparedLine& line) {
    std::vector<std::string> out{std::to_string(line.s.n), number(line.s.mean), number(line.s.sd),
                                 number(line.s.se), interval(line.s)};
    if (!line.against) {
        out.insert(out.end(), 6, "");
        return out;
    }
    const Paired& p = *line.against;
    out.push_back(std::to_string(p.n));
    out.push_back(fmt::format("{:+.2f} ({:+.2f}..{:+.2f})", p.difference, p.low, p.high));
    out.push_back(p.ratio ? fmt::format("{:.2f} ({:.2f}..{:.2f})", *p.ratio, p.ratio_low, p.ratio_high)
                          : "-");
    out.push_back(p_value(p.p_permutation));
    out.push_back(p_value(line.p_holm));
    out.push_back(p_value(p.p_wilcoxon));
    return out;
}

/// Names of columns, and how wide they are in text.
using Heads = std::vector<std::pair<std::string, std::size_t>>;

const Heads kHeads{{"n", 5},     {"mean", 7},   {"sd", 7},          {"se", 6},
                   {"95 %", 14}, {"pairs", 5},  {"difference", 24}, {"ratio", 18},
                   {"p", 8},     {"p Holm", 8}, {"p Wilcoxon", 10}};

/// The paper's figures under one of ours; empty for one that it does not have.
std::vector<std::pair<std::string, std::string>> paper_lines(const Comparison& c,
                                                             const std::string& figure) {
    std::vector<std::pair<std::string, std::string>> out;
    for (const spec::PaperRow& row : c.paper) {
        const bool attempts = figure == "attempts";
        if (!attempts && figure != "hold_time_s") continue;
        out.emplace_back(row.label,
                         fmt::format("{} (se {}, n 100)", attempts ? row.attempts : row.hold_time_s,
                                     attempts ? row.attempts_se : row.hold_time_se));
    }
    return out;
}

std::string reference_label(const Comparison& c) {
    for (const ComparedRow& row : c.rows) {
        if (row.spec.key == c.table.reference) return row.spec.label;
    }
    return "-";
}

/// What pairs are, and that spread is not over them where they are means.
std::string pairs_said(const Comparison& c) {
    const int scenarios = std::min(spec::scenarios_of(c.table.task.name), c.table.episodes);
    if (scenarios == 0) return ", by seed";
    return fmt::format(
        "; pairs are the {} scenarios, each the mean of its episodes; n, mean, sd, se "
        "and the mean's 95 % are over single episodes",
        scenarios);
}

std::string text_head(const std::string& title, const Heads& heads) {
    std::string text = fmt::format("\n{}\n{:<52}", title, "");
    for (const auto& [head, width] : heads) text += fmt::format(" {:>{}}", head, width);
    return text + '\n';
}

std::string text_row(const std::string& label, const std::vector<std::string>& said,
                     const Heads& heads) {
    std::string text = fmt::format("{:<52}", label);
    for (std::size_t i = 0; i < said.size(); ++i)
        text += fmt::format(" {:>{}}", said[i], heads[i].second);
    text.erase(text.find_last_not_of(' ') + 1);
    return text + '\n';
}

std::string html_head(const std::string& title, const Heads& heads) {
    std::string out =
        fmt::format("<h3>{}</h3>\n<div class=\"wide\"><table><tr><th></th>", escape(title));
    for (const auto& [head, width] : heads) out += fmt::format("<th>{}</th>", head);
    return out + "</tr>\n";
}

std::string html_row(const std::string& label, const std::vector<std::string>& said) {
    std::string out = fmt::format("<tr><td>{}</td>", escape(label));
    for (const std::string& cell : said) out += fmt::format("<td>{}</td>", escape(cell));
    return out + "</tr>\n";
}

std::string figure_text(const Comparison& c, const ComparedFigure& figure) {
    std::string text = text_head(figure.title, kHeads);
    for (const ComparedLine& line : figure.lines) text += text_row(line.label, cells(line), kHeads);
    for (const auto& [label, said] : paper_lines(c, figure.name)) {
        text += fmt::format("{:<52} {}\n", label, said);
    }
    return text;
}

std::string figure_html(const Comparison& c, const ComparedFigure& figure) {
    std::string out = html_head(figure.title, kHeads);
    for (const ComparedLine& line : figure.lines) out += html_row(line.label, cells(line));
    for (const auto& [label, said] : paper_lines(c, figure.name)) {
        out += fmt::format("<tr class=\"dim\"><td>{}</td><td colspan=\"11\">{}</td></tr>\n",
                           escape(label), escape(said));
    }
    return out + "</table></div>\n";
}

constexpr const char* kSurvivalTitle =
    "Possession with the time limit counted: seconds held per episode that ended";
const Heads kSurvivalHeads{
    {"ended", 6}, {"at limit", 8}, {"s per end", 9}, {"ratio", 18}, {"p log-rank", 10}};

std::vector<std::string> cells(const SurvivalLine& line) {
    std::vector<std::string> out{std::to_string(line.s.ended), std::to_string(line.s.cut),
                                 number(line.s.s_per_end), "", ""};
    if (!line.against) return out;
    const SurvivalTest& t = *line.against;
    out[3] =
        t.ratio ? fmt::format("{:.2f} ({:.2f}..{:.2f})", *t.ratio, t.ratio_low, t.ratio_high) : "-";
    out[4] = p_value(t.p_log_rank);
    return out;
}

std::string survival_text(const Comparison& c) {
    if (c.survival.empty()) return "";
    std::string text = text_head(kSurvivalTitle, kSurvivalHeads);
    for (const SurvivalLine& line : c.survival)
        text += text_row(line.label, cells(line), kSurvivalHeads);
    return text;
}

std::string survival_html(const Comparison& c) {
    if (c.survival.empty()) return "";
    std::string out = html_head(kSurvivalTitle, kSurvivalHeads);
    for (const SurvivalLine& line : c.survival) out += html_row(line.label, cells(line));
    return out + "</table></div>\n";
}

/// What is said of row `i`, each with its name.
std::vector<std::pair<std::string, std::string>> said_of(const Comparison& c, std::size_t i) {
    const Circumstances& s = c.circumstances[i];
    return {{"episodes", std::to_string(s.episodes)},
            {"failed", std::to_string(s.failed)},
            {"at the limit", std::to_string(s.truncated)},
            {"takers m/s", number(s.taker_speed)},
            {"keepers m/s", number(s.keeper_speed)},
            {"falls per player and minute", number(s.falls_per_minute)},
            {"ended by", s.endings},
            {"who", c.rows[i].origin}};
}

std::string csv_cell(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : std::string();
}

/// The columns that say of a row how it was played.
std::string csv_tail(const Circumstances& s) {
    return fmt::format(",{},{},{}", csv_cell(s.taker_speed), s.failed, s.truncated);
}

std::string csv_line(const spec::TableSpec& table, const std::string& figure,
                     const ComparedLine& line, const Circumstances& said) {
    const auto half = half_width_95(line.s);
    std::string text = fmt::format("{},{},{},{},{},{},{},{},{},{},{}", table.name, line.key,
                                   csv_quoted(line.label), figure, line.s.n, csv_cell(line.s.mean),
                                   csv_cell(line.s.sd), csv_cell(line.s.se),
                                   half ? csv_cell(*line.s.mean - *half) : "",
                                   half ? csv_cell(*line.s.mean + *half) : "", table.reference);
    if (const auto& p = line.against) {
        const bool ratio = p->ratio.has_value();
        text += fmt::format(",{},{},{},{},{},{},{},{},{},{},{}", p->n, p->difference, p->low,
                            p->high, csv_cell(p->ratio), ratio ? csv_cell(p->ratio_low) : "",
                            ratio ? csv_cell(p->ratio_high) : "", p->p_permutation, line.p_holm,
                            p->p_wilcoxon, p->correlation);
    } else {
        text += std::string(11, ',');
    }
    return text + csv_tail(said) + ",\n";
}

/// In the same columns; of the mean and the ratio of what ended alone, so without spread or
/// interval of the mean.
std::string csv_line(const spec::TableSpec& table, const SurvivalLine& line,
                     const Circumstances& said) {
    std::string text = fmt::format("{},{},{},hold_s_per_end,{},{},,,,,{}", table.name, line.key,
                                   csv_quoted(line.label), line.s.ended + line.s.cut,
                                   csv_cell(line.s.s_per_end), table.reference);
    if (const auto& t = line.against) {
        const bool ratio = t->ratio.has_value();
        text +=
            fmt::format(",{},,,,{},{},{},,,,", t->pairs, csv_cell(t->ratio),
                        ratio ? csv_cell(t->ratio_low) : "", ratio ? csv_cell(t->ratio_high) : "");
    } else {
        text += std::string(11, ',');
    }
    return text + csv_tail(said) +
           (line.against ? fmt::format(",{}\n", line.against->p_log_rank) : ",\n");
}

}  // namespace

std::string comparison_text(const Comparison& c) {
    std::string text = fmt::format("{}\n{}\n", c.table.title, std::string(c.table.title.size(), '='));
    text +=
        fmt::format("differences, ratios and p against: {}{}\n", reference_label(c), pairs_said(c));
    if (const std::string said = warning(c); !said.empty()) text += said + "\n";
    for (const ComparedFigure& figure : c.figures) text += figure_text(c, figure);
    text += survival_text(c);
    text += '\n';
    for (std::size_t i = 0; i < c.rows.size(); ++i) {
        text += c.rows[i].spec.label + ":";
        for (const auto& [name, value] : said_of(c, i)) {
            if (value != "-") text += fmt::format(" {} {};", name, value);
        }
        text.back() = '\n';
    }
    return text;
}

std::string comparison_html(const Comparison& c) {
    std::string out = fmt::format(
        "<h2>{}</h2>\n<p class=\"dim\">Differences, ratios and p against: {}{}. p: signs of the "
        "differences flipped, two-sided; Holm: over the rows of the figure.</p>\n",
        escape(c.table.title), escape(reference_label(c)), pairs_said(c));
    if (const std::string said = warning(c); !said.empty()) out += "<p>" + escape(said) + "</p>\n";
    for (const ComparedFigure& figure : c.figures) out += figure_html(c, figure);
    out += survival_html(c);
    out += "<div class=\"wide\"><table><tr><th></th>";
    for (std::size_t i = 0; i < c.rows.size(); ++i) {
        if (i == 0) {
            for (const auto& [name, value] : said_of(c, i)) out += "<th>" + name + "</th>";
            out += "</tr>\n";
        }
        out += fmt::format("<tr><td>{}</td>", escape(c.rows[i].spec.label));
        for (const auto& [name, value] : said_of(c, i)) out += "<td>" + escape(value) + "</td>";
        out += "</tr>\n";
    }
    return out + "</table></div>\n";
}

std::string comparison_csv_head() {
    return "table,row,label,figure,n,mean,sd,se,low_95,high_95,reference,pairs,difference,"
           "difference_low_95,"
           "difference_high_95,ratio,ratio_low_95,ratio_high_95,p_permutation,p_holm,p_wilcoxon,"
           "correlation,taker_speed_mps,failed,truncated,p_log_rank\n";
}

std::string comparison_csv(const Comparison& c) {
    std::string text;
    for (const ComparedFigure& figure : c.figures) {
        for (std::size_t i = 0; i < figure.lines.size(); ++i) {
            text += csv_line(c.table, figure.name, figure.lines[i], c.circumstances[i]);
        }
    }
    for (std::size_t i = 0; i < c.survival.size(); ++i) {
        text += csv_line(c.table, c.survival[i], c.circumstances[i]);
    }
    return text;
}

}  // namespace k3d::optimizer::report

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/run_plots.h"

#include <algorithm>
#include <cmath>

#include "optimizer/report/run_text.h"
#include "optimizer/report/svg_plot.h"

namespace k3d::optimizer::report {

namespace {

using episode::Phase;

std::vector<double> counted(std::size_t count) {
    std::vector<double> x;
    for (std::size_t i = 0; i < count; ++i) x.push_back(static_cast<double>(i));
    return x;
}

std::string fitness_plot(const Curves& curves, const std::string& measure) {
    Series best{"best of training", {}, {}, {}, {}, true};
    Series mean{"mean (band: se)", {}, {}, {}, {}};
    Series median{"median", {}, {}, {}, {}};
    for (const GenerationFigures& g : curves.fitness) {
        for (Series* s : {&best, &mean, &median}) s->x.push_back(g.generation);
        best.y.push_back(g.best);
        median.y.push_back(g.median);
        mean.y.push_back(*g.all.mean);
        mean.low.push_back(*g.all.mean - g.all.se.value_or(0.0));
        mean.high.push_back(*g.all.mean + g.all.se.value_or(0.0));
    }
    Series champion{"champion, validated", {}, {}, {}, {}};
    for (const ValidatedFigures& v : curves.champion) {
        champion.x.push_back(v.generation);
        champion.y.push_back(v.mean);
        champion.low.push_back(v.mean - v.se);
        champion.high.push_back(v.mean + v.se);
    }
    return line_plot({"Fitness", "generation", measure}, {mean, best, median, champion});
}

std::string test_plot(const std::vector<ledger::Row>& rows, const std::string& measure) {
    std::vector<Sample> samples;
    for (const auto& [phase, label] :
         {std::pair{Phase::Test, "champion"}, std::pair{Phase::Baseline, "untuned"}}) {
        Sample sample{label, {}};
        for (const ledger::Row& row : rows) {
            if (row.key.phase == phase) sample.values.push_back(row.fitness);
        }
        const Statistics s = statistics(sample.values);
        if (!s.mean) continue;
        const double half = half_width_95(s).value_or(0.0);
        sample.mean = *s.mean;
        sample.low = *s.mean - half;
        sample.high = *s.mean + half;
        samples.push_back(std::move(sample));
    }
    if (samples.empty()) return "";
    return spread_plot({"Test episodes (bar below: mean and its 95 % interval)", measure, "episodes"},
                       samples);
}

std::string logged_plot(const Curves& curves, const Axes& axes,
                        const std::vector<std::string>& names) {
    std::vector<Series> series;
    for (const std::string& name : names) {
        const auto found = curves.logged.find(name);
        if (found == curves.logged.end()) continue;
        series.push_back({name, counted(found->second.size()), found->second, {}, {}});
    }
    return series.empty() ? "" : line_plot(axes, series);
}

}  // namespace

std::string plots(const Curves& curves, const std::vector<ledger::Row>& rows,
                  const std::string& measure) {
    std::string out = fitness_plot(curves, measure) + test_plot(rows, measure);
    if (!curves.species.empty()) {
        std::vector<std::vector<double>> layers;
        for (const auto& [id, sizes] : curves.species) layers.push_back(sizes);
        out += stack_plot({"Species", "generation", "members"}, counted(layers[0].size()), layers);
    }
    out += logged_plot(curves, {"Complexity of networks", "generation", "per network"},
                       {"mean_links", "most_links", "mean_hidden"});
    out += logged_plot(curves, {"Step size", "generation", "sigma"}, {"sigma"});
    for (const Trace& trace : curves.parameters) {
        Series best{"best of the generation", counted(trace.best.size()), trace.best, {}, {}};
        best.low = trace.low;
        best.high = trace.high;
        out += line_plot({trace.name + " (band: 80 % of candidates)", "generation", trace.name},
                         {best});
    }
    return out;
}

}  // namespace k3d::optimizer::report

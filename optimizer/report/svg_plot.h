// SPDX-License-Identifier: BSD-3-Clause
// Plots as SVG text to stand inside an HTML page, whose style sheet (kPlotStyle) colours them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace k3d::optimizer::report {

/// A line through points; NaN interrupts it. With as many `low` and `high` as points: a band.
struct Series {
    std::string label;
    std::vector<double> x, y;
    std::vector<double> low, high;
    bool dashed = false;
};

struct Axes {
    std::string title;
    std::string x, y;  ///< what they say, with unit
};

/// Colours follow the order of the series; after eight of them lines are dashed, then dotted. Names
/// stand below, in rows by which the picture grows.
std::string line_plot(const Axes& axes, const std::vector<Series>& series);

/// Values on top of each other, one layer each, e.g. members of species.
std::string stack_plot(const Axes& axes, const std::vector<double>& x,
                       const std::vector<std::vector<double>>& layers);

/// How samples are spread: a row of bars each, on one common axis, with the mean and its interval.
struct Sample {
    std::string label;
    std::vector<double> values;
    double mean = 0.0, low = 0.0, high = 0.0;
};
std::string spread_plot(const Axes& axes, const std::vector<Sample>& samples);

extern const std::string_view kPlotStyle;

/// & < > " as HTML wants them.
std::string escape(std::string_view text);

/// Round steps that cover a range, for ticks: at least two values.
std::vector<double> ticks(double low, double high);

}  // namespace k3d::optimizer::report

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace k3d::optimizer::report {

namespace {

constexpr double kWidth = 640.0;
constexpr double kHeight = 300.0;
constexpr double kLeft = 64.0, kRight = 16.0, kTop = 34.0, kBottom = 58.0;
constexpr double kLegendRow = 16.0, kKeyWidth = 20.0, kKeyGap = 5.0;
constexpr std::size_t kColours = 8;
constexpr std::size_t kBins = 24;

struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void include(double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void include(const std::vector<double>& values) {
        for (const double value : values) include(value);
    }
    /// Never empty, so that it can be divided by.
    void settle() {
        if (!(low <= high)) low = high = 0.0;
        if (high - low < 1e-12 * std::max(1.0, std::abs(low))) {
            low -= 0.5;
            high += 0.5;
        }
    }
};

/// From values to places in the picture.
struct Frame {
    Extent x, y;
    double px(double value) const {
        return kLeft + (value - x.low) / (x.high - x.low) * (kWidth - kLeft - kRight);
    }
    double py(double value) const {
        return kHeight - kBottom - (value - y.low) / (y.high - y.low) * (kHeight - kTop - kBottom);
    }
};

std::string open(const Axes& axes, double height = kHeight) {
    return fmt::format(
        "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n"
        "<text class=\"title\" x=\"{}\" y=\"20\">{}</text>\n",
        kWidth, height, escape(axes.title), kLeft, escape(axes.title));
}

std::string grid(const Frame& frame, const Axes& axes, bool y_ticks) {
    std::string out;
    const double bottom = kHeight - kBottom;
    for (const double value : ticks(frame.x.low, frame.x.high)) {
        if (value < frame.x.low || value > frame.x.high) continue;
        out += fmt::format(
            "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/>"
            "<text class=\"tick\" x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:g}</text>\n",
            frame.px(value), kTop, bottom, bottom + 16, value);
    }
    for (const double value : ticks(frame.y.low, frame.y.high)) {
        if (!y_ticks || value < frame.y.low || value > frame.y.high) continue;
        out += fmt::format(
            "<line class=\"grid\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>"
            "<text class=\"tick\" x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>\n",
            kLeft, kWidth - kRight, frame.py(value), kLeft - 6, frame.py(value) + 4, value);
    }
    out += fmt::format(
        "<text class=\"axis\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
        "<text class=\"axis\" transform=\"translate(14 {}) rotate(-90)\" "
        "text-anchor=\"middle\">{}</text>\n",
        (kLeft + kWidth - kRight) / 2, bottom + 32, escape(axes.x), (kTop + bottom) / 2,
        escape(axes.y));
    return out;
}

/// Colours go round; each time they do the lines are broken in another way.
std::string line_class(std::size_t series, const Series& s) {
    constexpr std::array<std::string_view, 3> kBroken{"", " dashed", " dotted"};
    const std::size_t round = series / kColours + (s.dashed ? 1 : 0);
    return fmt::format("line c{}{}", series % kColours, kBroken[round % kBroken.size()]);
}

std::string line(const Frame& frame, const Series& s, std::size_t series) {
    const std::size_t colour = series % kColours;
    std::string out;
    if (!s.low.empty() && s.low.size() == s.x.size() && s.high.size() == s.x.size()) {
        std::string points;
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (!std::isfinite(s.high[i])) continue;
            points += fmt::format("{:.1f},{:.1f} ", frame.px(s.x[i]), frame.py(s.high[i]));
        }
        for (std::size_t i = s.x.size(); i-- > 0;) {
            if (!std::isfinite(s.low[i])) continue;
            points += fmt::format("{:.1f},{:.1f} ", frame.px(s.x[i]), frame.py(s.low[i]));
        }
        out += fmt::format("<polygon class=\"band c{}\" points=\"{}\"/>\n", colour, points);
    }
    std::string path;
    bool drawing = false;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        const bool good = std::isfinite(s.y[i]);
        if (good) {
            path += fmt::format("{}{:.1f} {:.1f} ", drawing ? "L" : "M", frame.px(s.x[i]),
                                frame.py(s.y[i]));
            out += fmt::format("<circle class=\"c{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n",
                               colour, frame.px(s.x[i]), frame.py(s.y[i]),
                               s.x.size() > 40 ? 1.2 : 2.5);
        }
        drawing = good;
    }
    return out + fmt::format("<path class=\"{}\" d=\"{}\"/>\n", line_class(series, s), path);
}

/// Where the name of a series stands below the plot.
struct Entry {
    std::size_t series = 0;
    std::size_t row = 0;
    double x = 0.0;
};

/// In rows as wide as the plot, as many as it takes.
std::vector<Entry> legend_of(const std::vector<Series>& series) {
    constexpr double kLetter = 6.0;  // broader than most: the font is not known here
    std::vector<Entry> entries;
    std::size_t row = 0;
    double x = kLeft;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (series[i].label.empty()) continue;
        const double letters = static_cast<double>(series[i].label.size());
        const double width = kKeyWidth + kKeyGap + kLetter * letters;
        if (x > kLeft && x + width > kWidth - kRight) {
            ++row;
            x = kLeft;
        }
        entries.push_back({i, row, x});
        x += width + 17.0;
    }
    return entries;
}

std::string legend(const std::vector<Series>& series, const std::vector<Entry>& entries) {
    std::string out;
    for (const auto& [i, row, x] : entries) {
        const double y = kHeight - 8.0 + kLegendRow * static_cast<double>(row);
        out += fmt::format(
            "<line class=\"{0}\" x1=\"{1:.0f}\" x2=\"{2:.0f}\" y1=\"{3:.0f}\" y2=\"{3:.0f}\"/>"
            "<text class=\"tick\" x=\"{4:.0f}\" y=\"{5:.0f}\">{6}</text>\n",
            line_class(i, series[i]), x, x + kKeyWidth, y, x + kKeyWidth + kKeyGap, y + 4.0,
            escape(series[i].label));
    }
    return out;
}

std::string bars(const Frame& frame, const Sample& sample, std::size_t row, std::size_t rows) {
    std::vector<double> counts(kBins, 0.0);
    const double width = (frame.x.high - frame.x.low) / static_cast<double>(kBins);
    for (const double value : sample.values) {
        const auto bin = static_cast<std::size_t>((value - frame.x.low) / width);
        ++counts[std::min(bin, kBins - 1)];
    }
    const double most = std::max(1.0, *std::max_element(counts.begin(), counts.end()));
    const double room = (kHeight - kTop - kBottom) / static_cast<double>(rows);
    const double base = kTop + room * static_cast<double>(row + 1) - 4.0;
    std::string out;
    for (std::size_t i = 0; i < kBins; ++i) {
        const double height = counts[i] / most * (room - 26.0);
        const double left = frame.px(frame.x.low + width * static_cast<double>(i));
        out += fmt::format(
            "<rect class=\"bar c{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
            row % kColours, left, base - height, frame.px(frame.x.low + width) - kLeft - 1.0,
            height);
    }
    out += fmt::format(
        "<line class=\"mean\" x1=\"{0:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>"
        "<circle class=\"mean\" cx=\"{3:.1f}\" cy=\"{2:.1f}\" r=\"4\"/>\n"
        "<text class=\"axis\" x=\"{4}\" y=\"{5:.1f}\">{6}</text>\n",
        frame.px(sample.low), frame.px(sample.high), base, frame.px(sample.mean), kLeft + 4,
        base - room + 18.0, escape(sample.label));
    return out;
}

}  // namespace

std::string escape(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            default: out += c;
        }
    }
    return out;
}

std::vector<double> ticks(double low, double high) {
    const double rough = std::max(high - low, 1e-300) / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * power;
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= rough) {
            step = factor * power;
            break;
        }
    }
    std::vector<double> values;
    const double first = std::floor(low / step);
    for (int i = 0; i < 20; ++i) {
        // Multiples of the step, not sums: else 0.30000000000000004 shows.
        const double value = (first + i) * step;
        values.push_back(std::abs(value) < step * 1e-9 ? 0.0 : value);
        if (value >= high) break;
    }
    return values;
}

std::string line_plot(const Axes& axes, const std::vector<Series>& series) {
    Frame frame;
    for (const Series& s : series) {
        frame.x.include(s.x);
        frame.y.include(s.y);
        frame.y.include(s.low);
        frame.y.include(s.high);
    }
    frame.x.settle();
    frame.y.settle();
    const std::vector<Entry> entries = legend_of(series);
    const std::size_t more_rows = entries.empty() ? 0 : entries.back().row;
    std::string out =
        open(axes, kHeight + kLegendRow * static_cast<double>(more_rows)) + grid(frame, axes, true);
    for (std::size_t i = 0; i < series.size(); ++i) out += line(frame, series[i], i);
    return out + legend(series, entries) + "</svg>\n";
}

std::string stack_plot(const Axes& axes, const std::vector<double>& x,
                       const std::vector<std::vector<double>>& layers) {
    Frame frame;
    frame.x.include(x);
    frame.y.include(0.0);
    std::vector<double> floor(x.size(), 0.0);
    for (const auto& layer : layers) {
        for (std::size_t i = 0; i < x.size(); ++i) frame.y.include(floor[i] += layer[i]);
    }
    frame.x.settle();
    frame.y.settle();
    std::string out = open(axes) + grid(frame, axes, true);
    floor.assign(x.size(), 0.0);
    for (std::size_t k = 0; k < layers.size(); ++k) {
        std::string points;
        for (std::size_t i = 0; i < x.size(); ++i) {
            points += fmt::format("{:.1f},{:.1f} ", frame.px(x[i]),
                                  frame.py(floor[i] + layers[k][i]));
        }
        for (std::size_t i = x.size(); i-- > 0;) {
            points += fmt::format("{:.1f},{:.1f} ", frame.px(x[i]), frame.py(floor[i]));
            floor[i] += layers[k][i];
        }
        out += fmt::format("<polygon class=\"layer c{}\" points=\"{}\"/>\n", k % kColours, points);
    }
    return out + "</svg>\n";
}

std::string spread_plot(const Axes& axes, const std::vector<Sample>& samples) {
    Frame frame;
    for (const Sample& sample : samples) {
        frame.x.include(sample.values);
        frame.x.include(sample.low);
        frame.x.include(sample.high);
    }
    frame.x.settle();
    frame.y.settle();
    std::string out = open(axes) + grid(frame, axes, false);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        out += bars(frame, samples[i], i, samples.size());
    }
    return out + "</svg>\n";
}

// Hues that differ for colour-blind eyes too (Okabe and Ito), on light and dark grounds.
const std::string_view kPlotStyle = R"(
svg.plot { width: 100%; height: auto; }
svg.plot .title { font: 600 15px system-ui, sans-serif; fill: var(--ink); }
svg.plot .axis { font: 12px system-ui, sans-serif; fill: var(--ink); }
svg.plot .tick { font: 11px system-ui, sans-serif; fill: var(--dim); }
svg.plot .grid { stroke: var(--rule); stroke-width: 1; }
svg.plot .line { fill: none; stroke: var(--c); stroke-width: 2; }
svg.plot .dashed { stroke-dasharray: 5 4; }
svg.plot .dotted { stroke-dasharray: 2 3; }
svg.plot .band { fill: var(--c); opacity: 0.18; }
svg.plot .layer { fill: var(--c); opacity: 0.75; stroke: var(--ground); stroke-width: 0.5; }
svg.plot .bar { fill: var(--c); opacity: 0.55; }
svg.plot circle { fill: var(--c); }
svg.plot .mean { stroke: var(--ink); fill: var(--ink); stroke-width: 2; }
.c0 { --c: #0072b2; } .c1 { --c: #d55e00; } .c2 { --c: #009e73; } .c3 { --c: #cc79a7; }
.c4 { --c: #e69f00; } .c5 { --c: #56b4e9; } .c6 { --c: #8c6d31; } .c7 { --c: #7f7f7f; }
)";

}  // namespace k3d::optimizer::report

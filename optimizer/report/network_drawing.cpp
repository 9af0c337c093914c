// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/network_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "optimizer/report/svg_plot.h"

namespace k3d::optimizer::report {
namespace {

constexpr double kColumn = 170.0;  // pixels between columns
constexpr double kRow = 60.0;
constexpr double kMargin = 70.0;
constexpr double kRadius = 14.0;

struct Point {
    double x = 0.0;
    double y = 0.0;
};

/// Column of every name: 0 for inputs, the longest way from them for hidden nodes, the last for outputs.
std::map<std::string, int> columns_of(const network::Definition& d) {
    std::map<std::string, int> column;
    for (const network::Input& input : d.inputs) column[input.name] = 0;
    for (const network::Node& node : d.nodes) column[node.name] = 1;
    // No way is longer than the number of nodes.
    for (std::size_t round = 0; round < d.nodes.size(); ++round) {
        bool moved = false;
        for (const network::Link& link : d.links) {
            if (link.recurrent || column[link.to] > column[link.from]) continue;
            column[link.to] = column[link.from] + 1;
            moved = true;
        }
        if (!moved) break;
    }
    int last = 1;
    for (const auto& [name, c] : column) last = std::max(last, c);
    const std::set<std::string> outputs(d.outputs.begin(), d.outputs.end());
    for (const network::Node& node : d.nodes) {
        if (!outputs.contains(node.name)) last = std::max(last, column[node.name] + 1);
    }
    for (const std::string& output : d.outputs) column[output] = last;
    return column;
}

std::map<std::string, Point> places_of(const network::Definition& d) {
    std::map<int, std::vector<std::string>> members;
    const std::map<std::string, int> column = columns_of(d);
    for (const network::Input& input : d.inputs) members[0].push_back(input.name);
    for (const network::Node& node : d.nodes) members[column.at(node.name)].push_back(node.name);
    std::size_t tallest = 1;
    for (const auto& [c, names] : members) tallest = std::max(tallest, names.size());
    std::map<std::string, Point> places;
    for (const auto& [c, names] : members) {
        const double gap = kRow * static_cast<double>(tallest) / static_cast<double>(names.size());
        for (std::size_t i = 0; i < names.size(); ++i) {
            // Odd columns stand a little lower, so that links pass beside nodes, not through them.
            const double shift = c % 2 == 1 ? 0.18 * kRow : 0.0;
            places[names[i]] = {kMargin + kColumn * c,
                                kMargin + gap * (static_cast<double>(i) + 0.5) + shift};
        }
    }
    return places;
}

std::string svg_link(const network::Link& link, Point from, Point to) {
    const double width = std::clamp(0.8 + 1.2 * std::log1p(std::abs(link.weight)), 0.8, 5.0);
    const char* colour = link.weight >= 0.0 ? "#2166ac" : "#c2560b";
    // Recurrent links and those within a column bow, so that both ends can be told.
    const double bow = link.recurrent || from.x >= to.x ? 55.0 : 0.0;
    return fmt::format(
        "<path d=\"M{:.1f} {:.1f} Q{:.1f} {:.1f} {:.1f} {:.1f}\" fill=\"none\" stroke=\"{}\" "
        "stroke-width=\"{:.2f}\"{}><title>{} -> {}: {:.6g}</title></path>\n",
        from.x, from.y, 0.5 * (from.x + to.x), 0.5 * (from.y + to.y) - bow, to.x, to.y, colour, width,
        link.recurrent ? " stroke-dasharray=\"5 3\"" : "", escape(link.from), escape(link.to),
        link.weight);
}

std::string svg_node(const std::string& name, const std::string& note, Point at, const char* fill) {
    return fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" stroke=\"#333\"/>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"9\">{}</text>\n",
        at.x, at.y, kRadius, fill, at.x, at.y - kRadius - 4.0, escape(name), at.x,
        at.y + kRadius + 11.0, escape(note));
}

}  // namespace

std::string svg_network(const network::Definition& d) {
    const std::map<std::string, Point> places = places_of(d);
    double width = 0.0;
    double height = 0.0;
    for (const auto& [name, at] : places) {
        width = std::max(width, at.x + kMargin);
        height = std::max(height, at.y + kMargin);
    }
    std::string out = fmt::format("<svg id=\"network\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
                                  "style=\"max-width: 100%\" font-size=\"12\" fill=\"currentColor\">\n",
                                  width, height);
    for (const network::Link& link : d.links) {
        out += svg_link(link, places.at(link.from), places.at(link.to));
    }
    const std::set<std::string> outputs(d.outputs.begin(), d.outputs.end());
    for (const network::Input& input : d.inputs) {
        out += svg_node(input.name, "", places.at(input.name), "#9aa5ad");
    }
    for (const network::Node& node : d.nodes) {
        out += svg_node(node.name, fmt::format("{} {:.3g}", network::name_of(node.activation), node.bias),
                        places.at(node.name), outputs.contains(node.name) ? "#e8a33d" : "#8fbf8f");
    }
    return out + "</svg>\n";
}

}  // namespace k3d::optimizer::report

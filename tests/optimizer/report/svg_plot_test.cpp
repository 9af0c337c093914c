// SPDX-License-Identifier: BSD-3-Clause
// What tells the lines of a plot apart, and that all of their names can be read.
#include "optimizer/report/svg_plot.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace k3d::optimizer::report {
namespace {

using testing::HasSubstr;

std::string plot_of(int count, const std::string& name) {
    std::vector<Series> series;
    for (int i = 0; i < count; ++i) {
        series.push_back(
            {fmt::format("{}, run {}", name, i + 1), {0.0, 1.0}, {1.0, 2.0 + i}, {}, {}});
    }
    return line_plot({"Fitness", "generation", "attempts"}, series);
}

double height_of(const std::string& svg) {
    std::smatch found;
    std::regex_search(svg, found, std::regex("viewBox=\"0 0 640 ([0-9.]+)\""));
    return std::stod(found[1]);
}

/// Where a name stands: x, y, and how far 5.7 units a letter, as DejaVu Sans has them, take it.
struct Place {
    double x, y, end;
};

std::vector<Place> names_in(const std::string& svg, const std::string& name) {
    const std::regex text("<text class=\"tick\" x=\"([0-9.]+)\" y=\"([0-9.]+)\">(" + name +
                          "[^<]*)<");
    std::vector<Place> places;
    for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
        const double x = std::stod((*it)[1]);
        places.push_back(
            {x, std::stod((*it)[2]), x + 5.7 * static_cast<double>((*it)[3].length())});
    }
    return places;
}

/// Of the lines drawn: what tells one from another, its class.
std::vector<std::string> looks_of(const std::string& svg, const std::string& element) {
    const std::regex line("<" + element + " class=\"(line [^\"]*)\"");
    std::vector<std::string> looks;
    for (std::sregex_iterator it(svg.begin(), svg.end(), line), end; it != end; ++it) {
        looks.push_back((*it)[1]);
    }
    return looks;
}

TEST(LinePlot, NamesOfTenSeriesStandInThePicture) {
    const std::string name = "Learned: NEAT with noise handling";
    const std::string svg = plot_of(10, name);
    const std::vector<Place> places = names_in(svg, name);
    ASSERT_EQ(places.size(), 10u);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_LT(places[i].end, 640.0) << i;
        EXPECT_LT(places[i].y, height_of(svg)) << i;
        if (i == 0) continue;
        const bool right_of_it = places[i].y == places[i - 1].y && places[i].x > places[i - 1].end;
        const bool below_it = places[i].y >= places[i - 1].y + 14.0;
        EXPECT_TRUE(right_of_it || below_it) << "names " << i - 1 << " and " << i << " overlap";
    }
}

TEST(LinePlot, OneRowOfNamesNeedsNoMoreRoom) {
    EXPECT_EQ(height_of(plot_of(2, "short")), height_of(plot_of(1, "short")));
    EXPECT_EQ(height_of(line_plot({"none", "x", "y"}, {})), height_of(plot_of(1, "short")));
}

TEST(LinePlot, ALongNameHasARowOfItsOwn) {
    const std::string name = "Learned: linear by CMA-ES, against takers of both kinds, and more";
    const std::vector<Place> places = names_in(plot_of(2, name), name);
    ASSERT_EQ(places.size(), 2u);
    EXPECT_EQ(places[0].x, places[1].x);
    EXPECT_LT(places[0].end, 640.0);
}

TEST(LinePlot, NoTwoSeriesLookAlike) {
    const std::string svg = plot_of(24, "s");
    const std::vector<std::string> drawn = looks_of(svg, "path");
    ASSERT_EQ(drawn.size(), 24u);
    EXPECT_EQ(std::set<std::string>(drawn.begin(), drawn.end()).size(), 24u);
    EXPECT_EQ(looks_of(svg, "line"), drawn) << "beside its name a series looks as in the plot";
    for (const char* broken : {".dashed { stroke-dasharray:", ".dotted { stroke-dasharray:"}) {
        EXPECT_THAT(std::string(kPlotStyle), HasSubstr(broken));
    }
}

TEST(LinePlot, ASeriesMayBeDashedFromTheStart) {
    const std::string svg = line_plot(
        {"t", "x", "y"}, {{"a", {0, 1}, {1, 2}, {}, {}}, {"b", {0, 1}, {1, 2}, {}, {}, true}});
    EXPECT_THAT(looks_of(svg, "path"), testing::ElementsAre("line c0", "line c1 dashed"));
}

}  // namespace
}  // namespace k3d::optimizer::report

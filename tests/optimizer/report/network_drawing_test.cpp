// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/report/network_drawing: every node and link is drawn, names are escaped.
#include "optimizer/report/network_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace k3d::optimizer::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

network::Definition odd_names() {
    network::Definition d;
    d.inputs = {{"a \"b\""}, {"c<d>&"}};
    d.outputs = {"out"};
    d.nodes = {{"out", network::Activation::Linear, 0.25}, {"h", network::Activation::Tanh, 0.0},
               {"g", network::Activation::Gauss, 0.0}};
    d.links = {{"a \"b\"", "h", 2.0, false}, {"h", "g", 1.0, false}, {"g", "out", -0.5, false},
               {"c<d>&", "out", 1.0, false}, {"out", "h", 0.125, true}, {"h", "h", 1.0, true}};
    return d;
}

std::ptrdiff_t count(const std::string& text, const std::string& what) {
    const std::regex expression(what);
    return std::distance(std::sregex_iterator(text.begin(), text.end(), expression), {});
}

TEST(NetworkDrawing, DrawsEveryNodeAndLink) {
    const std::string svg = svg_network(odd_names());
    EXPECT_EQ(count(svg, "<circle "), 5);
    EXPECT_EQ(count(svg, "<path "), 6);
    EXPECT_EQ(count(svg, "stroke-dasharray"), 2);
    EXPECT_THAT(svg, HasSubstr("c&lt;d&gt;&amp;"));
    EXPECT_THAT(svg, Not(HasSubstr("c<d>")));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(NetworkDrawing, ColumnsFollowTheDistanceFromTheInputs) {
    const std::string svg = svg_network(odd_names());
    const std::regex circle("<circle cx=\"([0-9.]+)\"");
    std::vector<double> x;
    for (std::sregex_iterator at(svg.begin(), svg.end(), circle), end; at != end; ++at) {
        x.push_back(std::stod((*at)[1]));
    }
    ASSERT_EQ(x.size(), 5u);  // both inputs, then out, h, g
    EXPECT_EQ(x[0], x[1]);
    EXPECT_LT(x[1], x[3]);
    EXPECT_LT(x[3], x[4]);
    EXPECT_LT(x[4], x[2]);
}

}  // namespace
}  // namespace k3d::optimizer::report

// SPDX-License-Identifier: BSD-3-Clause
// Tests of optimizer/algorithm/weights: a network's weights as parameters and back.
#include "optimizer/algorithm/weights.h"

#include <gtest/gtest.h>

namespace k3d::optimizer::algorithm {
namespace {

TEST(Weights, GoOutAndComeBack) {
    network::Definition d;
    d.inputs = {{"a"}};
    d.outputs = {"out"};
    d.nodes = {{"out", network::Activation::Linear, 0.25}, {"h", network::Activation::Tanh, -1.0}};
    d.links = {{"a", "h", 3.0, false}, {"h", "out", 0.5, false}, {"out", "h", 0.125, true}};
    const auto parameters = weights_of(d, 2.0);
    ASSERT_EQ(parameters.size(), 5u);
    EXPECT_EQ(parameters[0].name, "link a -> h");
    EXPECT_EQ(parameters[2].name, "recurrent link out -> h");
    EXPECT_EQ(parameters[4].name, "bias h");
    EXPECT_EQ(parameters[4].start, -1.0);
    EXPECT_EQ(parameters[4].deviation, 2.0);
    std::vector<double> starts;
    for (const spec::Parameter& p : parameters) starts.push_back(p.start);
    EXPECT_EQ(with_weights(d, starts), d);
    const auto changed = with_weights(d, {1.0, 2.0, 3.0, 4.0, 5.0});
    EXPECT_EQ(changed.links[1].weight, 2.0);
    EXPECT_EQ(changed.nodes[1].bias, 5.0);
}

}  // namespace
}  // namespace k3d::optimizer::algorithm

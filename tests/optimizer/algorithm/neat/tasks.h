// SPDX-License-Identifier: BSD-3-Clause
// The benchmarks of the NEAT paper: XOR, and runs of NEAT on a task.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "optimizer/algorithm/algorithm.h"

namespace k3d::optimizer::algorithm::testing {

/// Inputs and sigmoid outputs without links: NEAT starts with all of them, and a bias.
inline network::Definition empty_network(int inputs, int outputs) {
    network::Definition d;
    for (int i = 0; i < inputs; ++i) d.inputs.push_back({"i" + std::to_string(i)});
    for (int i = 0; i < outputs; ++i) {
        d.outputs.push_back("o" + std::to_string(i));
        d.nodes.push_back({d.outputs.back(), network::Activation::Sigmoid, 0.0});
    }
    return d;
}

struct Xor {
    double fitness;  ///< (4 - sum of errors)^2, as in the paper
    bool solved;     ///< all four answers are on the right side of a half
};

inline Xor play_xor(const network::Definition& definition) {
    const network::Network net(definition, "genome");
    double errors = 0.0;
    bool solved = true;
    for (const double a : {0.0, 1.0}) {
        for (const double b : {0.0, 1.0}) {
            network::State state = net.start();
            const std::vector<double> inputs{a, b};
            const double error = std::abs(net.evaluate(inputs, state)[0] - (a != b ? 1.0 : 0.0));
            errors += error;
            solved = solved && error < 0.5;
        }
    }
    return {(4.0 - errors) * (4.0 - errors), solved};
}

}  // namespace k3d::optimizer::algorithm::testing

// SPDX-License-Identifier: BSD-3-Clause
// The weights and biases of a network as parameters: the search over a fixed network, which a search
// that also grows it has to beat.
#pragma once

#include <vector>

#include "common/network/network.h"
#include "optimizer/spec/algorithm_spec.h"

namespace k3d::optimizer::algorithm {

/// "link FROM -> TO" for each link, then "bias NODE" for each node; starts are the present values.
std::vector<spec::Parameter> weights_of(const network::Definition& definition, double deviation);

/// The network with these values, in the order of weights_of().
network::Definition with_weights(network::Definition definition, const std::vector<double>& values);

}  // namespace k3d::optimizer::algorithm

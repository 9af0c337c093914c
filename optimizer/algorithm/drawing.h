// SPDX-License-Identifier: BSD-3-Clause
// Networks as pictures: Graphviz text, and SVG that needs no program to lay it out.
#pragma once

#include <string>

#include "common/network/network.h"

namespace k3d::optimizer::algorithm {

/// A digraph: inputs left, outputs right, weights on the links, recurrent ones dashed.
std::string to_dot(const network::Definition& definition);

/// A stand-alone SVG document. Columns: inputs, hidden nodes by their distance from the inputs,
/// outputs. Blue links have positive weights, red ones negative; broader is stronger.
std::string to_svg(const network::Definition& definition);

}  // namespace k3d::optimizer::algorithm

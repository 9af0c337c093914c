// SPDX-License-Identifier: BSD-3-Clause
// A network as a picture for the report of a run.
#pragma once

#include <string>

#include "common/network/network.h"

namespace k3d::optimizer::report {

/// An SVG element. Columns: inputs, hidden nodes by their distance from the inputs, outputs. Blue links
/// have positive weights, orange ones negative; broader is stronger, and each says its weight when
/// pointed at. Recurrent links are dashed. Text has the colour of the page's.
std::string svg_network(const network::Definition& definition);

}  // namespace k3d::optimizer::report

// SPDX-License-Identifier: BSD-3-Clause
// What algorithms throw for settings, results and saved states that cannot be.
#pragma once

#include <stdexcept>

namespace k3d::optimizer::algorithm {

/// The text holds the offending value and its place.
class AlgorithmError : public std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

}  // namespace k3d::optimizer::algorithm

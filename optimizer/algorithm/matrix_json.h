// SPDX-License-Identifier: BSD-3-Clause
// Eigen matrices in saved states: a list of numbers, column by column.
#pragma once

#include <Eigen/Core>

#include "optimizer/algorithm/state_json.h"

namespace k3d::optimizer::algorithm {

inline nlohmann::json exact_matrix(const Eigen::MatrixXd& matrix) {
    return exact(std::vector<double>(matrix.data(), matrix.data() + matrix.size()));
}

/// Throws AlgorithmError unless there are rows * columns finite numbers.
inline Eigen::MatrixXd read_matrix(const Reader& reader, int rows, int columns) {
    const auto size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    const std::vector<double> values = reader.finite_list(size);
    return Eigen::Map<const Eigen::MatrixXd>(values.data(), rows, columns);
}

}  // namespace k3d::optimizer::algorithm

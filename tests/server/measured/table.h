// SPDX-License-Identifier: BSD-3-Clause
// Reads the small tables beside this file: figures measured on the reference server in lock-step.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace k3d::testing {

using Row = std::vector<std::string>;

/// The rows of tests/server/measured/`name`, without comments and the line of headings.
inline std::vector<Row> measured(const std::string& name) {
    std::ifstream file(std::string(K3D_SOURCE_DIR) + "/tests/server/measured/" + name);
    std::vector<Row> rows;
    bool headings_read = false;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        if (!std::exchange(headings_read, true)) continue;
        Row& row = rows.emplace_back();
        std::stringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    }
    EXPECT_FALSE(rows.empty()) << name;
    return rows;
}

}  // namespace k3d::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/write_file.h"

#include <fstream>
#include <stdexcept>

namespace k3d::optimizer::report {

void write_file(const std::string& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text << std::flush;
    if (!file) throw std::runtime_error("cannot write " + path);
}

}  // namespace k3d::optimizer::report

// SPDX-License-Identifier: BSD-3-Clause
// The end of a run whose every episode would fail in the same way.
#pragma once

#include <stdexcept>
#include <string>

namespace k3d::optimizer {

/// No episode of this run can be played; the text is one line.
class HopelessRun : public std::runtime_error {
  public:
    HopelessRun(const std::string& what, int code) : std::runtime_error(what), exit_code(code) {}
    int exit_code;
};

}  // namespace k3d::optimizer

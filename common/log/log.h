// SPDX-License-Identifier: BSD-3-Clause
// spdlog set-up shared by the programs: one line per event on standard error, program name first.
#pragma once

#include <spdlog/spdlog.h>

#include <string>
#include <string_view>

namespace k3d::log {

/// `level`: trace, debug, info, warning, error, off. Throws std::invalid_argument naming another.
void start(std::string_view program, std::string_view level);

}  // namespace k3d::log

/// A broken assumption of ours: says where, and aborts. Never used for input.
#define K3D_ASSERT(condition)                                                          \
    do {                                                                               \
        if (!(condition)) ::k3d::log::assertion_failed(#condition, __FILE__, __LINE__); \
    } while (false)

namespace k3d::log {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}

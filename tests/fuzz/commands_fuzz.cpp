// SPDX-License-Identifier: BSD-3-Clause
// Bytes as an agent may send them: numbers that are understood are finite, and what is understood,
// written and read again, is written the same.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "common/wire/commands.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace k3d;
    wire::Commands commands;
    wire::decode(std::string_view(reinterpret_cast<const char*>(data), size), commands);
    for (const auto& rate : commands.joint_rates) {
        if (rate && !std::isfinite(*rate)) std::abort();
    }
    if (const auto& beam = commands.beam) {
        if (!std::isfinite(beam->x + 0.0 * beam->y + 0.0 * beam->angle_deg)) std::abort();
    }
    std::string first, second;
    wire::encode(commands, first);
    wire::Commands again;
    if (wire::decode(first, again) != 0) std::abort();
    wire::encode(again, second);
    if (first != second) std::abort();
    return 0;
}

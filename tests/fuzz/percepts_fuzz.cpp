// SPDX-License-Identifier: BSD-3-Clause
// Bytes as a server may send them to an agent.
#include <cstdint>
#include <string_view>

#include "common/wire/percepts.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static k3d::wire::Percepts percepts;  // reused, as an agent reuses it
    k3d::wire::decode(std::string_view(reinterpret_cast<const char*>(data), size), percepts);
    return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a network file: refused with a message, or a network that is written and read alike and
// evaluates to numbers.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "common/network/network.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace k3d::network;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const Definition read = parse(text, "fuzz.json");
        if (!(parse(to_json(read), "printed.json") == read)) std::abort();
        const Network network(read, "fuzz.json");
        State state = network.start();
        const std::vector<double> inputs(read.inputs.size(), 0.7);
        for (int round = 0; round < 3; ++round) {
            for (const double value : network.evaluate(inputs, state)) {
                if (!std::isfinite(value)) std::abort();
            }
        }
    } catch (const NetworkError& error) {
        if (std::string(error.what()).empty()) std::abort();
    }
    return 0;
}

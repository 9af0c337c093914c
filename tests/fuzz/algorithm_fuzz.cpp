// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a saved state of an algorithm: refused with a message, or a state that saves the same
// again and can be played on.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "optimizer/algorithm/algorithm.h"

namespace {

using namespace k3d::optimizer::algorithm;

void play(Algorithm& algorithm) {
    for (int round = 0; round < 3 && !algorithm.finished(); ++round) {
        for (const Request& request : algorithm.ask()) {
            const double fitness = static_cast<double>(request.candidate % 7);
            algorithm.tell(request.candidate, request.pool, {fitness, 0.1, request.episodes});
        }
        algorithm.advance();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        Algorithm algorithm = Algorithm::restore_text(text, "fuzz.json");
        const std::string saved = algorithm.save().dump();
        if (Algorithm::restore_text(saved, "saved.json").save().dump() != saved) std::abort();
        play(algorithm);
    } catch (const AlgorithmError& error) {
        if (std::string(error.what()).empty()) std::abort();
    }
    return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Bytes as a trainer may send them: places and speeds that are understood are of a match, and what
// is understood, written and read again, is written the same.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "common/wire/trainer.h"

namespace {

using namespace k3d;

void check(const std::optional<Vec3>& v) {
    if (v && !(v->cwiseAbs().maxCoeff() <= 1000.0)) std::abort();
}

std::string text_of(const std::vector<wire::TrainerCommand>& commands) {
    std::string text;
    for (const wire::TrainerCommand& command : commands) wire::encode(command, text);
    return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<wire::TrainerCommand> commands;
    wire::decode(std::string_view(reinterpret_cast<const char*>(data), size), commands);
    for (const wire::TrainerCommand& command : commands) {
        if (const auto* ball = std::get_if<wire::BallCommand>(&command)) {
            check(ball->position);
            check(ball->velocity);
        } else if (const auto* agent = std::get_if<wire::AgentCommand>(&command)) {
            check(agent->position);
        }
    }
    const std::string first = text_of(commands);
    std::vector<wire::TrainerCommand> again;
    if (wire::decode(first, again) != 0) std::abort();
    if (text_of(again) != first) std::abort();
    return 0;
}

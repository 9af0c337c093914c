// SPDX-License-Identifier: BSD-3-Clause
// Bytes as a peer of the server may send them: frames in pieces, agent and trainer commands.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "common/wire/commands.h"
#include "common/wire/frame.h"
#include "common/wire/trainer.h"

namespace {

using namespace k3d;

/// What we understood, written and read again, must be written the same.
void check_round_trip(const wire::Commands& commands) {
    std::string first, second;
    wire::encode(commands, first);
    wire::Commands again;
    wire::decode(first, again);
    wire::encode(again, second);
    if (first != second) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::size_t piece =
        1 + data[0];  // the first byte says into what pieces TCP cuts the rest
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);

    wire::FrameReader reader;
    wire::Commands commands;
    std::vector<wire::TrainerCommand> trainer;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
        reader.append(bytes.substr(at, piece));
        std::string_view payload;
        while (reader.next(payload) == wire::FrameReader::Status::Frame) {
            wire::decode(payload, commands);
            wire::decode(payload, trainer);
        }
    }
    // Few inputs are whole frames: the same bytes also as one payload.
    wire::decode(bytes, commands);
    wire::decode(bytes, trainer);
    check_round_trip(commands);
    std::string text;
    for (const wire::TrainerCommand& command : trainer) wire::encode(command, text);
    return 0;
}

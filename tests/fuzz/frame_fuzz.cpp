// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a stream of frames, in any pieces: every payload is what its prefix says, and
// however the stream is cut, the same payloads come out.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "common/wire/frame.h"

namespace {

using namespace k3d;

struct Cut {
    std::vector<std::string> payloads;
    bool too_long = false;
};

Cut cut(std::string_view bytes, std::size_t piece) {
    wire::FrameReader reader(4096);
    Cut result;
    for (std::size_t at = 0; at < bytes.size() && !result.too_long; at += piece) {
        std::string_view rest = bytes.substr(at, piece);
        while (!rest.empty()) {
            const auto room = reader.space();
            const std::size_t count = std::min(room.size(), rest.size());
            std::memcpy(room.data(), rest.data(), count);
            reader.received(count);
            rest.remove_prefix(count);
        }
        for (std::string_view payload;;) {
            const bool promised = reader.holds_frame();
            const auto status = reader.next(payload);
            if (promised != (status == wire::FrameReader::Status::Frame)) std::abort();
            result.too_long = status == wire::FrameReader::Status::TooLong;
            if (status != wire::FrameReader::Status::Frame) break;
            result.payloads.emplace_back(payload);
        }
    }
    return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    // The first byte says into what pieces TCP cuts the rest.
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const Cut pieces = cut(bytes, 1 + data[0]);
    const Cut whole = cut(bytes, std::max<std::size_t>(bytes.size(), 1));
    if (pieces.payloads != whole.payloads || pieces.too_long != whole.too_long) std::abort();
    std::string again;
    for (const std::string& payload : whole.payloads) wire::append_frame(payload, again);
    if (bytes.substr(0, again.size()) != again) std::abort();
    return 0;
}

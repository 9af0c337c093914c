// SPDX-License-Identifier: BSD-3-Clause
// Framing: a 4-byte big-endian payload length, then the payload (SimSpark reference 1.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace k3d::wire {

inline constexpr std::size_t kPrefixBytes = 4;
/// Longest payload accepted from a peer; a longer announced length closes the connection.
inline constexpr std::size_t kMaxPayloadIn = 64 * 1024;
/// Longest payload our clients accept from a server: full scenes of 22 robots take about 200 KiB.
inline constexpr std::size_t kMaxPayloadFromServer = 4 * 1024 * 1024;
/// Longest payload an agent may be sent: foreign agents have 8 KiB buffers (reference 1.3).
inline constexpr std::size_t kMaxPayloadToAgent = 8191;

/// Appends prefix and payload.
void append_frame(std::string_view payload, std::string& out);

/// Cuts frames out of a byte stream without copying payloads that arrived whole.
class FrameReader {
  public:
    enum class Status { Frame, NeedMore, TooLong };

    explicit FrameReader(std::size_t max_payload = kMaxPayloadIn) : max_payload_(max_payload) {}

    /// Bytes from the peer, in any pieces.
    void append(std::string_view bytes);

    /// The next whole payload, valid until the next call of append() or next().
    /// TooLong is final: the peer announced announced_length() bytes.
    Status next(std::string_view& payload);

    std::uint32_t announced_length() const { return announced_; }
    std::size_t max_payload() const { return max_payload_; }
    std::size_t buffered() const { return buffer_.size() - begin_; }

  private:
    std::size_t max_payload_;
    std::string buffer_;
    std::size_t begin_ = 0;
    std::uint32_t announced_ = 0;
};

}  // namespace k3d::wire

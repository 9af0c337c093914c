// SPDX-License-Identifier: BSD-3-Clause
// Framing: a 4-byte big-endian payload length, then the payload (SimSpark reference 1.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

    /// Where the peer's next bytes may be read to, `kReadBytes` or more: the memory is kept from
    /// frame to frame, and grows with what has arrived, never with what was announced.
    std::span<char> space();
    /// How many bytes were read into space(). Ends the life of payload views.
    void received(std::size_t count);
    /// Bytes from the peer, in any pieces, for who has them elsewhere.
    void append(std::string_view bytes);

    /// The next whole payload, valid until the next call of space(), append() or next().
    /// TooLong is final: the peer announced announced_length() bytes.
    Status next(std::string_view& payload);

    /// Whether next() would return one.
    bool holds_frame() const;

    std::uint32_t announced_length() const { return announced_; }
    std::size_t max_payload() const { return max_payload_; }
    std::size_t buffered() const { return end_ - begin_; }

    static constexpr std::size_t kReadBytes = 16 * 1024;

  private:
    std::string_view rest() const { return {buffer_.data() + begin_, end_ - begin_}; }

    std::size_t max_payload_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;  // of what no next() has returned yet
    std::size_t end_ = 0;    // of what has arrived
    std::uint32_t announced_ = 0;
};

}  // namespace k3d::wire

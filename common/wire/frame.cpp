// SPDX-License-Identifier: BSD-3-Clause
#include "common/wire/frame.h"

#include <algorithm>
#include <cstring>

namespace k3d::wire {

namespace {

std::uint32_t byte_at(std::string_view bytes, std::size_t position) {
    return static_cast<unsigned char>(bytes[position]);
}

std::uint32_t length_at_front(std::string_view bytes) {
    return byte_at(bytes, 0) << 24 | byte_at(bytes, 1) << 16 | byte_at(bytes, 2) << 8 |
           byte_at(bytes, 3);
}

}  // namespace

void append_frame(std::string_view payload, std::string& out) {
    const auto length = static_cast<std::uint32_t>(payload.size());
    const char prefix[kPrefixBytes] = {static_cast<char>(length >> 24),
                                       static_cast<char>(length >> 16),
                                       static_cast<char>(length >> 8), static_cast<char>(length)};
    out.append(prefix, kPrefixBytes);
    out.append(payload);
}

std::span<char> FrameReader::space() {
    if (begin_ == end_ || announced_ > max_payload_) {
        begin_ = end_ = 0;  // of a broken stream nothing is kept
    } else if (begin_ >= buffer_.size() / 2) {
        std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
        end_ -= begin_;
        begin_ = 0;
    }
    if (buffer_.size() - end_ < kReadBytes) buffer_.resize(std::max(end_ + kReadBytes, 2 * end_));
    return std::span(buffer_).subspan(end_);
}

void FrameReader::received(std::size_t count) {
    if (announced_ <= max_payload_) end_ += count;
}

void FrameReader::append(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::span<char> room = space();
        const std::size_t count = std::min(room.size(), bytes.size());
        std::memcpy(room.data(), bytes.data(), count);
        received(count);
        bytes.remove_prefix(count);
    }
}

bool FrameReader::holds_frame() const {
    return buffered() >= kPrefixBytes && length_at_front(rest()) <= max_payload_ &&
           buffered() >= kPrefixBytes + length_at_front(rest());
}

FrameReader::Status FrameReader::next(std::string_view& payload) {
    if (announced_ > max_payload_) return Status::TooLong;
    if (buffered() < kPrefixBytes) return Status::NeedMore;
    announced_ = length_at_front(rest());
    if (announced_ > max_payload_) return Status::TooLong;
    if (buffered() < kPrefixBytes + announced_) return Status::NeedMore;
    payload = rest().substr(kPrefixBytes, announced_);
    begin_ += kPrefixBytes + announced_;
    return Status::Frame;
}

}  // namespace k3d::wire

// SPDX-License-Identifier: BSD-3-Clause
#include "common/wire/frame.h"

namespace k3d::wire {

namespace {

std::uint32_t byte_at(std::string_view bytes, std::size_t position) {
    return static_cast<unsigned char>(bytes[position]);
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

void FrameReader::append(std::string_view bytes) {
    if (announced_ > max_payload_) return;  // nothing behind a broken prefix has a meaning
    if (begin_ == buffer_.size()) {
        buffer_.clear();
        begin_ = 0;
    } else if (begin_ >= buffer_.size() / 2) {
        buffer_.erase(0, begin_);
        begin_ = 0;
    }
    buffer_.append(bytes);
}

FrameReader::Status FrameReader::next(std::string_view& payload) {
    const std::string_view rest = std::string_view(buffer_).substr(begin_);
    if (rest.size() < kPrefixBytes) return Status::NeedMore;
    announced_ =
        byte_at(rest, 0) << 24 | byte_at(rest, 1) << 16 | byte_at(rest, 2) << 8 | byte_at(rest, 3);
    if (announced_ > max_payload_) return Status::TooLong;
    if (rest.size() < kPrefixBytes + announced_) return Status::NeedMore;
    payload = rest.substr(kPrefixBytes, announced_);
    begin_ += kPrefixBytes + announced_;
    return Status::Frame;
}

}  // namespace k3d::wire

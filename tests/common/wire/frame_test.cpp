// SPDX-License-Identifier: BSD-3-Clause
// Framing: any pieces in, the same payloads out, and a stop at a length beyond the limit.
#include "common/wire/frame.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace k3d::wire {
namespace {

TEST(Frame, PrefixIsBigEndian) {
    std::string bytes;
    append_frame(std::string(0x0102, 'x'), bytes);
    EXPECT_EQ(bytes.substr(0, 4), std::string("\0\0\1\2", 4));
    EXPECT_EQ(bytes.size(), 4U + 0x0102U);
}

TEST(FrameReader, WaitsForTheWholeFrame) {
    std::string bytes;
    append_frame("(syn)", bytes);
    FrameReader reader;
    std::string_view payload;
    for (const char c : bytes) {
        EXPECT_EQ(reader.next(payload), FrameReader::Status::NeedMore);
        reader.append({&c, 1});
    }
    EXPECT_EQ(reader.next(payload), FrameReader::Status::Frame);
    EXPECT_EQ(payload, "(syn)");
    EXPECT_EQ(reader.next(payload), FrameReader::Status::NeedMore);
    EXPECT_EQ(reader.buffered(), 0U);
}

TEST(FrameReader, EmptyFrameIsAFrame) {
    FrameReader reader;
    reader.append(std::string_view("\0\0\0\0", 4));
    std::string_view payload = "x";
    EXPECT_EQ(reader.next(payload), FrameReader::Status::Frame);
    EXPECT_EQ(payload, "");
}

TEST(FrameReader, LengthBeyondTheLimitIsFinal) {
    FrameReader reader;
    std::string_view payload;
    reader.append(std::string_view("\0\1\0\0", 4));
    EXPECT_EQ(reader.next(payload), FrameReader::Status::NeedMore) << "64 KiB are allowed";

    FrameReader refused;
    refused.append("\xFF\xFF\xFF\xFF");
    EXPECT_EQ(refused.next(payload), FrameReader::Status::TooLong);
    EXPECT_EQ(refused.announced_length(), 4294967295U);
    for (int i = 0; i < 100; ++i) refused.append(std::string(1000, 'x'));
    EXPECT_EQ(refused.next(payload), FrameReader::Status::TooLong);
    EXPECT_LT(refused.buffered(), 100U) << "nothing more is kept of a broken stream";
}

TEST(FrameReader, KeepsItsMemoryAndTakesNoneForAnnouncements) {
    FrameReader reader;
    std::string bytes;
    append_frame(std::string(1000, 'x'), bytes);
    const auto take = [&](std::string_view part) {
        const std::span<char> room = reader.space();
        EXPECT_GE(room.size(), FrameReader::kReadBytes);
        EXPECT_LE(room.size(), 2 * FrameReader::kReadBytes);
        std::copy(part.begin(), part.end(), room.begin());
        reader.received(part.size());
        return room.data();
    };
    const char* const memory = take(bytes);
    std::string_view payload;
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(reader.next(payload), FrameReader::Status::Frame);
        EXPECT_FALSE(reader.holds_frame());
        EXPECT_EQ(take(bytes), memory);
        EXPECT_TRUE(reader.holds_frame());
    }
    ASSERT_EQ(reader.next(payload), FrameReader::Status::Frame);
    take(std::string_view("\0\1\0\0", 4));  // 64 KiB announced
    EXPECT_FALSE(reader.holds_frame());
    EXPECT_EQ(reader.next(payload), FrameReader::Status::NeedMore);
    for (int i = 0; i < 8; ++i) take("x");
}

TEST(FrameReader, LimitCanBeChosen) {
    FrameReader reader(10);
    std::string bytes;
    append_frame("0123456789", bytes);
    append_frame("0123456789a", bytes);
    reader.append(bytes);
    std::string_view payload;
    EXPECT_EQ(reader.next(payload), FrameReader::Status::Frame);
    EXPECT_EQ(reader.next(payload), FrameReader::Status::TooLong);
}

RC_GTEST_PROP(FrameReader, PayloadsSurviveAnyCutting, (const std::vector<std::string>& payloads)) {
    std::string bytes;
    for (const std::string& payload : payloads) append_frame(payload, bytes);
    FrameReader reader;
    std::vector<std::string> read;
    std::string_view rest = bytes;
    while (!rest.empty()) {
        const std::size_t count = std::min<std::size_t>(*rc::gen::inRange(1, 20), rest.size());
        reader.append(rest.substr(0, count));
        rest.remove_prefix(count);
        std::string_view payload;
        while (reader.next(payload) == FrameReader::Status::Frame) read.emplace_back(payload);
    }
    RC_ASSERT(read == payloads);
}

}  // namespace
}  // namespace k3d::wire

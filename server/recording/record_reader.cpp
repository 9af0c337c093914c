// SPDX-License-Identifier: BSD-3-Clause
#include "server/recording/record_reader.h"

#include <fmt/format.h>
#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <limits>

namespace k3d::server::recording {

namespace {

constexpr int kLastOutcome = 8;  // room for outcomes that later versions tell

std::uint64_t little_endian(const char* bytes, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = count; i-- > 0;) {
        value = value << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return value;
}

}  // namespace

void RecordReader::Free::operator()(ZSTD_DCtx_s* context) const { ZSTD_freeDCtx(context); }

RecordReader::RecordReader(std::istream& in, std::string name)
    : in_(in), name_(std::move(name)), context_(ZSTD_createDCtx()) {
    std::array<char, kMagic.size()> magic;
    in_.read(magic.data(), magic.size());
    if (!std::equal(kMagic.begin(), kMagic.end(), magic.begin()) || !in_) {
        throw RecordError(name_ + ": is no recording of this server (of this version)");
    }
    file_at_ = kMagic.size();
    if (!read_block()) fail("nothing behind the first line");
    Entry first = read_entry();
    if (!std::holds_alternative<Header>(first)) fail("no header");
    header_ = std::get<Header>(std::move(first));
}

std::optional<Entry> RecordReader::next() {
    if (at_ == plain_.size() && !read_block()) return std::nullopt;
    Entry entry = read_entry();
    if (std::holds_alternative<Header>(entry)) fail("a second header");
    return entry;
}

bool RecordReader::read_block() {
    block_at_ = file_at_;
    plain_.clear();
    at_ = 0;
    std::array<char, kBlockHeaderBytes> head;
    in_.read(head.data(), head.size());
    if (in_.gcount() == 0) return false;
    if (!in_) fail("cut short");
    const std::uint64_t stored_size = little_endian(head.data(), 4);
    const std::uint64_t plain_size = little_endian(head.data() + 4, 4);
    if (plain_size == 0 || plain_size > kMaxBlock || stored_size > ZSTD_compressBound(kMaxBlock)) {
        fail(fmt::format("a block of {} bytes, {} unpacked, limit {}", stored_size, plain_size,
                         kMaxBlock));
    }
    std::string stored(stored_size, '\0');
    in_.read(stored.data(), static_cast<std::streamsize>(stored_size));
    if (!in_) {
        fail(fmt::format("cut short: {} of {} bytes of a block", in_.gcount(), stored_size));
    }
    file_at_ += head.size() + stored_size;
    if (XXH3_64bits(stored.data(), stored.size()) != little_endian(head.data() + 8, 8)) {
        fail("damaged: the block's checksum is another");
    }
    plain_.resize(plain_size);
    const std::size_t size = ZSTD_decompressDCtx(context_.get(), plain_.data(), plain_.size(),
                                                 stored.data(), stored.size());
    if (ZSTD_isError(size) || size != plain_size) {
        plain_.clear();
        fail("damaged: the block cannot be unpacked");
    }
    return true;
}

Entry RecordReader::read_entry() {
    switch (const char kind = static_cast<char>(byte())) {
        case 'H': {
            std::string version = text();
            return Header{std::move(version), text()};
        }
        case 'A': {
            Accepted accepted;
            accepted.connection = connection();
            const int port = byte();
            if (port > 1) fail(fmt::format("port {}", port));
            accepted.port = static_cast<Port>(port);
            accepted.commands = byte() != 0;
            accepted.peer = text();
            return accepted;
        }
        case 'F': {
            const int from = connection();
            return Received{from, text()};
        }
        case 'L': {
            const int who = connection();
            return Left{who, text()};
        }
        case 'S':
            return StepEnd{little_endian(take(8).data(), 8)};
        case 'E': {
            const int outcome = byte();
            if (outcome > kLastOutcome) fail(fmt::format("outcome {}", outcome));
            return End{outcome};
        }
        default:
            fail(fmt::format("an entry of kind {}", static_cast<int>(kind)));
    }
}

std::uint64_t RecordReader::number() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 63; shift += 7) {
        const std::uint8_t part = byte();
        value |= std::uint64_t{part & 0x7Fu} << shift;
        if (part < 0x80) return value;
    }
    fail("a number without end");
}

int RecordReader::connection() {
    const std::uint64_t value = number();
    if (value == 0 || value > std::numeric_limits<int>::max()) {
        fail(fmt::format("connection {}", value));
    }
    return static_cast<int>(value);
}

std::uint8_t RecordReader::byte() { return static_cast<std::uint8_t>(take(1).front()); }

std::string RecordReader::text() { return std::string(take(number())); }

std::string_view RecordReader::take(std::size_t count) {
    if (count > plain_.size() - at_) {
        fail(fmt::format("an entry of {} bytes where {} are left", count, plain_.size() - at_));
    }
    at_ += count;
    return std::string_view(plain_).substr(at_ - count, count);
}

void RecordReader::fail(const std::string& what) const {
    const std::string inside = at_ > 0 ? fmt::format(" (unpacked byte {})", at_) : "";
    throw RecordError(fmt::format("{}: block at byte {}{}: {}", name_, block_at_, inside, what));
}

}  // namespace k3d::server::recording

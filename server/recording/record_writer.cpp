// SPDX-License-Identifier: BSD-3-Clause
#include "server/recording/record_writer.h"

#include <xxhash.h>
#include <zstd.h>

#include <cerrno>
#include <cstring>

#include "common/log/log.h"

namespace k3d::server::recording {

namespace {

constexpr std::size_t kFullBlock = 256 * 1024;
constexpr int kCompression = 3;

template <class Integer>
void append_little_endian(Integer value, std::string& out) {
    for (std::size_t i = 0; i < sizeof value; ++i) {
        out += static_cast<char>((value >> (8 * i)) & 0xFF);
    }
}

}  // namespace

void RecordWriter::Free::operator()(ZSTD_CCtx_s* context) const { ZSTD_freeCCtx(context); }

RecordWriter::RecordWriter(const std::string& file, const Header& header)
    : name_(file),
      file_(file, std::ios::binary | std::ios::trunc),
      context_(ZSTD_createCCtx()) {
    if (!file_) {
        throw std::runtime_error("cannot write recording " + file + ": " + std::strerror(errno));
    }
    file_ << kMagic;
    begin('H');
    text(header.code_version);
    text(header.config);
    flush();
}

RecordWriter::~RecordWriter() { flush(); }

void RecordWriter::add(const Accepted& accepted) {
    begin('A');
    number(static_cast<std::uint64_t>(accepted.connection));
    plain_ += static_cast<char>(accepted.port);
    plain_ += accepted.commands ? '\1' : '\0';
    text(accepted.peer);
}

void RecordWriter::add(int connection, std::string_view frame) {
    begin('F');
    number(static_cast<std::uint64_t>(connection));
    text(frame);
}

void RecordWriter::add(const Left& left) {
    begin('L');
    number(static_cast<std::uint64_t>(left.connection));
    text(left.why);
}

void RecordWriter::add(const StepEnd& step) {
    begin('S');
    append_little_endian(step.digest, plain_);
    if (++steps_ == kStepsPerBlock) flush();
}

void RecordWriter::add(const End& end) {
    begin('E');
    plain_ += static_cast<char>(end.outcome);
    flush();
}

void RecordWriter::begin(char kind) {
    if (plain_.size() >= kFullBlock) flush();
    plain_ += kind;
}

void RecordWriter::number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) plain_ += static_cast<char>((value & 0x7F) | 0x80);
    plain_ += static_cast<char>(value);
}

void RecordWriter::text(std::string_view bytes) {
    number(bytes.size());
    plain_ += bytes;
}

void RecordWriter::flush() {
    if (plain_.empty() || failed_) return;
    std::string block;
    stored_.resize(ZSTD_compressBound(plain_.size()));
    const std::size_t size = ZSTD_compressCCtx(context_.get(), stored_.data(), stored_.size(),
                                               plain_.data(), plain_.size(), kCompression);
    K3D_ASSERT(!ZSTD_isError(size));
    stored_.resize(size);
    append_little_endian(static_cast<std::uint32_t>(size), block);
    append_little_endian(static_cast<std::uint32_t>(plain_.size()), block);
    append_little_endian(std::uint64_t{XXH3_64bits(stored_.data(), size)}, block);
    block += stored_;
    plain_.clear();
    steps_ = 0;
    // One write: a process that is killed between two leaves whole blocks.
    file_.write(block.data(), static_cast<std::streamsize>(block.size())).flush();
    if (file_) return;
    failed_ = true;  // a full disk must not end the match
    spdlog::error("cannot write to recording {}: it ends here", name_);
}

}  // namespace k3d::server::recording

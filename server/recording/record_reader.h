// SPDX-License-Identifier: BSD-3-Clause
// Reads a recording. No input makes it crash, hang or take memory without bound.
#pragma once

#include <istream>
#include <memory>
#include <optional>
#include <string>

#include "server/recording/record.h"

struct ZSTD_DCtx_s;

namespace k3d::server::recording {

class RecordReader {
  public:
    /// Reads the header. `name` is used in messages; the stream must outlive the reader. Throws
    /// RecordError.
    RecordReader(std::istream& in, std::string name);

    const Header& header() const { return header_; }

    /// The next entry; none at the end of the file. A damaged or cut block is a RecordError naming
    /// its place, after all entries before it have been given.
    std::optional<Entry> next();

  private:
    bool read_block();
    Entry read_entry();
    std::uint64_t number();
    int connection();
    std::uint8_t byte();
    std::string text();
    std::string_view take(std::size_t count);
    [[noreturn]] void fail(const std::string& what) const;

    struct Free {
        void operator()(ZSTD_DCtx_s* context) const;
    };
    std::istream& in_;
    std::string name_;
    std::unique_ptr<ZSTD_DCtx_s, Free> context_;
    std::string plain_;
    std::size_t at_ = 0;           ///< in plain_
    std::uint64_t block_at_ = 0;   ///< in the file
    std::uint64_t file_at_ = 0;
    Header header_;
};

}  // namespace k3d::server::recording

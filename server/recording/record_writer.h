// SPDX-License-Identifier: BSD-3-Clause
// Writes a recording, block by block.
#pragma once

#include <fstream>
#include <memory>
#include <string>

#include "server/recording/record.h"

struct ZSTD_CCtx_s;

namespace k3d::server::recording {

class RecordWriter {
  public:
    /// Starts the file anew with its first block. Throws std::runtime_error naming the file.
    RecordWriter(const std::string& file, const Header& header);
    ~RecordWriter();  ///< writes what is pending

    void add(const Accepted& accepted);
    void add(int connection, std::string_view frame);  ///< a Received
    void add(const Left& left);
    /// Every kStepsPerBlock steps, and before that whenever much has come in, what there is goes out.
    void add(const StepEnd& step);
    void add(const End& end);

    static constexpr int kStepsPerBlock = 50;  ///< a second of simulated time

  private:
    void begin(char kind);
    void number(std::uint64_t value);
    void text(std::string_view bytes);
    void flush();

    struct Free {
        void operator()(ZSTD_CCtx_s* context) const;
    };
    std::string name_;
    std::ofstream file_;
    std::unique_ptr<ZSTD_CCtx_s, Free> context_;
    std::string plain_, stored_;
    int steps_ = 0;       ///< in this block
    bool failed_ = false;
};

}  // namespace k3d::server::recording

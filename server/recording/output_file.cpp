// SPDX-License-Identifier: BSD-3-Clause
#include "server/recording/output_file.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace k3d::server::recording {

OutputFile::OutputFile(std::string what, std::string file, Begin begin)
    : what_(std::move(what)),
      name_(std::move(file)),
      file_(name_, std::ios::binary | (begin == Begin::Anew ? std::ios::trunc : std::ios::app)) {
    check();
}

void OutputFile::write(std::string_view text) {
    file_ << text << std::flush;
    check();
}

void OutputFile::check() {
    if (file_) return;
    throw std::runtime_error("cannot write " + what_ + " to " + name_ + ": " +
                             std::strerror(errno));
}

}  // namespace k3d::server::recording

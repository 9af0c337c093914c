// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/results_file.h"

#include <filesystem>
#include <stdexcept>

namespace k3d::optimizer::report {

ResultsFile::ResultsFile(const std::string& path) : path_(path) {
    if (path.empty()) return;
    file_.open(path, std::ios::app);
    if (!file_) throw std::runtime_error("cannot write results to " + path);
}

void ResultsFile::settle(int index, const std::optional<episode::Result>& result) {
    waiting_.emplace(index, result);
    while (!waiting_.empty() && waiting_.begin()->first == next_) {
        write(waiting_.begin()->second);
        waiting_.erase(waiting_.begin());
        ++next_;
    }
}

void ResultsFile::close() {
    write_waiting();
    forget_old();
}

ResultsFile::~ResultsFile() {
    try {
        write_waiting();
    } catch (const std::exception&) {
        return;  // what is under way already tells more
    }
}

void ResultsFile::write_waiting() {
    for (const auto& [index, result] : waiting_) write(result);
    waiting_.clear();
}

void ResultsFile::write(const std::optional<episode::Result>& result) {
    if (path_.empty() || !result) return;
    forget_old();
    file_ << k3d::episode::to_line(*result) << '\n' << std::flush;
    if (!file_) throw std::runtime_error("cannot write results to " + path_);
}

void ResultsFile::forget_old() {
    if (path_.empty() || !holds_old_) return;
    holds_old_ = false;
    // A pipe or a terminal holds nothing. Open for appending, the stream goes on at the new end.
    if (std::filesystem::is_regular_file(path_)) std::filesystem::resize_file(path_, 0);
}

}  // namespace k3d::optimizer::report

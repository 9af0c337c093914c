// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/results_file.h"

#include <stdexcept>

namespace k3d::optimizer::report {

ResultsFile::ResultsFile(const std::string& path) : path_(path) {
    if (path.empty()) return;
    file_.open(path, std::ios::trunc);
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
    for (const auto& [index, result] : waiting_) write(result);
    waiting_.clear();
}

void ResultsFile::write(const std::optional<episode::Result>& result) {
    if (path_.empty() || !result) return;
    file_ << k3d::episode::to_line(*result) << '\n' << std::flush;
    if (!file_) throw std::runtime_error("cannot write results to " + path_);
}

}  // namespace k3d::optimizer::report

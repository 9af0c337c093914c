// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/backend/log_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace k3d::optimizer::backend {

namespace fs = std::filesystem;

std::string make_temporary_log_folder(const std::string& name) {
    std::string path = (fs::temp_directory_path() / (name + "XXXXXX")).string();
    if (::mkdtemp(path.data()) == nullptr) {
        throw std::runtime_error(fmt::format("log folder {}: {}", path, std::strerror(errno)));
    }
    return path;
}

std::string make_log_folder(const std::string& path) {
    std::error_code fault;
    fs::create_directories(path, fault);
    if (fault || !fs::is_directory(path)) {
        throw std::runtime_error(
            fmt::format("log folder {}: {}", path, fault ? fault.message() : "not a folder"));
    }
    return fs::absolute(path).string();
}

LogFolder::LogFolder(const std::string& wanted)
    : path_(wanted.empty() ? make_temporary_log_folder("k3d-match-") : make_log_folder(wanted)),
      temporary_(wanted.empty()) {}

LogFolder::~LogFolder() {
    std::error_code ignored;
    if (temporary_) fs::remove(path_, ignored);
}

std::string LogFolder::begin(const episode::Task& task) {
    const std::string of_seed = fmt::format("{}/seed-{}", path_, task.seed);
    if (task.attempt == 1) fs::remove_all(of_seed);
    return make_log_folder(fmt::format("{}/try-{}", of_seed, task.attempt));
}

void LogFolder::end(const std::string& folder, bool failed) {
    if (failed || !temporary_) return;
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    fs::remove(fs::path(folder).parent_path(), ignored);  // the seed's, if this was its only try
}

}  // namespace k3d::optimizer::backend

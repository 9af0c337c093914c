// SPDX-License-Identifier: BSD-3-Clause
#include "server/viewer/beliefs.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

namespace k3d::server::viewer {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kEnding = ".telemetry.jsonl";
constexpr std::size_t kLongestLine = 64 * 1024;

/// A line that is whole and tells a belief; others would break the page's message.
bool is_belief(const std::string& line) {
    if (line.size() > kLongestLine || line.find("\"belief\"") == std::string::npos) return false;
    const auto parsed = nlohmann::json::parse(line, nullptr, false);
    return parsed.is_object() && parsed.value("event", nlohmann::json()) == "belief";
}

}  // namespace

bool Beliefs::follow(const std::string& path, File& file) const {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) return false;
    if (size < file.read) file = {};  // written anew
    if (size == file.read) return false;
    std::ifstream in(path, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(file.read));
    std::array<char, 16 * 1024> block;
    std::string candidate;
    while (in.read(block.data(), block.size()) || in.gcount() > 0) {
        const auto got = static_cast<std::size_t>(in.gcount());
        file.read += got;
        file.rest.append(block.data(), got);
        std::size_t begin = 0;
        for (std::size_t end; (end = file.rest.find('\n', begin)) != std::string::npos; begin = end + 1) {
            std::string line = file.rest.substr(begin, end - begin);
            if (line.find("\"belief\"") != std::string::npos) candidate = std::move(line);
        }
        file.rest.erase(0, begin);
        if (file.rest.size() > kLongestLine) file.rest.clear();
    }
    if (candidate.empty() || !is_belief(candidate)) return false;
    file.newest = std::move(candidate);
    return true;
}

std::string Beliefs::news() {
    std::set<std::string> present;
    bool anything = false;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(kEnding)) continue;
        const std::string player = name.substr(0, name.find('.'));
        present.insert(player);
        anything |= follow(entry.path().string(), files_[player]);
    }
    std::erase_if(files_, [&](const auto& file) { return !present.contains(file.first); });
    if (!anything) return {};
    std::string text = R"({"kind":"beliefs","players":{)";
    bool first = true;
    for (const auto& [player, file] : files_) {
        if (file.newest.empty()) continue;
        if (!first) text += ',';
        first = false;
        text += nlohmann::json(player).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
                ":" + file.newest;
    }
    return text + "}}";
}

}  // namespace k3d::server::viewer

// SPDX-License-Identifier: BSD-3-Clause
// The repository's own files, as the structure tests read them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace k3d::structure {

struct SourceFile {
    std::string path;                ///< from the repository's root, "server/physics/world.cpp"
    std::vector<std::string> lines;  ///< without line ends

    bool below(const std::string& folder) const { return path.rfind(folder + "/", 0) == 0; }
    std::string folder() const { return path.substr(0, path.rfind('/') + 1); }
    std::string extension() const { return std::filesystem::path(path).extension().string(); }
    bool is_cpp() const { return extension() == ".cpp" || extension() == ".h"; }
    bool is_script() const { return !lines.empty() && lines[0].rfind("#!", 0) == 0; }
    bool is_page() const {
        const std::string e = extension();
        return e == ".js" || e == ".mjs" || e == ".css" || e == ".html";
    }
};

/// Lines of a text file; none if it holds a NUL byte (a picture, say).
inline std::vector<std::string> read_text(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + path.string());
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) {
        if (line.find('\0') != std::string::npos) return {};
        lines.push_back(line);
    }
    return lines;
}

/// All text files of ours, sorted by path: neither what git keeps, nor what is built or installed.
inline std::vector<SourceFile> read_source_tree() {
    namespace fs = std::filesystem;
    const fs::path root = K3D_SOURCE_DIR;
    std::vector<SourceFile> files;
    for (auto it = fs::recursive_directory_iterator(root); it != fs::end(it); ++it) {
        const std::string name = it->path().filename().string();
        const bool built = name == "build" && it.depth() == 0;
        if (built || name == ".git" || name == "node_modules") {
            it.disable_recursion_pending();
        } else if (it->is_regular_file() && !it->is_symlink()) {
            files.push_back(
                {fs::relative(it->path(), root).generic_string(), read_text(it->path())});
        }
    }
    std::sort(files.begin(), files.end(),
              [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

inline const std::vector<SourceFile>& source_tree() {
    static const std::vector<SourceFile> files = read_source_tree();
    return files;
}

}  // namespace k3d::structure

// SPDX-License-Identifier: BSD-3-Clause
// Which file of a folder a request target names.
#include "common/http/files.h"

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>
#include <utility>

namespace k3d::http {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxPath = 512;  // our own files need far less; keeps PATH_MAX out of it

std::optional<int> hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return std::nullopt;
}

std::optional<std::string> percent_decoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i];
            continue;
        }
        if (i + 2 >= text.size()) return std::nullopt;
        const auto high = hex_digit(text[i + 1]);
        const auto low = hex_digit(text[i + 2]);
        if (!high || !low) return std::nullopt;
        out += static_cast<char>(*high * 16 + *low);
        i += 2;
    }
    return out;
}

bool has_dotted_segment(std::string_view path) {
    return path.find("/.") != std::string_view::npos;
}

bool is_below(const fs::path& file, const fs::path& folder) {
    const auto [end, unused] =
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return end == folder.end();
}

Found missing(std::string reason) {
    return {Found::What::Missing, {}, std::move(reason)};
}
Found malformed(std::string reason) {
    return {Found::What::Malformed, {}, std::move(reason)};
}

}  // namespace

Found find_file(const fs::path& folder, std::string_view target) {
    if (target.empty() || target.front() != '/') return malformed("target does not begin with /");
    const auto decoded = percent_decoded(target.substr(0, target.find_first_of("?#")));
    if (!decoded) return malformed("broken %-escape in the target");
    if (decoded->find('\0') != std::string::npos) return malformed("NUL in the target");
    if (decoded->find('\\') != std::string::npos) return malformed("backslash in the target");
    if (decoded->size() > kMaxPath) return missing("target too long");
    if (has_dotted_segment(*decoded)) return missing("not served");

    std::error_code error;
    const fs::path root = fs::canonical(folder, error);
    if (error) return missing("the served folder is gone");
    // "+=" and not "/=": an absolute right-hand side would replace the root.
    fs::path file = root;
    file += *decoded;
    if (fs::is_directory(file, error)) file /= "index.html";
    file = fs::canonical(file, error);
    if (error || !is_below(file, root)) return missing("no such file");
    if (!fs::is_regular_file(file, error)) return missing("no such file");
    return {Found::What::File, file, {}};
}

std::string_view mime_type(const fs::path& file) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kTypes{{
        {".html", "text/html; charset=utf-8"},
        {".js", "text/javascript; charset=utf-8"},
        {".mjs", "text/javascript; charset=utf-8"},
        {".css", "text/css; charset=utf-8"},
        {".json", "application/json"},
        {".svg", "image/svg+xml"},
        {".png", "image/png"},
        {".ico", "image/x-icon"},
        {".txt", "text/plain; charset=utf-8"},
        {".csv", "text/csv; charset=utf-8"},
        {".woff2", "font/woff2"},
    }};
    const std::string extension = file.extension().string();
    for (const auto& [known, type] : kTypes) {
        if (extension == known) return type;
    }
    return "application/octet-stream";
}

}  // namespace k3d::http

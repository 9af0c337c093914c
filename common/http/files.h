// SPDX-License-Identifier: BSD-3-Clause
// From the target of a request to a file of one folder, and to nothing outside it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace k3d::http {

/// What a request target stands for.
struct Found {
    enum class What { File, Missing, Malformed };
    What what = What::Missing;
    std::filesystem::path file;  ///< if What::File
    std::string reason;          ///< otherwise, for the answer's text
};

/// Resolves a target ("/", "/page.css?v=2", "/a%20b.js") inside `folder`. A folder stands for the
/// index.html in it. Malformed: no leading slash, a broken %-escape, a NUL, a backslash. Missing:
/// no such file, a segment that begins with a dot ("..", ".git"), a link that leads out of
/// `folder`, anything but a regular file. Never throws on any target.
Found find_file(const std::filesystem::path& folder, std::string_view target);

/// Content-Type by extension; "application/octet-stream" for those not known.
std::string_view mime_type(const std::filesystem::path& file);

}  // namespace k3d::http

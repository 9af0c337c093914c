// SPDX-License-Identifier: BSD-3-Clause
#include "common/config/stray.h"

namespace k3d::config {

namespace {

bool beyond_ascii(char c) {
    return static_cast<unsigned char>(c) >= 0x80;
}

/// Where the scan is: `end` is what closes the text it is in, empty outside.
struct Place {
    std::string_view end;
    bool escapes = false;  // a backslash hides the next character
};

Place place_after(std::string_view rest) {
    if (rest.starts_with("\"\"\"")) return {"\"\"\"", true};
    if (rest.starts_with("'''")) return {"'''", false};
    if (rest.starts_with('"')) return {"\"", true};
    if (rest.starts_with('\'')) return {"'", false};
    if (rest.starts_with('#')) return {"\n", false};
    return {};
}

}  // namespace

std::optional<int> stray_letter_line(std::string_view toml) {
    if (toml.starts_with("\xEF\xBB\xBF")) toml.remove_prefix(3);  // byte order mark
    Place place;
    int line = 1;
    for (std::size_t i = 0; i < toml.size();) {
        const std::string_view rest = toml.substr(i);
        if (rest[0] == '\n') ++line;
        if (place.end.empty()) {
            if (beyond_ascii(rest[0])) return line;
            place = place_after(rest);
            // A comment ends with its line, the other texts with what began them.
            i += place.end.empty() || place.end == "\n" ? 1 : place.end.size();
        } else if (place.escapes && rest[0] == '\\' && rest.size() > 1) {
            if (beyond_ascii(rest[1])) return line;
            if (rest[1] == '\n') ++line;
            i += 2;
        } else if (rest.starts_with(place.end)) {
            i += place.end.size();
            place = {};
        } else {
            ++i;
        }
    }
    return std::nullopt;
}

}  // namespace k3d::config

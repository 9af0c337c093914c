// SPDX-License-Identifier: BSD-3-Clause
#include "common/config/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/config/walk.h"
#include "common/sexpr/writer.h"

namespace k3d::config {

namespace {

/// Number of single-character edits between two texts.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({above + 1, row[j - 1] + 1, replaced});
            diagonal = above;
        }
    }
    return row[b.size()];
}

}  // namespace

std::string number_text(double value) {
    std::string text;
    sexpr::append_exact(value, text);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string range_text(Range range) {
    std::string text;
    if (std::isfinite(range.min) && std::isfinite(range.max)) {
        sexpr::append_exact(range.min, text);
        text += " to ";
        sexpr::append_exact(range.max, text);
    } else if (std::isfinite(range.min)) {
        text = "at least ";
        sexpr::append_exact(range.min, text);
    } else if (std::isfinite(range.max)) {
        text = "at most ";
        sexpr::append_exact(range.max, text);
    }
    return text;
}

std::string quoted(std::string_view text) {
    constexpr std::string_view kHex = "0123456789ABCDEF";
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (byte < 0x20 || byte == 0x7F) {
            out += "\\u00";
            out += kHex[byte >> 4];
            out += kHex[byte & 15];
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string nearest(std::string_view path, const std::vector<std::string>& known) {
    std::string best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::string& candidate : known) {
        // The key carries the meaning: the right key in a wrong section is near, too.
        const std::size_t misplaced = section_of(path) == section_of(candidate) ? 0 : 1;
        const std::size_t distance = std::min(
            2 * edits(path, candidate), 2 * edits(key_of(path), key_of(candidate)) + misplaced);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

}  // namespace k3d::config

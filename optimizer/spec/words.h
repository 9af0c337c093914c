// SPDX-License-Identifier: BSD-3-Clause
// Command lines of foreign programs: split as a shell would, without a shell; seats filled in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace k3d::optimizer::spec {

/// Blanks separate words; 'literal', "with \" and \\ only", \c outside quotes is c. No variables,
/// no globbing, no operators: who wants a shell writes sh -c '...'. Throws std::invalid_argument
/// for a quote without end.
std::vector<std::string> split_words(std::string_view text);

/// One word that split_words() gives back as `text`.
std::string quote_word(std::string_view text);

/// What the placeholders of a foreign command stand for.
struct Place {
    std::string host;
    int port = 0;
    int unum = 0;
    std::string team;
};

/// Words of `command` with {host} {port} {unum} {team} filled in. Another {name} of small letters
/// is std::invalid_argument: it would be a misspelt one.
std::vector<std::string> fill_command(std::string_view command, const Place& place);

}  // namespace k3d::optimizer::spec

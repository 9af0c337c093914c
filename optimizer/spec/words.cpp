// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace k3d::optimizer::spec {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n';
}

/// The part of `text` from its opening quote at `at`; `at` is moved behind the closing one.
std::string quoted_part(std::string_view text, std::size_t& at) {
    const char quote = text[at++];
    std::string part;
    while (at < text.size() && text[at] != quote) {
        const bool escape = quote == '"' && text[at] == '\\' && at + 1 < text.size() &&
                            (text[at + 1] == '"' || text[at + 1] == '\\');
        if (escape) ++at;
        part += text[at++];
    }
    if (at == text.size()) throw std::invalid_argument(fmt::format("{} without end", quote));
    ++at;
    return part;
}

std::string value_of(std::string_view name, const Place& place) {
    if (name == "host") return place.host;
    if (name == "port") return std::to_string(place.port);
    if (name == "unum") return std::to_string(place.unum);
    if (name == "team") return place.team;
    throw std::invalid_argument(
        fmt::format("{{{}}} is none of {{host}}, {{port}}, {{unum}}, {{team}}", name));
}

std::string fill(std::string_view word, const Place& place) {
    std::string out;
    for (std::size_t at = 0; at < word.size();) {
        const std::size_t end = word[at] == '{' ? word.find('}', at) : std::string_view::npos;
        const std::string_view name =
            end == std::string_view::npos ? "" : word.substr(at + 1, end - at - 1);
        const bool field = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
            return c >= 'a' && c <= 'z';
        });
        if (field) {
            out += value_of(name, place);
            at = end + 1;
        } else {
            out += word[at++];
        }
    }
    return out;
}

}  // namespace

std::vector<std::string> split_words(std::string_view text) {
    std::vector<std::string> words;
    std::optional<std::string> word;  // none between words; "" is a word
    for (std::size_t at = 0; at < text.size();) {
        if (is_blank(text[at])) {
            if (word) words.push_back(*word);
            word.reset();
            ++at;
            continue;
        }
        if (!word) word.emplace();
        if (text[at] == '\'' || text[at] == '"') {
            *word += quoted_part(text, at);
        } else {
            if (text[at] == '\\' && ++at == text.size()) {
                throw std::invalid_argument("\\ without a character after it");
            }
            *word += text[at++];
        }
    }
    if (word) words.push_back(*word);
    return words;
}

std::string quote_word(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

std::vector<std::string> fill_command(std::string_view command, const Place& place) {
    std::vector<std::string> words = split_words(command);
    for (std::string& word : words) word = fill(word, place);
    return words;
}

}  // namespace k3d::optimizer::spec

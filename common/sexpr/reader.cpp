// SPDX-License-Identifier: BSD-3-Clause
#include "common/sexpr/reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace k3d::sexpr {

namespace {

enum class Kind : unsigned char { Atom, Blank, Open, Close };

constexpr std::array<Kind, 256> kKinds = [] {
    std::array<Kind, 256> kinds{};
    for (const char blank : {' ', '\t', '\r', '\n'}) kinds[static_cast<unsigned char>(blank)] = Kind::Blank;
    kinds['('] = Kind::Open;
    kinds[')'] = Kind::Close;
    return kinds;
}();

Kind kind_of(char c) {
    return kKinds[static_cast<unsigned char>(c)];
}

/// Numbers as the wire has them, `-12.34`: of up to 15 digits, digits and power of ten are exact doubles, and
/// their quotient rounds as from_chars does. None for anything else.
std::optional<double> short_number(std::string_view text) {
    constexpr std::size_t kDigits = 15;
    static constexpr std::array<double, kDigits + 1> kPowers{
        1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char* p = text.data();
    const char* const end = p + text.size();
    const bool negative = p != end && *p == '-';
    if (negative) ++p;
    if (end - p > static_cast<std::ptrdiff_t>(kDigits)) return std::nullopt;
    const auto take_digits = [&p, end](std::int64_t& value) {
        const char* const begin = p;
        for (; p != end && *p >= '0' && *p <= '9'; ++p) value = 10 * value + (*p - '0');
        return static_cast<std::size_t>(p - begin);
    };
    std::int64_t digits = 0;
    if (take_digits(digits) == 0) return std::nullopt;
    std::size_t decimals = 0;
    if (p != end && *p == '.') {
        ++p;
        decimals = take_digits(digits);
        if (decimals == 0) return std::nullopt;
    }
    if (p != end) return std::nullopt;
    const double value = static_cast<double>(digits) / kPowers[decimals];
    return negative ? -value : value;
}

/// from_chars knows no leading plus, but printf("%+f") and people write it.
std::string_view without_plus(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    return text;
}

}  // namespace

Error Document::parse(std::string_view text) {
    struct Open {
        std::uint32_t list;
        std::uint32_t last;  // last element so far, 0 = none
    };
    std::array<Open, kMaxDepth + 1> open;  // open[0] is the top level
    open[0] = {0, 0};
    std::size_t depth = 0;
    std::uint32_t last_whole = 0;  // last top-level expression that is complete
    // As many as there may be at most: one needs a character, the next one another.
    const std::size_t most = std::min(text.size(), kMaxNodes) + 1;
    if (entries_.size() < most) entries_.resize(most);
    Entry* const entries = entries_.data();
    std::uint32_t count = 1;
    entries[0] = {{}, 0, 0, true};

    const auto add = [&](std::string_view atom, bool list) {
        Open& here = open[depth];
        (here.last != 0 ? entries[here.last].next : entries[here.list].child) = count;
        here.last = count;
        entries[count] = {atom, 0, 0, list};
        return count++;
    };
    const auto fail = [&](Error error) {
        // Only whole top-level expressions may be seen.
        if (last_whole != 0) {
            entries[last_whole].next = 0;
        } else {
            entries[0].child = 0;
        }
        return error;
    };

    const char* p = text.data();
    const char* const end = p + text.size();
    while (p != end) {
        const Kind kind = kind_of(*p);
        if (kind == Kind::Blank) {
            ++p;
        } else if (kind == Kind::Close) {
            if (depth == 0) return fail(Error::Unbalanced);
            if (--depth == 0) last_whole = open[0].last;
            ++p;
        } else if (count >= kMaxNodes) {
            return fail(Error::TooManyNodes);
        } else if (kind == Kind::Open) {
            if (depth == kMaxDepth) return fail(Error::TooDeep);
            const std::uint32_t list = add({}, true);
            open[++depth] = {list, 0};
            ++p;
        } else {
            const char* const begin = p;
            while (p != end && kind_of(*p) == Kind::Atom) ++p;
            add({begin, static_cast<std::size_t>(p - begin)}, false);
            if (depth == 0) last_whole = open[0].last;
        }
    }
    return depth == 0 ? Error::None : fail(Error::Unbalanced);
}

std::optional<Node> Document::first() const {
    if (entries_.empty() || entries_[0].child == 0) return std::nullopt;
    return Node(this, entries_[0].child);
}

int Node::size() const {
    int count = 0;
    for (auto n = first(); n; n = n->next()) ++count;
    return count;
}

std::optional<double> Node::number() const {
    return to_number(atom());
}
std::optional<int> Node::integer() const {
    return to_integer(atom());
}

std::optional<double> to_number(std::string_view text) {
    if (const auto number = short_number(text)) return number;
    text = without_plus(text);
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<int> to_integer(std::string_view text) {
    text = without_plus(text);
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc{} || stop != end) return std::nullopt;
    return value;
}

}  // namespace k3d::sexpr

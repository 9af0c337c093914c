// SPDX-License-Identifier: BSD-3-Clause
#include "common/sexpr/reader.h"

#include <array>
#include <charconv>
#include <cmath>

namespace k3d::sexpr {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}
bool ends_atom(char c) {
    return c == '(' || c == ')' || is_blank(c);
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
    entries_.clear();
    entries_.push_back({{}, 0, 0, true});

    const auto add = [&](Entry entry) {
        const auto index = static_cast<std::uint32_t>(entries_.size());
        Open& here = open[depth];
        if (here.last != 0) {
            entries_[here.last].next = index;
        } else {
            entries_[here.list].child = index;
        }
        here.last = index;
        entries_.push_back(entry);
        return index;
    };
    const auto fail = [&](Error error) {
        // Only whole top-level expressions may be seen.
        if (last_whole != 0) {
            entries_[last_whole].next = 0;
        } else {
            entries_[0].child = 0;
        }
        return error;
    };

    const char* p = text.data();
    const char* const end = p + text.size();
    while (p != end) {
        if (is_blank(*p)) {
            ++p;
        } else if (*p == ')') {
            if (depth == 0) return fail(Error::Unbalanced);
            if (--depth == 0) last_whole = open[0].last;
            ++p;
        } else if (entries_.size() >= kMaxNodes) {
            return fail(Error::TooManyNodes);
        } else if (*p == '(') {
            if (depth == kMaxDepth) return fail(Error::TooDeep);
            const std::uint32_t list = add({{}, 0, 0, true});
            open[++depth] = {list, 0};
            ++p;
        } else {
            const char* const begin = p;
            while (p != end && !ends_atom(*p)) ++p;
            add({{begin, static_cast<std::size_t>(p - begin)}, 0, 0, false});
            if (depth == 0) last_whole = open[0].last;
        }
    }
    return depth == 0 ? Error::None : fail(Error::Unbalanced);
}

std::optional<Node> Document::first() const {
    if (entries_.empty() || entries_[0].child == 0) return std::nullopt;
    return Node(this, entries_[0].child);
}

bool Node::is_atom() const {
    return !document_->entries_[index_].list;
}

std::string_view Node::atom() const {
    return document_->entries_[index_].text;
}

std::optional<Node> Node::first() const {
    const std::uint32_t child = document_->entries_[index_].child;
    if (child == 0) return std::nullopt;
    return Node(document_, child);
}

std::optional<Node> Node::next() const {
    const std::uint32_t next = document_->entries_[index_].next;
    if (next == 0) return std::nullopt;
    return Node(document_, next);
}

int Node::size() const {
    int count = 0;
    for (auto n = first(); n; n = n->next()) ++count;
    return count;
}

std::string_view Node::tag() const {
    const auto head = first();
    return head ? head->atom() : std::string_view{};
}

std::optional<Node> Node::at(int position) const {
    auto n = first();
    for (int i = 0; n && i < position; ++i) n = n->next();
    return n;
}

std::optional<Node> Node::find(std::string_view tag) const {
    for (auto n = first(); n; n = n->next()) {
        if (n->is_list() && n->tag() == tag) return n;
    }
    return std::nullopt;
}

std::optional<double> Node::number() const {
    return to_number(atom());
}
std::optional<int> Node::integer() const {
    return to_integer(atom());
}

std::optional<double> to_number(std::string_view text) {
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

// SPDX-License-Identifier: BSD-3-Clause
// S-expression reader that copies nothing: nodes are views into the text, kept in one reused array.
// What a frame asks of every node is inline: an agent reads some 900 nodes a cycle.
//
// Atoms are runs of bytes other than blank, tab, CR, LF and parentheses; there are no comments,
// quotes or escapes. Depth and node count are bounded, so no input can exhaust stack or memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace k3d::sexpr {

inline constexpr int kMaxDepth = 64;
inline constexpr std::size_t kMaxNodes = 65536;

class Document;

/// An atom or a list inside a Document; cheap to copy, valid while the Document and its text live.
class Node {
  public:
    bool is_atom() const;
    bool is_list() const { return !is_atom(); }
    std::string_view atom() const;             ///< text of an atom, empty for a list

    /// Elements of a list; iteration: for (auto n = list.first(); n; n = n->next()).
    std::optional<Node> first() const;
    std::optional<Node> next() const;
    int size() const;                          ///< number of elements, 0 for an atom

    /// First element's text if it is an atom, e.g. "pol" of `(pol 1 2 3)`.
    std::string_view tag() const;
    std::optional<Node> at(int position) const;            ///< element by position
    std::optional<Node> find(std::string_view tag) const;  ///< first element list with this tag

    std::optional<double> number() const;      ///< atom as a finite decimal number
    std::optional<int> integer() const;        ///< atom as a whole decimal number

  private:
    friend class Document;
    Node(const Document* document, std::uint32_t index) : document_(document), index_(index) {}
    const Document* document_;
    std::uint32_t index_;
};

enum class Error { None, Unbalanced, TooDeep, TooManyNodes };

class Document {
  public:
    /// Reads all top-level expressions. On an error the complete expressions before it are kept.
    Error parse(std::string_view text);

    /// First top-level expression; go on with next().
    std::optional<Node> first() const;

  private:
    friend class Node;
    struct Entry {
        std::string_view text;     // of an atom
        std::uint32_t next = 0;    // index of the next sibling, 0 = none
        std::uint32_t child = 0;   // first element of a list, 0 = none
        bool list = false;
    };
    std::vector<Entry> entries_;   // entry 0 is the top level; grows only
};

inline bool Node::is_atom() const {
    return !document_->entries_[index_].list;
}

inline std::string_view Node::atom() const {
    return document_->entries_[index_].text;
}

inline std::optional<Node> Node::first() const {
    const std::uint32_t child = document_->entries_[index_].child;
    if (child == 0) return std::nullopt;
    return Node(document_, child);
}

inline std::optional<Node> Node::next() const {
    const std::uint32_t next = document_->entries_[index_].next;
    if (next == 0) return std::nullopt;
    return Node(document_, next);
}

inline std::string_view Node::tag() const {
    const auto head = first();
    return head ? head->atom() : std::string_view{};
}

inline std::optional<Node> Node::at(int position) const {
    auto n = first();
    for (int i = 0; n && i < position; ++i) n = n->next();
    return n;
}

inline std::optional<Node> Node::find(std::string_view tag) const {
    for (auto n = first(); n; n = n->next()) {
        if (n->is_list() && n->tag() == tag) return n;
    }
    return std::nullopt;
}

/// The whole text as a finite decimal number (exponents allowed); none for nan, inf or rubbish.
std::optional<double> to_number(std::string_view text);
std::optional<int> to_integer(std::string_view text);

}  // namespace k3d::sexpr

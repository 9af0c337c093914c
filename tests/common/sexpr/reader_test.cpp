// SPDX-License-Identifier: BSD-3-Clause
// What the s-expression reader accepts, refuses and keeps after a fault.
#include "common/sexpr/reader.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cstdlib>
#include <string>

namespace k3d::sexpr {
namespace {

/// The expressions as text again, one blank between elements.
std::string text_of(const Node& node) {
    if (node.is_atom()) return std::string(node.atom());
    std::string out = "(";
    for (auto n = node.first(); n; n = n->next()) {
        if (out.size() > 1) out += ' ';
        out += text_of(*n);
    }
    return out + ")";
}

std::string text_of(const Document& document) {
    std::string out;
    for (auto n = document.first(); n; n = n->next()) out += text_of(*n);
    return out;
}

TEST(SexprReader, ReadsListsAtomsAndAnyBlanks) {
    Document document;
    EXPECT_EQ(document.parse(" (a\t(b 1.5\r\n)( ) c)x(y)"), Error::None);
    EXPECT_EQ(text_of(document), "(a (b 1.5) () c)x(y)");
}

TEST(SexprReader, NothingIsQuoteCommentOrEscape) {
    Document document;
    EXPECT_EQ(document.parse("(say a;b\"c'd\\e)"), Error::None);
    EXPECT_EQ(document.first()->at(1)->atom(), "a;b\"c'd\\e");
}

TEST(SexprReader, EmptyTextHasNoExpressions) {
    Document document;
    EXPECT_FALSE(document.first());
    EXPECT_EQ(document.parse("  "), Error::None);
    EXPECT_FALSE(document.first());
}

TEST(SexprReader, KeepsWholeExpressionsBeforeAFault) {
    Document document;
    EXPECT_EQ(document.parse("(a 1)(b 2"), Error::Unbalanced);
    EXPECT_EQ(text_of(document), "(a 1)");
    EXPECT_EQ(document.parse("(a 1)(b 2))(c)"), Error::Unbalanced);
    EXPECT_EQ(text_of(document), "(a 1)(b 2)");
    EXPECT_EQ(document.parse("(a (b)"), Error::Unbalanced);
    EXPECT_FALSE(document.first());
    EXPECT_EQ(document.parse(")"), Error::Unbalanced);
    EXPECT_FALSE(document.first());
}

TEST(SexprReader, DepthIsBounded) {
    const auto nested = [](int depth) {
        return std::string(static_cast<std::size_t>(depth), '(') +
               std::string(static_cast<std::size_t>(depth), ')');
    };
    Document document;
    EXPECT_EQ(document.parse(nested(kMaxDepth)), Error::None);
    const std::string too_deep = "(a)" + nested(kMaxDepth + 1);
    EXPECT_EQ(document.parse(too_deep), Error::TooDeep);
    EXPECT_EQ(text_of(document), "(a)");
    EXPECT_EQ(document.parse(std::string(10'000'000, '(')), Error::TooDeep);
}

TEST(SexprReader, NodeCountIsBounded) {
    std::string text;
    for (std::size_t i = 0; i < kMaxNodes; ++i) text += "a ";
    Document document;
    EXPECT_EQ(document.parse(text), Error::TooManyNodes);
    text.resize(2 * (kMaxNodes - 1));  // one node is the top level's
    EXPECT_EQ(document.parse(text), Error::None);
}

TEST(SexprReader, FindsElementsByTagAndPosition) {
    Document document;
    document.parse("(GS (sl 1) t (t 7.25) (t 9))");
    const Node game = *document.first();
    EXPECT_EQ(game.tag(), "GS");
    EXPECT_EQ(game.size(), 5);
    EXPECT_EQ(game.find("t")->at(1)->number(), 7.25);
    EXPECT_FALSE(game.find("sr"));
    EXPECT_EQ(game.at(2)->atom(), "t");
    EXPECT_FALSE(game.at(5));
    EXPECT_EQ(game.at(1)->at(1)->integer(), 1);
    EXPECT_EQ(game.at(2)->size(), 0);
    EXPECT_EQ(game.at(2)->tag(), "");
    EXPECT_FALSE(game.number()) << "a list is no number";
}

TEST(SexprNumbers, DecimalTextOnly) {
    EXPECT_EQ(to_number("-0.25"), -0.25);
    EXPECT_EQ(to_number("+3"), 3.0);
    EXPECT_EQ(to_number("1e-05"), 1e-05);
    EXPECT_EQ(to_number(".5"), 0.5);
    for (const char* text : {"", "nan", "-nan", "inf", "1e999", "0x10", "1.2.3", "1,5", "+-1", "-",
                             "12a", " 1", "+"}) {
        EXPECT_FALSE(to_number(text)) << text;
    }
    EXPECT_EQ(to_integer("-12"), -12);
    EXPECT_EQ(to_integer("+12"), 12);
    for (const char* text : {"", "1.0", "99999999999", "a", "1 "}) {
        EXPECT_FALSE(to_integer(text)) << text;
    }
}

RC_GTEST_PROP(SexprNumbers, AreThoseOfTheCLibraryToTheBit,
              (std::uint64_t digits, std::uint8_t shift, std::uint8_t point, bool negative)) {
    std::string text = std::to_string(digits >> (shift % 64));
    if (point % 22 < text.size()) text.insert(point % 22, ".");
    if (negative) text.insert(0, "-");
    const double expected = std::strtod(text.c_str(), nullptr);
    const auto read = to_number(text);
    RC_ASSERT(read.has_value());
    RC_ASSERT(std::bit_cast<std::uint64_t>(*read) == std::bit_cast<std::uint64_t>(expected));
}

RC_GTEST_PROP(SexprReader, AnyBytesReadAndReadBackAlike, (const std::string& text)) {
    Document document;
    document.parse(text);
    const std::string once = text_of(document);
    if (document.first() && !document.first()->next()) {  // neighbouring atoms would melt
        Document again;
        RC_ASSERT(again.parse(once) == Error::None);
        RC_ASSERT(text_of(again) == once);
    }
}

RC_GTEST_PROP(SexprReader, TextsOfParenthesesNeverFail, ()) {
    const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("(( ))a")));
    Document document;
    const Error error = document.parse(text);
    int depth = 0;
    bool balanced = true;
    for (const char c : text) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        balanced = balanced && depth >= 0;
    }
    RC_ASSERT((error == Error::None) == (balanced && depth == 0));
}

}  // namespace
}  // namespace k3d::sexpr

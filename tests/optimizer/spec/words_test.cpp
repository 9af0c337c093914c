// SPDX-License-Identifier: BSD-3-Clause
// Command lines of foreign programs: split and filled in.
#include "optimizer/spec/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

namespace k3d::optimizer::spec {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

template <class Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no error";
}

TEST(Words, BlanksSeparateAndQuotesBind) {
    EXPECT_THAT(split_words("  ./agent --team  X\t-p 3 \n"),
                ElementsAre("./agent", "--team", "X", "-p", "3"));
    EXPECT_THAT(split_words("sh -c 'cd \"a b\" && exec ./x'"),
                ElementsAre("sh", "-c", "cd \"a b\" && exec ./x"));
    EXPECT_THAT(split_words(R"(a\ b "c \" \\ \n" d"e"'f')"),
                ElementsAre("a b", R"(c " \ \n)", "def"));
    EXPECT_THAT(split_words("x '' y"), ElementsAre("x", "", "y"));
    EXPECT_THAT(split_words(" \t"), IsEmpty());
}

TEST(Words, WithoutAShellNothingIsExpanded) {
    EXPECT_THAT(split_words("echo $HOME * ; ~"), ElementsAre("echo", "$HOME", "*", ";", "~"));
}

TEST(Words, AnOpenQuoteIsAnError) {
    EXPECT_EQ(error_of([] { split_words("a 'b c"); }), "' without end");
    EXPECT_EQ(error_of([] { split_words("a \"b\\\""); }), "\" without end");
    EXPECT_THAT(error_of([] { split_words("a \\"); }), HasSubstr("\\ without"));
}

TEST(Words, PlacesAreFilledInWithinWords) {
    const Place place{"127.0.0.1", 3100, 7, "Take Rs"};
    EXPECT_THAT(fill_command("a --at={host}:{port} -u{unum} {team}", place),
                ElementsAre("a", "--at=127.0.0.1:3100", "-u7", "Take Rs"));
    EXPECT_THAT(fill_command("a { {} {A} {1} }{", place),
                ElementsAre("a", "{", "{}", "{A}", "{1}", "}{"));
}

TEST(Words, AMisspeltPlaceIsAnError) {
    EXPECT_THAT(error_of([] { fill_command("a {prot}", {}); }), HasSubstr("{prot} is none of"));
}

RC_GTEST_PROP(Words, AQuotedWordComesBack, (const std::string& text)) {
    RC_ASSERT(split_words(quote_word(text)) == std::vector<std::string>{text});
}

}  // namespace
}  // namespace k3d::optimizer::spec

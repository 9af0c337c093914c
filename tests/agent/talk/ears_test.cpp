// SPDX-License-Identifier: BSD-3-Clause
// What is heard: of each team-mate the last word, by number; nothing of one's own, of others, or
// noise.
#include "agent/talk/ears.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace k3d::agent::talk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

constexpr int kOwnNumber = 2;

std::string word_of(int unum, Vec2 position = {1.0, 1.0}) {
    Message message;
    message.unum = unum;
    message.position = position;
    return encode(message);
}

wire::Percepts frame(double time, std::vector<wire::Heard> heard) {
    wire::Percepts percepts;
    percepts.time = time;
    percepts.heard = std::move(heard);
    return percepts;
}

wire::Heard from_afar(const std::string& team, const std::string& text) {
    return {team, 0.0, 45.0, text};
}

std::vector<int> numbers(std::span<const Message> messages) {
    std::vector<int> all;
    for (const Message& message : messages) all.push_back(message.unum);
    return all;
}

/// Who was heard last when.
std::vector<std::pair<int, double>> kept(const Ears& ears) {
    std::vector<std::pair<int, double>> all;
    for (const Report& report : ears.latest()) all.emplace_back(report.message.unum, report.heard);
    return all;
}

TEST(Ears, KeepNoWordThatIsNotATeamMates) {
    Ears ears;
    const wire::Percepts percepts =
        frame(1.0, {
                       from_afar("Reds", word_of(kOwnNumber)),
                       {"Reds", 0.0, std::nullopt, word_of(3)},  // one's own voice has no direction
                       from_afar("Blues", word_of(3)),
                       from_afar("Reds", "hello"),
                       from_afar("Reds", ""),
                   });
    EXPECT_THAT(ears.hear(percepts, "Reds", kOwnNumber), IsEmpty());
    EXPECT_THAT(ears.latest(), IsEmpty());
}

TEST(Ears, KeepTheLastWordOfEachByNumber) {
    Ears ears;
    const Vec2 first(1.0, 1.0);
    const Vec2 second(-2.0, 3.0);
    const auto fresh = ears.hear(
        frame(1.0, {from_afar("Reds", word_of(3, first)), from_afar("Reds", word_of(1, first))}),
        "Reds", kOwnNumber);
    EXPECT_THAT(numbers(fresh), ElementsAre(3, 1)) << "as they came";
    EXPECT_THAT(kept(ears), ElementsAre(Pair(1, 1.0), Pair(3, 1.0)));

    ears.hear(frame(1.5, {from_afar("Reds", word_of(3, second))}), "Reds", kOwnNumber);
    EXPECT_THAT(kept(ears), ElementsAre(Pair(1, 1.0), Pair(3, 1.5)));
    EXPECT_LT((ears.latest()[1].message.position - second).norm(), 0.1);

    EXPECT_THAT(ears.hear(frame(1.6, {}), "Reds", kOwnNumber), IsEmpty());
    EXPECT_THAT(kept(ears), ElementsAre(Pair(1, 1.0), Pair(3, 1.5)));
}

}  // namespace
}  // namespace k3d::agent::talk

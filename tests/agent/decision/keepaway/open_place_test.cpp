// SPDX-License-Identifier: BSD-3-Clause
// K3's learned place: lowest cost by all nine features, kept while it is hardly worse; bad files named.
#include "agent/decision/keepaway/open_place.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "agent/decision/keepaway/policy.h"
#include "agent/decision/keepaway/scene.h"

namespace k3d::agent::decision {
namespace {

class OpenPlaceTest : public testing::Test {
  protected:
    ~OpenPlaceTest() override { std::filesystem::remove(file_); }

    /// A weighted sum of some of the features.
    OpenPlace weighted(const std::vector<std::pair<std::string, double>>& weights,
                       std::size_t inputs = kPlaceFeatureNames.size()) const {
        network::Definition d;
        for (std::size_t i = 0; i < inputs; ++i) d.inputs.push_back({std::string(kPlaceFeatureNames[i])});
        d.outputs = {"cost"};
        d.nodes = {{"cost", network::Activation::Linear, 0.0}};
        for (const auto& [name, weight] : weights) d.links.push_back({name, "cost", weight});
        std::ofstream(file_) << network::to_json(d);
        return OpenPlace(file_, target_grid(10.0, {}));
    }

    std::string file_ =
        testing::TempDir() + "/k3d-open-place-" + std::to_string(getpid()) + ".json";
    PassSituation situation_{{0.0, 1.0}, {}, {{3.0, -2.0}}};
};

TEST_F(OpenPlaceTest, NinthInputIsTheWayToThePass) {
    EXPECT_EQ(weighted({{"f9", 1.0}}).choose(situation_, 6.0), Vec2(0.0, 1.0));
    EXPECT_EQ(weighted({{"f9", -1.0}}).choose(situation_, 6.0), Vec2(-4.0, -4.0)) << "first of equals";
}

TEST_F(OpenPlaceTest, FourthInputIsItsOwnWay) {
    EXPECT_EQ(weighted({{"f4", 1.0}}).choose(situation_, 6.0), Vec2(3.0, -2.0));
}

TEST_F(OpenPlaceTest, KeepsAPlaceThatIsHardlyWorse) {
    OpenPlace place = weighted({{"f3", 1.0}});  // (distance - 6)^2 + 1
    const Vec2 first = place.choose(situation_, 6.0);
    situation_.ball += Vec2(0.05, 0.0);
    EXPECT_EQ(place.choose(situation_, 6.0), first);
    situation_.ball = {4.0, 4.0};
    EXPECT_NE(place.choose(situation_, 3.0), first);
}

TEST_F(OpenPlaceTest, OtherInputsAreRefused) {
    EXPECT_THROW(weighted({{"f1", 1.0}}, 8), network::NetworkError);
    EXPECT_THROW(OpenPlace(file_ + ".missing", {Vec2::Zero()}), network::NetworkError);
}

TEST_F(OpenPlaceTest, TheLastOutputOfAPolicysNetworkIsK3s) {
    std::ofstream(file_) << network::to_json(test::prefers_both({"f4", 1.0}, {"f9", 1.0}));
    const Policy policy = load_policy(file_);
    ASSERT_TRUE(policy.values_places);
    const auto grid = target_grid(10.0, {});
    const Room all = [](const Vec2&) { return 1.0; };
    EXPECT_EQ(best_target(grid, situation_, policy, {}, all, {}, 0.0).point, Vec2(3.0, -2.0));
    EXPECT_EQ(OpenPlace(*policy.cost, grid).choose(situation_, 6.0), Vec2(0.0, 1.0));
}

}  // namespace
}  // namespace k3d::agent::decision

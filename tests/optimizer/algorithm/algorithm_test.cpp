// SPDX-License-Identifier: BSD-3-Clause
// What every algorithm must keep behind the one interface: order does not matter, states continue with
// the same bits, bad results are refused.
#include "optimizer/algorithm/algorithm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <ostream>

#include "common/random/stream.h"
#include "optimizer/algorithm/functions.h"

namespace k3d::optimizer::algorithm {
namespace {

using ::testing::HasSubstr;
using testing::Values;

struct Setup {
    std::string name;
    spec::AlgorithmSpec spec;
    spec::Problem problem;
};

void PrintTo(const Setup& setup, std::ostream* out) { *out << setup.name; }

network::Definition small_network() {
    network::Definition d;
    d.inputs = {{"a"}, {"b"}};
    d.outputs = {"out"};
    d.nodes = {{"out", network::Activation::Sigmoid, 0.1}};
    d.links = {{"a", "out", 0.5, false}, {"b", "out", -0.5, false}};
    return d;
}

std::vector<Setup> setups() {
    spec::VectorProblem mixed = testing::box(4, 1.0, 0.5);
    mixed[1].lower = 0.0;
    mixed[1].upper = 2.0;
    mixed[2].integer = true;
    mixed[2].deviation = 3.0;
    mixed[3].frozen = true;
    std::vector<Setup> all;
    const auto add = [&](const std::string& label, const std::string& name, const spec::Problem& p) {
        Setup setup{label, {}, p};
        setup.spec.name = name;
        setup.spec.neat.population = 12;
        setup.spec.neat.target_species = 3;
        setup.spec.cross_entropy.population = 12;
        setup.spec.sampling.episodes = 4;
        setup.spec.sampling.halving_episodes = 6;
        setup.spec.sampling.validation_episodes = 8;
        setup.spec.sampling.validate_every = 2;
        setup.spec.sampling.finalists = 3;
        setup.spec.cmaes.noise = "reevaluate";
        setup.spec.cmaes.restarts = "bipop";
        all.push_back(setup);
        return all.size() - 1;
    };
    add("cmaes", "cmaes", mixed);
    all[add("cmaes_separable", "cmaes", mixed)].spec.cmaes.covariance = "separable";
    add("cross_entropy", "cross_entropy", mixed);
    add("random_search", "random_search", mixed);
    all[add("neat", "neat", spec::NetworkProblem{small_network()})].spec.sampling.validate_every = 1;
    const std::size_t recurrent = add("neat_recurrent", "neat", spec::NetworkProblem{small_network()});
    all[recurrent].spec.neat.networks = "recurrent";
    all[recurrent].spec.neat.activations = "sigmoid tanh gauss";
    return all;
}

/// Fitness of an episode: a function of payload and seed alone, as the simulation is.
double play(const Request& request, int episode) {
    double value = 0.0;
    if (const auto* x = std::get_if<Values>(&request.payload)) {
        for (const double v : *x) value -= (v - 0.3) * (v - 0.3);
    } else {
        const network::Network net(std::get<network::Definition>(request.payload), "candidate");
        network::State state = net.start();
        for (const double a : {-1.0, 0.0, 1.0}) {
            const Values inputs{a, 0.5};
            const double out = net.evaluate(inputs, state)[0];
            value -= (out - a * a) * (out - a * a);
        }
    }
    const std::uint64_t seed = scenario_seed(7, request.pool, request.generation, episode);
    return value + 0.2 * RandomStream(seed, "test", "noise").normal();
}

Score play_all(const Request& request) {
    std::vector<double> values;
    for (int i = 0; i < request.episodes; ++i) values.push_back(play(request, i));
    return score_of(values);
}

/// Plays rounds in the order born.
void play_rounds(Algorithm& algorithm, int rounds) {
    for (int i = 0; i < rounds && !algorithm.finished(); ++i) {
        for (const Request& r : algorithm.ask()) algorithm.tell(r.candidate, r.pool, play_all(r));
        algorithm.advance();
    }
}

class EveryAlgorithm : public ::testing::TestWithParam<Setup> {
  protected:
    Algorithm make() const { return Algorithm(GetParam().spec, GetParam().problem, 11); }
};

TEST_P(EveryAlgorithm, OrderOfResultsDoesNotMatter) {
    Algorithm plain = make();
    Algorithm shuffled = make();
    play_rounds(plain, 25);
    RandomStream order(3, "test", "order");
    for (int i = 0; i < 25; ++i) {
        std::vector<Request> open = shuffled.ask();
        while (!open.empty()) {
            const auto at = order.below(static_cast<int>(open.size()));
            const Request r = open[static_cast<std::size_t>(at)];
            open.erase(open.begin() + at);
            // First a part of the episodes, then all, then everything a second time.
            if (r.episodes > 2) {
                Request part = r;
                part.episodes = 2;
                shuffled.tell(r.candidate, r.pool, play_all(part));
            }
            EXPECT_TRUE(shuffled.tell(r.candidate, r.pool, play_all(r)));
            EXPECT_FALSE(shuffled.tell(r.candidate, r.pool, play_all(r)));
        }
        shuffled.advance();
    }
    EXPECT_EQ(shuffled.save().dump(), plain.save().dump());
}

TEST_P(EveryAlgorithm, ContinuesWithTheSameBitsFromAnyPoint) {
    Algorithm plain = make();
    Algorithm reloaded = make();
    for (int i = 0; i < 25; ++i) {
        const std::vector<Request> requests = plain.ask();
        for (std::size_t k = 0; k < requests.size(); ++k) {
            const Request& r = requests[k];
            plain.tell(r.candidate, r.pool, play_all(r));
            reloaded.tell(r.candidate, r.pool, play_all(r));
            if (k % 3 == 1) reloaded = Algorithm::restore_text(reloaded.save().dump(), "state");
        }
        plain.advance();
        reloaded.advance();
        reloaded = Algorithm::restore_text(reloaded.save().dump(1), "state");
        ASSERT_EQ(reloaded.ask(), plain.ask()) << "after round " << i;
    }
    EXPECT_EQ(reloaded.save().dump(), plain.save().dump());
    EXPECT_EQ(reloaded.champion(), plain.champion());
    EXPECT_GT(plain.generation(), 2);
}

TEST_P(EveryAlgorithm, IsAValue) {
    Algorithm first = make();
    play_rounds(first, 3);
    Algorithm second = first;
    play_rounds(first, 3);
    play_rounds(second, 3);
    EXPECT_EQ(first.save(), second.save());
    Algorithm other(GetParam().spec, GetParam().problem, 12);
    EXPECT_NE(make().ask(), other.ask()) << "the seed makes no difference";
}

TEST_P(EveryAlgorithm, FailedCandidatesRankLastAndNobodyIsNeeded) {
    Algorithm algorithm = make();
    for (int i = 0; i < 40; ++i) {
        const bool all_fail = i >= 35;
        for (const Request& r : algorithm.ask()) {
            if (all_fail || r.candidate % 3 == 0) {
                EXPECT_TRUE(algorithm.tell_failed(r.candidate, r.pool));
                EXPECT_FALSE(algorithm.tell_failed(r.candidate, r.pool));
                EXPECT_FALSE(algorithm.tell(r.candidate, r.pool, play_all(r)));
            } else {
                algorithm.tell(r.candidate, r.pool, play_all(r));
            }
        }
        algorithm.advance();
    }
    ASSERT_TRUE(algorithm.champion());
    EXPECT_NE(algorithm.champion()->candidate % 3, 0u);
}

TEST_P(EveryAlgorithm, TheChampionIsMeasuredOnValidationSeeds) {
    Algorithm algorithm = make();
    std::map<std::uint64_t, Score> validated;
    for (int i = 0; i < 40; ++i) {
        for (const Request& r : algorithm.ask()) {
            const Score score = play_all(r);
            if (r.pool == Pool::Validation) validated[r.candidate] = score;
            algorithm.tell(r.candidate, r.pool, score);
        }
        algorithm.advance();
    }
    ASSERT_TRUE(algorithm.champion());
    const Champion champion = *algorithm.champion();
    EXPECT_TRUE(champion.validated);
    EXPECT_EQ(champion.score, validated.at(champion.candidate));
    EXPECT_EQ(champion.score.n, 8);
    ASSERT_FALSE(algorithm.hall_of_fame().empty());
    EXPECT_EQ(algorithm.hall_of_fame().back(), champion);
    for (std::size_t i = 1; i < algorithm.hall_of_fame().size(); ++i) {
        EXPECT_LT(algorithm.hall_of_fame()[i - 1].score.mean, algorithm.hall_of_fame()[i].score.mean);
    }
    for (const auto& [candidate, score] : validated) {
        if (score.n < 8) continue;  // sent home by halving
        EXPECT_LE(score.mean, champion.score.mean) << candidate;
    }
}

TEST_P(EveryAlgorithm, EachGenerationLogsOneLine) {
    Algorithm algorithm = make();
    play_rounds(algorithm, 30);
    const auto lines = algorithm.take_log();
    ASSERT_EQ(static_cast<int>(lines.size()), algorithm.generation());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        EXPECT_EQ(lines[i]["generation"], i);
        EXPECT_LE(lines[i]["median"], lines[i]["best"]);
        EXPECT_GE(lines[i]["median"], lines[i]["worst"]);
    }
    EXPECT_TRUE(algorithm.take_log().empty());
    EXPECT_LE(lines.back()["episodes_told"], algorithm.episodes_told());
}

TEST_P(EveryAlgorithm, BadResultsAreRefusedWithTheirValue) {
    Algorithm algorithm = make();
    const auto error = [&](std::uint64_t candidate, const Score& score) -> std::string {
        try {
            algorithm.tell(candidate, Pool::Train, score);
        } catch (const AlgorithmError& e) {
            return e.what();
        }
        return "no error";
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const nlohmann::json before = algorithm.save();
    EXPECT_THAT(error(0, {nan, 0.0, 4}), HasSubstr("candidate 0: mean nan"));
    EXPECT_THAT(error(1, {std::numeric_limits<double>::infinity(), 0.0, 4}), HasSubstr("mean inf"));
    EXPECT_THAT(error(0, {1.0, nan, 4}), HasSubstr("standard error nan"));
    EXPECT_THAT(error(0, {1.0, -0.5, 4}), HasSubstr("standard error -0.5"));
    EXPECT_THAT(error(0, {1.0, 0.0, 0}), HasSubstr("covers 0 episodes"));
    EXPECT_THAT(error(0, {1.0, 0.0, 5}), HasSubstr("covers 5 episodes, wanted are 1 to 4"));
    EXPECT_THAT(error(999, {1.0, 0.0, 4}), HasSubstr("candidate 999, which was never asked"));
    EXPECT_THROW(algorithm.tell_failed(999, Pool::Train), AlgorithmError);
    EXPECT_EQ(algorithm.save(), before);
    EXPECT_THROW(algorithm.advance(), std::logic_error);
}

INSTANTIATE_TEST_SUITE_P(All, EveryAlgorithm, ::testing::ValuesIn(setups()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace k3d::optimizer::algorithm

// SPDX-License-Identifier: BSD-3-Clause
// How a run begins, spends its episodes and ends; what settings and states are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "optimizer/algorithm/functions.h"
#include "optimizer/algorithm/neat/tasks.h"

namespace k3d::optimizer::algorithm {
namespace {

using ::testing::HasSubstr;
using testing::Values;

std::string error_of(const spec::AlgorithmSpec& spec, const spec::Problem& problem) {
    try {
        Algorithm(spec, problem, 1);
    } catch (const AlgorithmError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Run, SettingsThatCannotBeAreNamed) {
    const auto with = [](auto change) {
        spec::AlgorithmSpec spec;
        change(spec);
        return error_of(spec, testing::box(3, 0.0, 1.0));
    };
    EXPECT_EQ(with([](auto&) {}), "no error");
    EXPECT_THAT(with([](auto& s) { s.name = "genetic"; }), HasSubstr("\"genetic\""));
    EXPECT_THAT(with([](auto& s) { s.sampling.episodes = 0; }), HasSubstr("sampling.episodes\" is 0"));
    EXPECT_THAT(with([](auto& s) { s.cmaes.population = 3; }), HasSubstr("cmaes.population is 3"));
    EXPECT_THAT(with([](auto& s) { s.cmaes.noise = "reevaluate"; }),
                HasSubstr("sampling.episodes is 1"));
    EXPECT_THAT(with([](auto& s) { s.target = std::numeric_limits<double>::quiet_NaN(); }),
                HasSubstr("target"));
    EXPECT_THAT(with([](auto& s) { s.name = "neat"; }), HasSubstr("not a list of parameters"));
    EXPECT_THAT(with([](auto& s) { s.name = "random_search", s.random_search.distribution = "uniform"; }),
                HasSubstr("parameter \"x0\" has bounds -inf to inf"));
    EXPECT_THAT(with([](auto& s) { s.name = "cross_entropy", s.cross_entropy.population = 6; }),
                HasSubstr("elite of 0.2 of a population of 6"));
    EXPECT_THAT(with([](auto& s) { s.cmaes.population = 100000; }), "no error");
    EXPECT_THAT(error_of({}, spec::VectorProblem{}), HasSubstr("no parameter to search"));
    spec::AlgorithmSpec neat;
    neat.name = "neat";
    EXPECT_THAT(error_of(neat, spec::NetworkProblem{}), HasSubstr("no inputs"));
    EXPECT_THAT(error_of({}, spec::NetworkProblem{testing::empty_network(3, 1)}),
                HasSubstr("not a network"));
}

TEST(Run, EndsAtItsLimits) {
    const auto reason = [](auto change) {
        spec::AlgorithmSpec spec;
        change(spec);
        Algorithm algorithm(spec, testing::box(4, 1.0, 1.0), 3);
        testing::minimise(algorithm, testing::sphere, -1.0, 1e5);
        EXPECT_TRUE(algorithm.ask().empty());
        EXPECT_TRUE(algorithm.settled());
        return algorithm.finished().value_or("goes on") + " " +
               std::to_string(algorithm.generation() + 1) + " " +
               std::to_string(algorithm.episodes_told());
    };
    EXPECT_EQ(reason([](auto& s) { s.max_generations = 7; }), "max_generations 7 56");
    EXPECT_EQ(reason([](auto& s) { s.max_episodes = 50; }), "max_episodes 7 56");
    EXPECT_THAT(reason([](auto& s) { s.target = -0.01; }), HasSubstr("target"));
    EXPECT_THAT(reason([](auto& s) { s.cmaes.tolerance_x = 1e-3, s.cmaes.tolerance_fitness = 0.0; }),
                HasSubstr("tolerance_x"));
}

TEST(Run, ValidatesWhatItHasWhenItIsToEnd) {
    spec::AlgorithmSpec spec;
    spec.sampling.validation_episodes = 5;
    spec.sampling.validate_every = 10;
    Algorithm algorithm(spec, testing::box(4, 1.0, 1.0), 3);
    int validated = 0;
    const auto play = [&] {
        for (const Request& r : algorithm.ask()) {
            validated += r.pool == Pool::Validation;
            const double value = -testing::sphere(std::get<Values>(r.payload));
            algorithm.tell(r.candidate, r.pool, {value, 0.0, r.episodes});
        }
        algorithm.advance();
    };
    while (algorithm.generation() == 0) play();
    validated = 0;
    play();
    ASSERT_EQ(algorithm.generation(), 2);
    ASSERT_EQ(validated, 0) << "no validation is due";
    algorithm.end_after_generation("enough");
    for (int i = 0; i < 5 && !algorithm.finished(); ++i) play();
    EXPECT_EQ(algorithm.finished(), "enough");
    EXPECT_EQ(algorithm.generation(), 2);
    EXPECT_GT(validated, 0);
    ASSERT_TRUE(algorithm.champion());
    EXPECT_TRUE(algorithm.champion()->validated);
}

/// 16 candidates, of which halving plays 8, 4 and 2 further 2, 4 and 8 times.
spec::AlgorithmSpec halving(int episodes) {
    spec::AlgorithmSpec spec;
    spec.name = "random_search";
    spec.random_search.population = 16;
    spec.sampling.episodes = episodes;
    spec.sampling.halving_episodes = 48;
    return spec;
}

/// With means that fall as more is played of a candidate: the first episodes flatter.
TEST(Run, WhomHalvingSentHomeIsNoFinalist) {
    spec::AlgorithmSpec spec = halving(2);
    spec.sampling.validation_episodes = 4;
    spec.sampling.finalists = 2;
    Algorithm algorithm(spec, testing::box(2, 1.0, 1.0), 3);
    std::map<std::uint64_t, int> played;
    while (algorithm.ask().front().pool == Pool::Train) {
        for (const Request& r : algorithm.ask()) {
            played[r.candidate] = r.episodes;
            algorithm.tell(r.candidate, r.pool, {1.0 / r.episodes, 0.0, r.episodes});
        }
        algorithm.advance();
    }
    std::vector<Request> finalists = algorithm.ask();
    ASSERT_EQ(finalists.size(), 3u);
    EXPECT_EQ(std::get<Values>(finalists.back().payload), (Values{1.0, 1.0})) << "the start";
    finalists.pop_back();
    for (const Request& r : finalists) EXPECT_EQ(played[r.candidate], 2 + 2 + 4 + 8);
}

/// Its weights have to be varied from a start to beat it; by luck in training many seem to.
TEST(Run, TheStartNetworkIsValidatedWithTheFirstFinalists) {
    network::Definition start = testing::empty_network(2, 1);
    start.links = {{"i0", "o0", 0.5, false}, {"i1", "o0", -0.5, false}};
    spec::AlgorithmSpec spec;
    spec.name = "neat";
    spec.neat.start = "network";
    spec.neat.population = 16;
    spec.sampling.validation_episodes = 4;
    spec.sampling.validate_every = 5;
    spec.sampling.finalists = 1;
    Algorithm algorithm(spec, spec::NetworkProblem{start}, 3);
    while (algorithm.generation() == 0) {
        for (const Request& r : algorithm.ask()) {
            const bool is_start = r.candidate == 0;
            const double mean = (r.pool == Pool::Validation) == is_start ? 2.0 : 1.0;
            algorithm.tell(r.candidate, r.pool, {mean, 0.0, r.episodes});
        }
        algorithm.advance();
    }
    ASSERT_TRUE(algorithm.champion());
    EXPECT_EQ(algorithm.champion()->candidate, 0u);
    EXPECT_EQ(algorithm.champion()->score.mean, 2.0);
}

TEST(Run, TheStartIsTheChampionIfNothingIsBetter) {
    for (const char* name : {"cmaes", "cross_entropy", "random_search"}) {
        spec::AlgorithmSpec spec;
        spec.name = name;
        spec.max_generations = 6;
        spec.sampling.validation_episodes = 4;
        spec.sampling.validate_every = 5;
        spec.sampling.finalists = 1;
        Algorithm algorithm(spec, testing::box(2, 1.0, 1.0), 3);
        const Values start{1.0, 1.0};
        while (!algorithm.finished()) {
            for (const Request& r : algorithm.ask()) {
                const double mean = std::get<Values>(r.payload) == start ? 2.0 : 1.0;
                algorithm.tell(r.candidate, r.pool, {mean, 0.0, r.episodes});
            }
            algorithm.advance();
        }
        ASSERT_TRUE(algorithm.champion()) << name;
        EXPECT_EQ(std::get<Values>(algorithm.champion()->payload), start) << name;
        EXPECT_EQ(algorithm.champion()->generation, 0) << name;
    }
}

TEST(Run, FlatFitnessNeitherEndsAtOnceNorCrashes) {
    for (const char* name : {"cmaes", "cross_entropy", "random_search"}) {
        spec::AlgorithmSpec spec;
        spec.name = name;
        Algorithm algorithm(spec, testing::box(4, 1.0, 1.0), 3);
        for (int i = 0; i < 15; ++i) {
            ASSERT_FALSE(algorithm.finished()) << name << " after " << i << " generations";
            for (const Request& r : algorithm.ask()) algorithm.tell(r.candidate, r.pool, {3.0, 0.0, 1});
            algorithm.advance();
        }
    }
}

TEST(Run, ValuesKeepToTheirKind) {
    for (const char* name : {"cmaes", "cross_entropy", "random_search"}) {
        spec::AlgorithmSpec spec;
        spec.name = name;
        spec.max_generations = 60;
        spec::VectorProblem problem = testing::box(4, 0.5, 1.0);
        problem[0].lower = 0.0;  // the optimum, at 0, is on the bound
        problem[0].upper = 2.0;
        problem[1].integer = true;
        problem[1].start = 40.0;
        problem[1].deviation = 5.0;
        problem[2].frozen = true;
        problem[3].upper = 0.5;
        Algorithm algorithm(spec, problem, 2);
        const testing::Run run = testing::minimise(
            algorithm,
            [name](const Values& x) {
                EXPECT_GE(x[0], 0.0) << name;
                EXPECT_LE(x[0], 2.0) << name;
                EXPECT_EQ(x[1], std::round(x[1])) << name;
                EXPECT_EQ(x[2], 0.5) << name;
                EXPECT_LE(x[3], 0.5) << name;
                const double miss = x[1] - 23.0;
                return x[0] * x[0] + 0.01 * miss * miss + (x[3] + 3.0) * (x[3] + 3.0);
            },
            -1.0, 1e5);
        EXPECT_LT(*std::min_element(run.best.begin(), run.best.end()), 0.8 * run.best.front()) << name;
        if (std::string(name) != "cmaes") continue;
        EXPECT_LT(*std::min_element(run.best.begin(), run.best.end()), 1e-2) << name;
        EXPECT_EQ(std::get<Values>(algorithm.champion()->payload)[1], 23.0) << name;
    }
}

TEST(Run, CmaesBeatsCrossEntropyBeatsRandomSearch) {
    std::vector<double> medians;
    for (const char* name : {"cmaes", "cross_entropy", "random_search"}) {
        std::vector<double> best;
        for (std::uint64_t seed = 1; seed <= 9; ++seed) {
            spec::AlgorithmSpec spec;
            spec.name = name;
            Algorithm algorithm(spec, testing::box(8, 1.0, 1.0), seed);
            const testing::Run run = testing::minimise(
                algorithm, [](const Values& x) { return testing::ellipsoid(x, 1e4); }, -1.0, 2000);
            best.push_back(*std::min_element(run.best.begin(), run.best.end()));
        }
        medians.push_back(testing::median(best));
    }
    EXPECT_LT(medians[0], 0.1 * medians[1]);
    EXPECT_LT(medians[1], 0.1 * medians[2]);
}

TEST(Run, HalvingPlaysTheBestMoreOften) {
    Algorithm algorithm(halving(4), testing::box(2, 0.0, 1.0), 1);
    std::map<std::uint64_t, int> episodes;
    while (algorithm.generation() == 0) {
        for (const Request& r : algorithm.ask()) {
            episodes[r.candidate] = r.episodes;
            algorithm.tell(r.candidate, r.pool, {static_cast<double>(r.candidate), 0.1, r.episodes});
        }
        algorithm.advance();
    }
    EXPECT_EQ(episodes.at(0), 4);
    EXPECT_EQ(episodes.at(7), 4);
    EXPECT_EQ(episodes.at(8), 4 + 2);               // 48 in three rounds: 16 among 8, ...
    EXPECT_EQ(episodes.at(12), 4 + 2 + 4);          // 16 among 4, ...
    EXPECT_EQ(episodes.at(15), 4 + 2 + 4 + 8);      // 16 among 2
    EXPECT_EQ(algorithm.episodes_told(), 16u * 4u + 48u);
}

TEST(Run, StatesThatCannotBeAreNamed) {
    spec::AlgorithmSpec spec;
    const Algorithm algorithm(spec, testing::box(3, 0.0, 1.0), 1);
    const nlohmann::json good = algorithm.save();
    const auto error = [&good](auto change) -> std::string {
        nlohmann::json state = good;
        change(state);
        try {
            Algorithm::restore(state, "run.json");
        } catch (const AlgorithmError& e) {
            return e.what();
        }
        return "no error";
    };
    EXPECT_EQ(error([](auto&) {}), "no error");
    EXPECT_THAT(error([](auto& s) { s["format"] = "pickle"; }), HasSubstr("run.json: format: is \"pickle\""));
    EXPECT_THAT(error([](auto& s) { s["version"] = 2; }), HasSubstr("version: is 2"));
    EXPECT_THAT(error([](auto& s) { s.erase("search"); }), HasSubstr("lacks \"search\""));
    EXPECT_THAT(error([](auto& s) { s["search"]["distribution"]["sigma"] = -1.0; }),
                HasSubstr("search.distribution.sigma: is not above 0"));
    EXPECT_THAT(error([](auto& s) { s["search"]["distribution"]["mean"].push_back(1.0); }),
                HasSubstr("search.distribution.mean: has 4 entries, 3 are needed"));
    EXPECT_THAT(error([](auto& s) { s["search"]["distribution"]["mean"][1] = "nan"; }),
                HasSubstr("search.distribution.mean[1]"));
    EXPECT_THAT(error([](auto& s) { s["entries"][2]["payload"] = {1.0, 2.0}; }),
                HasSubstr("entries[2].payload: has 2 entries, 3 are needed"));
    EXPECT_THAT(error([](auto& s) { s["entries"].erase(0); }), HasSubstr("6 candidates"));
    EXPECT_THAT(error([](auto& s) { s["entries"][0]["id"] = 5; }), HasSubstr("out of order"));
    EXPECT_THAT(error([](auto& s) { s["phase"] = "validation"; }), HasSubstr("nothing to validate"));
    EXPECT_THAT(error([](auto& s) {
                    s["spec"] = "[sampling]\nvalidation_episodes = 4\n";
                    s["phase"] = "validation";
                    s["entries"][0]["id"] = 5;
                }),
                HasSubstr("entries[5].id: is 5, which is out of order"));
    EXPECT_THAT(error([](auto& s) { s["phase"] = "test"; }), HasSubstr("\"test\""));
    EXPECT_THAT(error([](auto& s) { s["spec"] = "name = 3"; }), HasSubstr("run.json: spec"));
    EXPECT_THAT(error([](auto& s) { s["problem"]["parameters"][0]["deviation"] = 0.0; }),
                HasSubstr("run.json: parameter \"x0\": deviation 0"));
    try {
        Algorithm::restore_text("{\"format\": ", "run.json");
        FAIL() << "no error";
    } catch (const AlgorithmError& e) {
        EXPECT_THAT(e.what(), HasSubstr("run.json: not JSON"));
    }
}

}  // namespace
}  // namespace k3d::optimizer::algorithm

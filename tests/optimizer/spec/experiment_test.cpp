// SPDX-License-Identifier: BSD-3-Clause
// Experiments: what is read, and every kind of fault with its place.
#include "optimizer/spec/experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/config/config.h"
#include "optimizer/algorithm/algorithm.h"
#include "optimizer/spec/ask.h"

namespace k3d::optimizer::spec {
namespace {

using testing::HasSubstr;

const AgentFields& fields() {
    static const AgentFields all = parse_agent_fields(R"([
        {"path": "role", "type": "text", "value": "auto", "min": null, "max": null, "unit": "", "meaning": ""},
        {"path": "keeper.policy", "type": "text", "value": "", "min": null, "max": null, "unit": "", "meaning": ""},
        {"path": "keeper.hold", "type": "number", "value": 2.4, "min": 0, "max": 20, "unit": "m", "meaning": "x"},
        {"path": "motion.walk.step", "type": "number", "value": 0.03, "min": 0, "max": 0.1, "unit": "m", "meaning": "x"},
        {"path": "motion.walk.frames", "type": "integer", "value": 10, "min": 1, "max": 100, "unit": "", "meaning": "x"},
        {"path": "motion.kick.times", "type": "numbers", "value": [0.1, 0.2, 0.3], "min": 0.02, "max": 2, "unit": "s", "meaning": "x"}])");
    return all;
}

constexpr const char* kNetwork = R"({"format": "keepaway3d-network", "version": 1,
    "inputs": [{"name": "f1"}, {"name": "f2"}], "outputs": ["cost"],
    "nodes": [{"name": "cost", "activation": "linear", "bias": 0.25}],
    "links": [{"from": "f1", "to": "cost", "weight": 0.5}, {"from": "f2", "to": "cost", "weight": -1}]})";

std::string read(const std::string& name) {
    if (name == "net.json") return kNetwork;
    if (name == "bad.json") return "{}";
    throw std::runtime_error("cannot read " + name);
}

Experiment parse(const std::string& toml) {
    return parse_experiment(toml, "exp.toml", fields(), read);
}

std::string fault_of(const std::string& toml) {
    try {
        parse(toml);
    } catch (const config::ConfigError& error) {
        return error.what();
    }
    return "no fault";
}

constexpr const char* kHold = "name = \"a\"\n[parameters.keeper.hold]\nlower = 1\nupper = 5\n";

TEST(Experiment, ReadsParametersWithTheAgentsDefaults) {
    const Experiment e = parse(std::string(kHold) +
                               "[parameters.motion.walk.frames]\nlower = 5\nupper = 15\nstart = 7\n"
                               "deviation = 3\n[parameters.motion.walk.step]\nfrozen = true\n");
    ASSERT_EQ(e.parameters.size(), 3U);
    EXPECT_EQ(e.parameters[0], (Parameter{"keeper.hold", 2.4, 0.8, 1.0, 5.0, false, false}));
    EXPECT_TRUE(e.parameters[1].frozen);
    EXPECT_EQ(e.parameters[1].start, 0.03);
    EXPECT_EQ(e.parameters[2],
              (Parameter{"motion.walk.frames", 7.0, 3.0, 5.0, 15.0, true, false}));
    EXPECT_EQ(e.task.name, "keepaway");
}

TEST(Experiment, NamesFileLineAndValueOfEveryFault) {
    const std::vector<std::pair<std::string, std::string>> faults{
        {"name = \"a\"\n[parameters.keeper.hodl]\nlower = 1\n",
         "exp.toml:2: unknown key \"parameters.keeper.hodl\", the nearest known one is "
         "\"parameters.keeper.hold\""},
        {"name = \"a\"\n[parameters.keeper.hold]\nlower = 5\nupper = 1\n",
         "exp.toml:3: \"parameters.keeper.hold.lower\" is 5, which is not below upper, 1"},
        {"name = \"a\"\n[parameters.keeper.hold]\nlower = 1\nupper = 50\n",
         "exp.toml:4: \"parameters.keeper.hold.upper\" is 50, allowed is 0 to 20"},
        {"name = \"a\"\n[parameters.keeper.hold]\nlower = 1\n",
         "exp.toml:2: \"parameters.keeper.hold.upper\" is missing"},
        {"name = \"a\"\n[parameters.keeper.hold]\nlower = 3\nupper = 5\n",
         "exp.toml:2: \"parameters.keeper.hold.start\" is 2.4 (the agent's own value), outside 3 to 5"},
        {"name = \"a\"\n[parameters.keeper.hold]\nlower = nan\nupper = 5\n",
         "exp.toml:3: \"parameters.keeper.hold.lower\" is not finite"},
        {"name = \"a\"\n[parameters.keeper.hold]\nlower = 1\nupper = 5\ndeviation = 0\n",
         "exp.toml:5: \"parameters.keeper.hold.deviation\" is 0, wanted is more than 0"},
        {"name = \"a\"\n[parameters.motion.walk.frames]\nlower = 1.5\nupper = 15\n",
         "exp.toml:2: \"parameters.motion.walk.frames\" is whole, but lower, upper or start is not"},
        {"name = \"a\"\n[parameters.motion.walk.frames]\nlower = 1\nupper = 15\ninteger = false\n",
         "exp.toml:5: \"parameters.motion.walk.frames.integer\" is false, but the setting takes"},
        {"name = \"a/b\"\n[parameters.keeper.hold]\nlower = 1\nupper = 5\n",
         "exp.toml:1: \"name\" is \"a/b\", wanted are letters, digits, _ - ."},
        {"name = \"a\"\n", "exp.toml:1: \"parameters\" names nothing that is to be tuned"},
        {"name = \"a\"\n[parameters.keeper.hold]\nfrozen = true\n",
         "exp.toml:2: \"parameters\" names nothing that is to be tuned"},
        {std::string(kHold) + "[task]\nname = \"juggle\"\n", "exp.toml:6: \"task.name\" is \"juggle\""},
        {std::string(kHold) + "[task]\nfitness = \"atempts\"\n",
         "exp.toml:6: \"task.fitness\" is \"atempts\", but a result of keepaway has attempts, "
         "falls, hold_time_s, kicks, passes_completed, side_m;"},
        {std::string(kHold) + "[task]\nname = \"kick\"\nworst = -1\nfitness = \"speed_mps\"\n",
         "exp.toml:8: \"task.fitness\" is \"speed_mps\", but a result of kick has attempts, "},
        {std::string(kHold) + "[task]\nname = \"possession\"\n",
         "exp.toml:5: \"task.worst\" is missing"},
        {std::string(kHold) + "[task]\nfitness = \"-falls\"\n",
         "exp.toml:5: \"task.worst\" is missing"},
        {std::string(kHold) + "[task]\nsettings = \"side=3\"\n",
         "exp.toml:6: \"task.settings\" is no list of settings: setting 'side=3'"},
        {std::string(kHold) + "[algorithm]\nname = \"neat\"\n",
         "exp.toml:6: \"algorithm.name\" is neat, which needs a [network]"},
        {std::string(kHold) + "[network]\npath = \"keeper.policy\"\nstart = \"net.json\"\n",
         "exp.toml:2: \"parameters\" stands beside [network]"},
        {"name = \"a\"\n[network]\npath = \"keeper.hold\"\nstart = \"net.json\"\n",
         "exp.toml:3: \"network.path\" is \"keeper.hold\", which is no text among"},
        {"name = \"a\"\n[network]\npath = \"keeper.policy\"\nstart = \"no.json\"\n",
         "exp.toml:4: \"network.start\" is \"no.json\": cannot read no.json"},
        {"name = \"a\"\n[network]\npath = \"keeper.policy\"\nstart = \"bad.json\"\n",
         "exp.toml:4: \"network.start\" is \"bad.json\": bad.json"},
        {"name = ", "exp.toml:1: "},
    };
    for (const auto& [toml, fault] : faults) EXPECT_THAT(fault_of(toml), HasSubstr(fault)) << toml;
}

TEST(Experiment, NamesWhatNobodyWouldRead) {
    const std::vector<std::pair<std::string, std::string>> faults{
        {std::string(kHold) + "[task]\nname = \"kick\"\nworst = -1\ndrill = \"setup.wlak_m=3\"\n",
         "exp.toml:8: \"task.drill\" is no list of a drill's settings: unknown key "
         "\"setup.wlak_m\""},
        {std::string(kHold) + "[algorithm.neat]\npopulation = 77\n",
         "exp.toml:5: \"algorithm.neat\" is of another algorithm than algorithm.name, \"cmaes\""},
        {std::string(kHold) + "[network]\nbound = 3.0\n",
         "exp.toml:5: \"network.path\" is missing"},
        {std::string(kHold) + "[task]\nname = \"kick\"\nworst = -1\nlobby_s = 9\n",
         "exp.toml:8: \"task.lobby_s\" is for keepaway, but the task is kick"},
        {std::string(kHold) + "[task]\ntuned = \"taker\"\n",
         "exp.toml:5: \"task.fitness\" is missing: takers want \"-hold_time_s\""},
        {std::string(kHold) + "[task]\ntuned = \"agent\"\ntaker_command = \"a {port}\"\n",
         "exp.toml:6: \"task.tuned\" is \"agent\", but task.taker_command takes no settings"},
    };
    for (const auto& [toml, fault] : faults) EXPECT_THAT(fault_of(toml), HasSubstr(fault)) << toml;
}

TEST(Experiment, ElementsOfAListAreTunedWithinIt) {
    const Experiment e = parse(
        "name = \"a\"\n[parameters.motion.kick.times.1]\nlower = 0.1\nupper = 0.9\n"
        "[parameters.motion.walk.frames]\nlower = 5\nupper = 15\n");
    ASSERT_EQ(e.parameters.size(), 2U);
    EXPECT_EQ(e.parameters[1].name, "motion.kick.times.1");
    EXPECT_EQ(e.parameters[1].start, 0.2);
    using Pairs = std::vector<std::pair<std::string, std::string>>;
    EXPECT_EQ(settings_of(e, {7.0, 0.5}), (Pairs{{"motion.walk.frames", "7"},
                                                 {"motion.kick.times", "[0.1, 0.5, 0.3]"}}));
    EXPECT_THAT(fault_of("name = \"a\"\n[parameters.motion.kick.times.3]\nlower = 0.1\n"),
                HasSubstr("exp.toml:2: unknown key \"parameters.motion.kick.times.3\""));
}

TEST(Experiment, AFailedEpisodeOfKeepawayCountsNothing) {
    EXPECT_EQ(parse(kHold).task.worst, 0.0);
    EXPECT_EQ(parse(std::string(kHold) + "[task]\nfitness = \"attempts\"\n").task.worst, 0.0);
}

TEST(Experiment, AFigureMayBeMinimised) {
    EXPECT_EQ(parse(std::string(kHold) + "[task]\nworst = -9\nfitness = \"-falls\"\n").task.fitness,
              "-falls");
}

TEST(Experiment, AParameterMayBeAddedBesideTheFile) {
    const Overrides step{"parameters.motion.walk.step.lower=0.01",
                         "parameters.motion.walk.step.upper=0.05"};
    const Experiment e = parse_experiment(kHold, "exp.toml", fields(), read, step);
    ASSERT_EQ(e.parameters.size(), 2U);
    EXPECT_EQ(e.parameters[1].name, "motion.walk.step");
    EXPECT_THROW(parse_experiment(kHold, "exp.toml", fields(), read, {step[0]}), config::ConfigError)
        << "upper is missing";
}

TEST(Experiment, AnotherAlgorithmMayBeTriedBesideTheFile) {
    const std::string toml = std::string(kHold) + "[algorithm.cmaes]\npopulation = 8\n";
    const auto with = [&](const Overrides& overrides) {
        return parse_experiment(toml, "exp.toml", fields(), read, overrides).algorithm.name;
    };
    EXPECT_EQ(with({"algorithm.name=random_search", "algorithm.random_search.population=9"}),
              "random_search");
    EXPECT_THROW(with({"algorithm.random_search.population=9"}), config::ConfigError);
    EXPECT_THROW(with({"algorithm.name=random_search", "algorithm.cmaes.population=9"}),
                 config::ConfigError);
}

TEST(Experiment, TellsAllFaultsAtOnce) {
    const std::string said = fault_of(
        "name = \"\"\n[parameters.keeper.hold]\nlower = 5\nupper = 1\n"
        "[parameters.motion.walk.step]\nlower = 0.01\n");
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 2) << said;
}

TEST(Experiment, AVectorAlgorithmTunesTheWeightsOfANetwork) {
    const Experiment e =
        parse("name = \"a\"\n[network]\npath = \"keeper.policy\"\nstart = \"net.json\"\nbound = 3\n");
    const auto problem = std::get<VectorProblem>(problem_of(e));
    ASSERT_EQ(problem.size(), 3U);
    EXPECT_EQ(problem[0], (Parameter{"f1>cost", 0.5, 1.0, -3.0, 3.0, false, false}));
    EXPECT_EQ(problem[2].name, "bias cost");
    const network::Definition net = with_weights(*e.start_network, {1.0, 2.0, 3.0});
    EXPECT_EQ(net.links[1].weight, 2.0);
    EXPECT_EQ(net.nodes[0].bias, 3.0);
}

TEST(Experiment, NeatGetsTheNetworkItself) {
    const Experiment e = parse(
        "name = \"a\"\n[algorithm]\nname = \"neat\"\n[network]\npath = \"keeper.policy\"\n"
        "start = \"net.json\"\n");
    EXPECT_EQ(std::get<NetworkProblem>(problem_of(e)).start, *e.start_network);
}

TEST(Experiment, ThoseInTheTreeAreSound) {
    const AgentFields real = ask_agent_fields(K3D_BIN_DIR "/k3d-agent");
    const std::string folder = K3D_SOURCE_DIR "/optimizer/experiments";
    const auto content = [&](const std::string& name) {
        std::ostringstream text;
        text << std::ifstream(folder + "/" + name).rdbuf();
        return text.str();
    };
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml") continue;
        const std::string file = entry.path().filename().string();
        const Experiment e = parse_experiment(content(file), file, real, content);
        EXPECT_EQ(e.name + ".toml", file);
        EXPECT_NO_THROW(algorithm::Algorithm(e.algorithm, problem_of(e), e.seed)) << file;
        EXPECT_NO_THROW(require_taken(file, e.task, parse_settings(test_settings(e))));
        ++count;
    }
    EXPECT_GE(count, 10);
}

TEST(Experiment, LearnedNetworksTakeWhatTheirSearchStartedFrom) {
    const std::filesystem::path folder = K3D_SOURCE_DIR "/optimizer/experiments";
    const auto inputs_of = [](const network::Definition& net) {
        std::vector<std::string_view> names;
        for (const network::Input& input : net.inputs) names.push_back(input.name);
        return names;
    };
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "results")) {
        if (entry.path().extension() != ".json") continue;
        const std::string file = entry.path().filename().string();  // SEARCH-RUN.json
        const std::string search = file.substr(0, file.rfind('-'));
        std::ifstream in(folder / (search + ".toml"));
        const std::string toml{std::istreambuf_iterator<char>(in), {}};
        const auto start_file = config::text_at(toml, "network.start");
        ASSERT_TRUE(start_file) << file;
        const auto start = network::load_file(folder / *start_file);
        const network::Network learned(network::load_file(entry.path()), file);
        const std::vector<std::string_view> outputs(start.outputs.begin(), start.outputs.end());
        EXPECT_NO_THROW(network::require_shape(learned, inputs_of(start), outputs, file));
        ++count;
    }
    EXPECT_GE(count, 1);
}

TEST(Experiment, TheStartOfBothIsTheStartsOfEach) {
    const std::string folder = K3D_SOURCE_DIR "/optimizer/experiments/networks/";
    const network::Definition targets = network::load_file(folder + "evaluation_linear.json");
    const network::Definition places = network::load_file(folder + "open_linear.json");
    std::vector<network::Link> links = targets.links;
    for (network::Link link : places.links) {
        link.to = "place";
        links.push_back(link);
    }
    const network::Definition both = network::load_file(folder + "getopen_linear.json");
    EXPECT_EQ(both.inputs, places.inputs);
    EXPECT_EQ(both.links, links);
}

RC_GTEST_PROP(Experiment, AnyDamageIsReadOrNamed, ()) {
    std::string toml = std::string(kHold) + "[task]\nkeepers = 3\n[algorithm]\nname = \"cmaes\"\n";
    const auto count = *rc::gen::inRange(1, 6);
    for (int i = 0; i < count; ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, toml.size());
        toml[at] = static_cast<char>(*rc::gen::inRange(1, 256));
    }
    const std::string said = fault_of(toml);
    RC_ASSERT(said == "no fault" || said.rfind("exp.toml", 0) == 0);
}

}  // namespace
}  // namespace k3d::optimizer::spec

// SPDX-License-Identifier: BSD-3-Clause
// Tests of common/network: hand-computed values, file round trip, and what bad files say.
#include "common/network/network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace k3d::network {
namespace {

using testing::HasSubstr;

Definition small() {
    Definition d;
    d.description = "two inputs, one hidden node";
    d.inputs = {{"a", 1.0, 2.0}, {"b", 0.0, 1.0}};
    d.outputs = {"out"};
    d.nodes = {{"out", Activation::Linear, 0.25}, {"h", Activation::Relu, -1.0}};
    d.links = {{"a", "h", 3.0, false}, {"h", "out", 0.5, false}, {"b", "out", -1.0, false}};
    return d;
}

std::string error_of(const std::string& json) {
    try {
        parse(json, "net.json");
    } catch (const NetworkError& error) {
        return error.what();
    }
    return "no error";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Network, EvaluatesByHandWhateverTheOrderOfNodes) {
    const Network network(small(), "test");
    State state = network.start();
    // a = (2 - 1) * 2 = 2; h = relu(3 * 2 - 1) = 5; out = 0.25 + 2.5 - 0.75 = 2.
    const std::vector<double> inputs{2.0, 0.75};
    EXPECT_DOUBLE_EQ(network.evaluate(inputs, state)[0], 2.0);
    const std::vector<double> off{1.0, 0.0};  // h = relu(-1) = 0
    EXPECT_DOUBLE_EQ(network.evaluate(off, state)[0], 0.25);
}

TEST(Network, RecurrentLinkReadsTheValueBefore) {
    Definition d;
    d.inputs = {{"x"}};
    d.outputs = {"sum"};
    d.nodes = {{"sum", Activation::Linear, 0.0}};
    d.links = {{"x", "sum", 1.0, false}, {"sum", "sum", 0.5, true}};
    const Network network(d, "test");
    State state = network.start();
    const std::vector<double> one{1.0};
    EXPECT_DOUBLE_EQ(network.evaluate(one, state)[0], 1.0);
    EXPECT_DOUBLE_EQ(network.evaluate(one, state)[0], 1.5);
    EXPECT_DOUBLE_EQ(network.evaluate(one, state)[0], 1.75);
    State fresh = network.start();
    EXPECT_DOUBLE_EQ(network.evaluate(one, fresh)[0], 1.0);
}

TEST(Network, Activations) {
    const std::pair<Activation, double> expected[] = {
        {Activation::Linear, 0.5},
        {Activation::Sigmoid, 1.0 / (1.0 + std::exp(-2.45))},
        {Activation::Tanh, std::tanh(0.5)},
        {Activation::Relu, 0.5},
        {Activation::Gauss, std::exp(-0.25)},
        {Activation::Sine, std::sin(0.5)},
    };
    for (const auto& [activation, value] : expected) {
        Definition d;
        d.inputs = {{"x"}};
        d.outputs = {"y"};
        d.nodes = {{"y", activation, 0.0}};
        d.links = {{"x", "y", 1.0, false}};
        const Network network(d, "test");
        State state = network.start();
        const std::vector<double> half{0.5};
        EXPECT_DOUBLE_EQ(network.evaluate(half, state)[0], value);
    }
}

TEST(Network, HugeWeightsStayFinite) {
    Definition d = small();
    for (Link& link : d.links) link.weight = 1e300;
    const Network network(d, "test");
    State state = network.start();
    const std::vector<double> inputs{1e200, 1e200};
    EXPECT_TRUE(std::isfinite(network.evaluate(inputs, state)[0]));
}

TEST(NetworkFile, RoundTripIsExact) {
    Definition d = small();
    d.links[0].weight = 0.1 + 0.2;
    d.links.push_back({"out", "h", -1.0 / 3.0, true});
    EXPECT_EQ(parse(to_json(d), "net.json"), d);
}

TEST(NetworkFile, LoadsFromDiskAndNamesAMissingFile) {
    const auto path = std::filesystem::path(testing::TempDir()) /
                      ("k3d_network_test_" + std::to_string(getpid()) + ".json");
    std::ofstream(path) << to_json(small());
    EXPECT_EQ(load_file(path.string()), small());
    std::filesystem::remove(path);
    try {
        load_file(path.string());
        FAIL() << "no error";
    } catch (const NetworkError& error) {
        EXPECT_THAT(error.what(), HasSubstr(path.string()));
        EXPECT_THAT(error.what(), HasSubstr("No such file"));
    }
}

TEST(NetworkFile, BadFilesSayWhatIsWrong) {
    const std::string good = to_json(small());
    ASSERT_EQ(error_of(good), "no error");
    EXPECT_THAT(error_of("{"), HasSubstr("net.json: not JSON"));
    EXPECT_THAT(error_of("[]"), HasSubstr("not an object"));
    EXPECT_THAT(error_of(replaced(good, "keepaway3d-network", "onnx")), HasSubstr("\"onnx\""));
    EXPECT_THAT(error_of(replaced(good, "\"version\": 1", "\"version\": 7")), HasSubstr("version is 7"));
    EXPECT_THAT(error_of(replaced(good, "\"relu\"", "\"rely\"")), HasSubstr("\"rely\""));
    EXPECT_THAT(error_of(replaced(good, "\"weight\": 3.0", "\"weight\": \"x\"")),
                HasSubstr("\"weight\" of link 1"));
    EXPECT_THAT(error_of(replaced(good, "\"weight\": 3.0", "\"wait\": 3.0")), HasSubstr("\"wait\""));
    EXPECT_THAT(error_of(replaced(good, "\"from\": \"a\"", "\"from\": \"z\"")), HasSubstr("\"z\""));
    EXPECT_THAT(error_of(replaced(good, "\"name\": \"h\"", "\"name\": \"a\"")), HasSubstr("twice"));
    EXPECT_THAT(error_of(replaced(good, "\"to\": \"h\"", "\"to\": \"b\"")), HasSubstr("ends in an input"));
    EXPECT_THAT(error_of(replaced(good, "\"links\"", "\"lines\"")), HasSubstr("\"lines\""));
    EXPECT_THAT(error_of(replaced(good, "\"weight\": 3.0", "\"weight\": 1e999")), HasSubstr("net.json"));
}

TEST(NetworkFile, CycleIsNamed) {
    Definition d = small();
    d.links.push_back({"out", "h", 1.0, false});
    EXPECT_THAT(error_of(to_json(d)), HasSubstr("cycle"));
}

RC_GTEST_PROP(NetworkFile, AnyDamageIsNamedOrReadAndEvaluatedToNumbers, ()) {
    std::string text = to_json(small());
    const auto count = *rc::gen::inRange(1, 6);
    for (int i = 0; i < count; ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        switch (*rc::gen::inRange(0, 3)) {
            case 0: text[at] = static_cast<char>(*rc::gen::inRange(1, 256)); break;
            case 1: text.erase(at, *rc::gen::inRange<std::size_t>(1, 40)); break;
            default: text.insert(at, text.substr(*rc::gen::inRange<std::size_t>(0, text.size()), 30));
        }
        if (text.empty()) text = " ";
    }
    const std::string said = error_of(text);
    RC_ASSERT(said == "no error" || said.rfind("net.json", 0) == 0);
    if (said != "no error") return;
    const Definition read = parse(text, "net.json");
    RC_ASSERT(parse(to_json(read), "net.json") == read);
    const Network network(read, "net.json");
    State state = network.start();
    for (const double value : network.evaluate(std::vector<double>(read.inputs.size(), 0.7), state)) {
        RC_ASSERT(std::isfinite(value));
    }
}

TEST(Network, ShapeIsChecked) {
    const Network network(small(), "net.json");
    const std::string_view right[] = {"a", "b"};
    const std::string_view wrong[] = {"a", "c"};
    const std::string_view one[] = {"any name"};
    const std::string_view two[] = {"out", "other"};
    EXPECT_NO_THROW(require_shape(network, right, one, "net.json"));
    EXPECT_THROW(require_shape(network, wrong, one, "net.json"), NetworkError);
    EXPECT_THROW(require_shape(network, right, two, "net.json"), NetworkError);
    EXPECT_THROW(require_shape(network, {right, 1}, one, "net.json"), NetworkError);
}

TEST(Network, OutputsAreToldApartByTheirNames) {
    Definition d = small();
    d.nodes.push_back({"other"});
    d.outputs = {"other", "out"};
    const std::string_view inputs[] = {"a", "b"};
    const std::string_view same[] = {"other", "out"};
    const std::string_view swapped[] = {"out", "other"};
    const Network network(d, "net.json");
    EXPECT_NO_THROW(require_shape(network, inputs, same, "net.json"));
    EXPECT_THAT(
        [&] { require_shape(network, inputs, swapped, "net.json"); },
        testing::ThrowsMessage<NetworkError>("net.json: output 1 is \"other\", expected \"out\""));
}

}  // namespace
}  // namespace k3d::network

// SPDX-License-Identifier: BSD-3-Clause
// Checks a network definition, orders its nodes and evaluates it.
#include "common/network/network.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "common/log/log.h"

namespace k3d::network {
namespace {

constexpr double kLargest = 1e30;

double activate(Activation activation, double x) {
    switch (activation) {
        case Activation::Linear: return x;
        case Activation::Sigmoid: return 1.0 / (1.0 + std::exp(-4.9 * x));
        case Activation::Tanh: return std::tanh(x);
        case Activation::Relu: return std::max(x, 0.0);
        case Activation::Gauss: return std::exp(-x * x);
        case Activation::Sine: return std::sin(x);
    }
    return x;
}

[[noreturn]] void fail(std::string_view source, const std::string& what) {
    throw NetworkError(fmt::format("{}: {}", source, what));
}

void require_finite(double value, std::string_view source, const std::string& where) {
    if (!std::isfinite(value)) fail(source, fmt::format("{} is not a finite number", where));
}

using Slots = std::map<std::string, std::size_t, std::less<>>;

/// Slot of every name: inputs first, then nodes.
Slots number_names(const Definition& d, std::string_view source) {
    Slots slots;
    const auto add = [&](const std::string& name) {
        if (name.empty()) fail(source, "an input or node has an empty name");
        if (!slots.emplace(name, slots.size()).second)
            fail(source, fmt::format("the name \"{}\" is used twice", name));
    };
    if (d.inputs.empty()) fail(source, "no inputs");
    if (d.outputs.empty()) fail(source, "no outputs");
    for (const Input& input : d.inputs) {
        add(input.name);
        require_finite(input.offset, source, fmt::format("offset of input \"{}\"", input.name));
        require_finite(input.scale, source, fmt::format("scale of input \"{}\"", input.name));
    }
    for (const Node& node : d.nodes) {
        add(node.name);
        require_finite(node.bias, source, fmt::format("bias of node \"{}\"", node.name));
    }
    return slots;
}

std::size_t slot_of(const Slots& slots, const std::string& name, std::string_view source,
                    std::string_view use) {
    const auto found = slots.find(name);
    if (found == slots.end())
        fail(source, fmt::format("{} names \"{}\", which is neither input nor node", use, name));
    return found->second;
}

}  // namespace

Network::Network(Definition definition, std::string_view source)
    : definition_(std::move(definition)) {
    const Slots slots = number_names(definition_, source);
    const std::size_t first_node = definition_.inputs.size();
    std::vector<Step> nodes;
    for (const Node& node : definition_.nodes)
        nodes.push_back({first_node + nodes.size(), node.activation, node.bias, {}});

    for (const Link& link : definition_.links) {
        const std::size_t from = slot_of(slots, link.from, source, "a link");
        const std::size_t to = slot_of(slots, link.to, source, "a link");
        const std::string where = fmt::format("link \"{}\" -> \"{}\"", link.from, link.to);
        if (to < first_node) fail(source, fmt::format("{} ends in an input", where));
        require_finite(link.weight, source, fmt::format("weight of {}", where));
        nodes[to - first_node].edges.push_back({from, link.weight, link.recurrent});
    }
    for (const std::string& name : definition_.outputs) {
        const std::size_t slot = slot_of(slots, name, source, "outputs");
        if (slot < first_node) fail(source, fmt::format("output \"{}\" is an input", name));
        outputs_.push_back(slot);
    }

    // Repeatedly take the first node whose sources are done: stable, and finds cycles.
    std::vector<bool> done(first_node + nodes.size(), false);
    std::fill_n(done.begin(), first_node, true);
    while (steps_.size() < nodes.size()) {
        const auto ready = std::find_if(nodes.begin(), nodes.end(), [&](const Step& step) {
            return !done[step.slot] &&
                   std::all_of(step.edges.begin(), step.edges.end(),
                               [&](const Edge& e) { return e.recurrent || done[e.from]; });
        });
        if (ready == nodes.end()) {
            const auto stuck = std::find(done.begin(), done.end(), false);
            const auto node = static_cast<std::size_t>(stuck - done.begin()) - first_node;
            fail(source, fmt::format("links that are not recurrent form a cycle at or before node \"{}\"",
                                     definition_.nodes[node].name));
        }
        done[ready->slot] = true;
        steps_.push_back(*ready);
    }
}

State Network::start() const {
    State state;
    start(state);
    return state;
}

void Network::start(State& state) const {
    state.values.assign(definition_.inputs.size() + definition_.nodes.size(), 0.0);
}

std::vector<double> Network::evaluate(std::span<const double> inputs, State& state) const {
    std::vector<double> results(outputs_.size());
    evaluate(inputs, state, results);
    return results;
}

void Network::evaluate(std::span<const double> inputs, State& state,
                       std::span<double> outputs) const {
    K3D_ASSERT(outputs.size() == outputs_.size());
    K3D_ASSERT(inputs.size() == definition_.inputs.size());
    K3D_ASSERT(state.values.size() == definition_.inputs.size() + definition_.nodes.size());
    state.before = state.values;
    const std::vector<double>& before = state.before;
    std::vector<double>& values = state.values;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        values[i] = (inputs[i] - definition_.inputs[i].offset) * definition_.inputs[i].scale;
    for (const Step& step : steps_) {
        double sum = step.bias;
        for (const Edge& edge : step.edges)
            sum += edge.weight * (edge.recurrent ? before[edge.from] : values[edge.from]);
        // The order makes a not-a-number (infinity minus infinity) end as the lower bound.
        sum = std::min(kLargest, std::max(-kLargest, sum));
        values[step.slot] = activate(step.activation, sum);
    }
    for (std::size_t i = 0; i < outputs_.size(); ++i) outputs[i] = values[outputs_[i]];
}

void require_shape(const Network& network, std::span<const std::string_view> inputs,
                   std::span<const std::string_view> outputs, std::string_view source) {
    const Definition& d = network.definition();
    const auto differs = [source](std::string_view what, std::size_t i, std::string_view got,
                                  std::string_view expected) {
        fail(source, fmt::format("{} {} is \"{}\", expected \"{}\"", what, i + 1, got, expected));
    };
    if (d.inputs.size() != inputs.size())
        fail(source, fmt::format("has {} inputs, {} are needed", d.inputs.size(), inputs.size()));
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (d.inputs[i].name != inputs[i]) differs("input", i, d.inputs[i].name, inputs[i]);
    if (d.outputs.size() != outputs.size())
        fail(source,
             fmt::format("has {} outputs, {} are needed", d.outputs.size(), outputs.size()));
    if (outputs.size() == 1) return;  // there is nothing to take it for
    for (std::size_t i = 0; i < outputs.size(); ++i)
        if (d.outputs[i] != outputs[i]) differs("output", i, d.outputs[i], outputs[i]);
}

}  // namespace k3d::network

// SPDX-License-Identifier: BSD-3-Clause
// Neural networks as values: a definition that is read from and written to JSON, and its
// evaluation. Policies use them; the optimiser grows them.
//
// File format, version 1 (paper 4.1 and 5.3 need nothing more):
//   {"format": "keepaway3d-network", "version": 1, "description": "any text",
//    "inputs":  [{"name": "f1", "offset": 0, "scale": 1}, ...],        the network sees (x - offset) * scale
//    "outputs": ["cost"],                                               names of nodes
//    "nodes":   [{"name": "cost", "activation": "linear", "bias": 0}],  outputs and hidden nodes
//    "links":   [{"from": "f1", "to": "cost", "weight": 0.5, "recurrent": false}]}
// description, offset, scale, bias and recurrent may be left out. Links that are not recurrent must
// form no cycle; a recurrent link carries the value its source had in the evaluation before.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace k3d::network {

/// What is wrong with a network, with the source (file) and the offending value.
class NetworkError : public std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// sigmoid: 1 / (1 + exp(-4.9 x)), the slope that the NEAT papers use; gauss: exp(-x^2).
enum class Activation { Linear, Sigmoid, Tanh, Relu, Gauss, Sine };
/// As files and settings write it: "linear", "sigmoid", ...
std::string_view name_of(Activation activation);
/// None if `name` is none of them.
std::optional<Activation> activation_named(std::string_view name);

struct Input {
    std::string name;
    double offset = 0.0;
    double scale = 1.0;
    bool operator==(const Input&) const = default;
};

struct Node {
    std::string name;
    Activation activation = Activation::Sigmoid;
    double bias = 0.0;
    bool operator==(const Node&) const = default;
};

struct Link {
    std::string from;  ///< input or node
    std::string to;    ///< node
    double weight = 0.0;
    bool recurrent = false;
    bool operator==(const Link&) const = default;
};

struct Definition {
    std::string description;
    std::vector<Input> inputs;
    std::vector<std::string> outputs;
    std::vector<Node> nodes;
    std::vector<Link> links;
    bool operator==(const Definition&) const = default;
};

/// `source` names the text in error messages. Throws NetworkError.
Definition parse(std::string_view json, std::string_view source);
/// Throws NetworkError, also if the file is missing or longer than 16 MiB.
Definition load_file(const std::string& path);
/// Doubles are written so that parse() gives the same bits again.
std::string to_json(const Definition& definition);

/// Values of all nodes in the evaluation before; what recurrent links read.
struct State {
    std::vector<double> values;
    std::vector<double> before;  ///< of no meaning between evaluations: kept for its memory
};

/// A checked definition, ready to evaluate. Immutable.
class Network {
  public:
    /// Throws NetworkError for unknown or doubled names, cycles, numbers that are not finite.
    Network(Definition definition, std::string_view source);

    const Definition& definition() const { return definition_; }
    State start() const;  ///< all values 0
    void start(State& state) const;  ///< the same in the memory of another one

    /// One value per output, in the order of the definition.
    /// `inputs` has one value per input; aborts otherwise (check definition() where the network
    /// is loaded). A value that overflows is clamped to +-1e30, so results are always finite for
    /// finite inputs.
    std::vector<double> evaluate(std::span<const double> inputs, State& state) const;
    /// The same into `outputs`, one element per output, without taking memory.
    void evaluate(std::span<const double> inputs, State& state, std::span<double> outputs) const;

  private:
    struct Edge {
        std::size_t from;
        double weight;
        bool recurrent;
    };
    struct Step {
        std::size_t slot;
        Activation activation;
        double bias;
        std::vector<Edge> edges;
    };
    Definition definition_;
    std::vector<Step> steps_;             // in an order in which sources come first
    std::vector<std::size_t> outputs_;    // slots; inputs first, then nodes in definition order
};

/// Checks that the network takes exactly these inputs and gives exactly these outputs, in this
/// order; an output that is the only one may have any name. Throws NetworkError that names `source`
/// and the difference.
void require_shape(const Network& network, std::span<const std::string_view> inputs,
                   std::span<const std::string_view> outputs, std::string_view source);

}  // namespace k3d::network

// SPDX-License-Identifier: BSD-3-Clause
// Complex behaviours (paper 4.1): a state machine over actions whose transitions a chooser makes,
// be it a network or hand-written code. (invoke, abort, get_skill, action_map, state, next_state).
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/log/log.h"
#include "common/network/network.h"

namespace k3d::agent::decision {

/// One entry of an action map: a primitive action (one state, nothing to set up or to end) or a
/// whole complex behaviour seen from outside.
template <class Input, class Output>
struct Action {
    std::string name;
    std::function<Output(const Input&)> get_skill;
    std::function<void()> invoke{};  ///< empty: nothing to set up
    std::function<void()> abort{};   ///< empty: nothing to end
};

/// Picks the next state, 0 .. n-1, from what is known and the present state.
template <class Input>
using Chooser = std::function<int(const Input&, int state)>;

/// The chooser of Algorithm 1: the output of the network with the largest value, the first of
/// equals. `features(input)` gives the network's inputs, an array or a vector; the network needs
/// one output per state.
template <class Input, class Features>
Chooser<Input> network_chooser(network::Network net, Features features) {
    struct Shared {
        network::Network net;
        network::State state;
        std::vector<double> values;
    };
    const std::size_t outputs = net.definition().outputs.size();
    auto shared = std::make_shared<Shared>(
        Shared{net, net.start(), std::vector<double>(outputs, 0.0)});
    return [shared, features = std::move(features)](const Input& input, int) {
        shared->net.evaluate(features(input), shared->state, shared->values);
        const std::vector<double>& values = shared->values;
        std::size_t best = 0;
        for (std::size_t i = 1; i < values.size(); ++i)
            if (values[i] > values[best]) best = i;
        return static_cast<int>(best);
    };
}

template <class Input, class Output>
class ComplexBehaviour {
  public:
    /// States are the indices of `action_map`; `initial` is set by invoke(), `after_abort` by
    /// abort(). Aborts the program if either is none of them.
    ComplexBehaviour(std::vector<Action<Input, Output>> action_map, Chooser<Input> choose,
                     int initial = 0, int after_abort = 0)
        : action_map_(std::move(action_map)),
          choose_(std::move(choose)),
          initial_(initial),
          after_abort_(after_abort),
          state_(initial),
          next_state_(initial) {
        K3D_ASSERT(is_state(initial) && is_state(after_abort));
    }

    /// Starts from the initial state.
    void invoke() {
        state_ = next_state_ = initial_;
        run(action(state_).invoke);
    }

    /// Ends whatever goes on.
    void abort() {
        run(action(state_).abort);
        state_ = next_state_ = after_abort_;
    }

    /// Algorithm 1, line by line: the state changes one call after it was chosen, so that the old
    /// action is aborted and the new one invoked before it is first asked for a skill.
    Output get_skill(const Input& input) {
        state_ = next_state_;
        next_state_ = choose_(input, state_);
        K3D_ASSERT(is_state(next_state_));
        if (state_ != next_state_) {
            run(action(state_).abort);
            run(action(next_state_).invoke);
        }
        return action(state_).get_skill(input);
    }

    int state() const { return state_; }
    int next_state() const { return next_state_; }
    const std::string& state_name() const {
        return action_map_[static_cast<std::size_t>(state_)].name;
    }

    /// This behaviour as an entry of another one's action map. It must outlive that one.
    Action<Input, Output> as_action(std::string name) {
        return {std::move(name), [this](const Input& input) { return get_skill(input); },
                [this] { invoke(); }, [this] { abort(); }};
    }

  private:
    static void run(const std::function<void()>& procedure) {
        if (procedure) procedure();
    }
    bool is_state(int state) const {
        return state >= 0 && state < static_cast<int>(action_map_.size());
    }
    Action<Input, Output>& action(int state) {
        return action_map_[static_cast<std::size_t>(state)];
    }

    std::vector<Action<Input, Output>> action_map_;
    Chooser<Input> choose_;
    int initial_;
    int after_abort_;
    int state_;
    int next_state_;
};

}  // namespace k3d::agent::decision

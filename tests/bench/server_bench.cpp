// SPDX-License-Identifier: BSD-3-Clause
// Cycles a second of a real server with N simple clients over real sockets, each of which moves all
// joints in every cycle, so that nothing sleeps.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/nao/model.h"
#include "common/net/net.h"
#include "common/process/child.h"
#include "common/wire/commands.h"

namespace k3d::bench {
namespace {

using namespace std::chrono_literals;

class Crowd {
  public:
    /// The match begins, and everybody is waited for, when the last of them has a seat.
    Crowd(int agents, const char* stepper)
        : server_({{std::string(K3D_BIN_DIR) + "/k3d-server", "--agent-port", "0", "--server-port",
                    "0", "--pace", "fast", "--log-level", "error", "--set",
                    "soccer.type_quotas=false", "--set",
                    fmt::format("pace.lobby_left={}", (agents + 1) / 2), "--set",
                    fmt::format("pace.lobby_right={}", agents / 2), "--set",
                    std::string("physics.stepper=") + stepper},
                   "/dev/null",
                   true}) {
        const auto port =
            static_cast<std::uint16_t>(std::stoi(server_.wait_ready(30s).at("agent")));
        for (int k = 0; k < agents; ++k) join(port, k);
        for (int k = 0; k < 50; ++k) step();
    }

    pid_t server() const { return server_.pid(); }

    void step() {
        out_.clear();
        wire::Commands commands;
        for (const nao::JointDef& joint : nao::model(0).joints) {
            commands.joint_rates[nao::index(joint.id)] = 0.5 * std::sin(0.1 * cycle_);
        }
        commands.syn = true;
        wire::encode(commands, out_);
        for (auto& client : clients_) client->send(out_);
        for (auto& client : clients_) receive(*client);
        ++cycle_;
    }

  private:
    void join(std::uint16_t port, int k) {
        net::Client& client =
            *clients_.emplace_back(std::make_unique<net::Client>("127.0.0.1", port, 30s));
        client.send("(scene rsg/agent/nao/nao.rsg)(syn)");
        receive(client);
        client.send(fmt::format("(init (unum {})(teamname {}))(syn)", k / 2 + 1,
                                k % 2 == 0 ? "Reds" : "Blues"));
        receive(client);
    }

    void receive(net::Client& client) {
        std::string_view payload;
        if (!client.receive(payload, 30s)) throw std::runtime_error("the server ended");
    }

    process::Child server_;
    std::vector<std::unique_ptr<net::Client>> clients_;
    std::string out_;
    int cycle_ = 0;
};

/// Processor time of a process so far, s: unlike the wall's it says the same on a busy machine.
double processor_seconds(pid_t pid) {
    std::ifstream file(fmt::format("/proc/{}/stat", pid));
    std::string text;
    std::getline(file, text);
    std::istringstream fields(text.substr(text.rfind(')') + 2));  // from the third one on
    std::string skipped;
    for (int i = 3; i < 14; ++i) fields >> skipped;
    double user = 0.0, system = 0.0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Cycles by the wall, clients included, and processor time of the server's part of one.
void count(benchmark::State& state, double cycles, double processor) {
    state.counters["cycles/s"] = benchmark::Counter(cycles, benchmark::Counter::kIsRate);
    state.counters["server_us"] = 1e6 * processor / cycles;
}

void server_cycle(benchmark::State& state, const char* stepper) {
    Crowd crowd(static_cast<int>(state.range(0)), stepper);
    const double before = processor_seconds(crowd.server());
    for (auto _ : state) crowd.step();
    count(state, static_cast<double>(state.iterations()),
          processor_seconds(crowd.server()) - before);
}
BENCHMARK_CAPTURE(server_cycle, exact, "exact")
    ->Arg(1)->Arg(5)->Arg(11)->Arg(22)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(server_cycle, fast, "fast")
    ->Arg(1)->Arg(5)->Arg(11)->Arg(22)->UseRealTime()->Unit(benchmark::kMicrosecond);

/// Nobody plays: a server alone, by a trainer in its barrier.
void server_cycle_empty(benchmark::State& state) {
    process::Child server({{std::string(K3D_BIN_DIR) + "/k3d-server", "--agent-port", "0",
                            "--server-port", "0", "--pace", "fast", "--log-level", "error"},
                           "/dev/null",
                           true});
    const auto ready = server.wait_ready(30s);
    net::Client trainer("127.0.0.1", static_cast<std::uint16_t>(std::stoi(ready.at("monitor"))),
                        30s);
    std::string_view payload;
    trainer.send("(syn)");
    trainer.receive(payload, 30s);
    const double before = processor_seconds(server.pid());
    for (auto _ : state) {
        trainer.send("(syn)");
        trainer.receive(payload, 30s);
    }
    // The monitor port is served every second cycle.
    count(state, 2.0 * static_cast<double>(state.iterations()),
          processor_seconds(server.pid()) - before);
}
BENCHMARK(server_cycle_empty)->UseRealTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace k3d::bench

// SPDX-License-Identifier: BSD-3-Clause
// What an experiment costs beyond its episodes: processor time of the daemon, of a worker and of
// nats-server against that of the episodes' own processes, on this machine's pool and by way of NATS;
// and how many rows the ledger takes a second. Episodes use the fast stepper: none are cheaper.
// usage: overhead_bench [EXPERIMENT [EPISODES-OF-A-CANDIDATE]]
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "integration/nats_process.h"
#include "optimizer/ledger/ledger.h"

namespace {

using namespace k3d;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// Processor time so far, s.
struct Used {
    double itself = 0.0;
    double children = 0.0;  ///< that have ended
};

Used used_by(pid_t pid) {
    std::ifstream file(fmt::format("/proc/{}/stat", pid));
    std::string text;
    std::getline(file, text);
    std::istringstream fields(text.substr(text.rfind(')') + 2));  // from the third one on
    std::string skipped;
    for (int i = 3; i < 14; ++i) fields >> skipped;
    double user = 0.0, system = 0.0, child_user = 0.0, child_system = 0.0;
    fields >> user >> system >> child_user >> child_system;
    const auto tick = static_cast<double>(::sysconf(_SC_CLK_TCK));
    return {(user + system) / tick, (child_user + child_system) / tick};
}

class Bench {
  public:
    Bench(std::string experiment, int episodes)
        : experiment_(std::move(experiment)),
          episodes_(episodes),
          folder_(std::filesystem::temp_directory_path() /
                  fmt::format("k3d-overhead-{}", ::getpid())) {
        std::filesystem::create_directories(folder_);
    }
    ~Bench() { std::filesystem::remove_all(folder_); }

    void local() {
        process::Child daemon = start_daemon("local", {"--jobs", "1"});
        const Used used = follow(daemon, nullptr, nullptr);
        print("local", used.itself, 0.0, 0.0, used.children);
    }

    void nats() {
        testing::NatsProcess server(folder_ / "nats-files");
        process::Child worker({{program(), "worker", "--nats", server.url(), "--jobs", "1"},
                               folder_ / "worker.log",
                               false});
        process::Child daemon = start_daemon("nats", {"--nats", server.url()});
        Used at_worker;
        double at_server = 0.0;
        const Used used = follow(daemon, &worker, &at_worker, server.pid(), &at_server);
        print("nats", used.itself, at_worker.itself, at_server, at_worker.children);
    }

    void rows() const {
        constexpr int kRows = 2000;
        optimizer::ledger::Ledger ledger =
            optimizer::ledger::Ledger::create(folder_ / "rows.sqlite", {{"name", "rows"}});
        optimizer::ledger::Row row;
        row.seed = 77;
        row.status = "finished";
        row.result = std::string(900, 'x');  // as long as the line of five players
        const auto begin = Clock::now();
        const std::clock_t worked = std::clock();
        for (row.key.episode = 0; row.key.episode < kRows; ++row.key.episode) ledger.add({row});
        const std::chrono::duration<double> took = Clock::now() - begin;
        std::printf("ledger: %.0f rows a second, a transaction each (%.0f a processor second)\n",
                    kRows / took.count(),
                    kRows * static_cast<double>(CLOCKS_PER_SEC) /
                        static_cast<double>(std::clock() - worked));
        std::fflush(stdout);
    }

  private:
    static std::string program() { return std::string(K3D_BIN_DIR) + "/k3d-optimizer"; }

    process::Child start_daemon(const std::string& name, const std::vector<std::string>& carrier) {
        run_ = folder_ / name;
        std::vector<std::string> words{program(), "run", experiment_, "--run", run_.string()};
        words.insert(words.end(), carrier.begin(), carrier.end());
        for (const std::string& setting :
             {std::string("algorithm.max_generations=2"),
              fmt::format("algorithm.sampling.episodes={}", episodes_),
              std::string("algorithm.sampling.validation_episodes=2"),
              std::string("algorithm.cmaes.population=4"), std::string("test.episodes=2"),
              std::string("task.settings=server:physics.stepper=fast")}) {
            words.insert(words.end(), {"--set", setting});
        }
        return process::Child({words, folder_ / (name + ".log"), false});
    }

    /// Until the daemon's end; its processor time as last seen, a twentieth of a second before or less.
    Used follow(process::Child& daemon, process::Child* worker, Used* at_worker, pid_t server = 0,
                double* at_server = nullptr) {
        Used used;
        const pid_t pid = daemon.pid();
        while (true) {
            const Used now = used_by(pid);
            if (now.itself >= used.itself) used = now;
            if (worker != nullptr) {
                *at_worker = used_by(worker->pid());
                *at_server = used_by(server).itself;
            }
            const auto exit = daemon.wait(50ms);
            if (!exit) continue;
            if (exit->code != 0) throw std::runtime_error("the run failed: " + exit->text());
            return used;
        }
    }

    void print(const char* backend, double daemon, double worker, double server, double episodes) {
        const auto ledger = optimizer::ledger::Ledger::open(run_ / "ledger.sqlite",
                                                            optimizer::ledger::Ledger::Access::Read);
        const auto totals = ledger.totals();
        std::printf("%-6s %8llu %13.1f %13.1f %9.2f %9.2f %11.2f %11.2f %% %11.2f %%\n", backend,
                    static_cast<unsigned long long>(totals.episodes), totals.simulated_s, episodes,
                    daemon, worker, server, 100.0 * (daemon + worker + server) / episodes,
                    100.0 * (daemon + worker + server) / totals.wall_s);
        std::fflush(stdout);
    }

    std::string experiment_;
    int episodes_;
    std::filesystem::path folder_;
    std::filesystem::path run_;
};

}  // namespace

int main(int argc, char** argv) {
    const std::string experiment =
        argc > 1 ? argv[1] : std::string(K3D_SOURCE_DIR) + "/optimizer/experiments/keepaway_cmaes.toml";
    const int episodes = argc > 2 ? std::atoi(argv[2]) : 4;
    if (argc > 3 || episodes < 1) {
        std::fprintf(stderr, "usage: overhead_bench [EXPERIMENT [EPISODES-OF-A-CANDIDATE]]\n");
        return 2;
    }
    try {
        Bench bench(experiment, episodes);
        bench.rows();
        std::printf("\nprocessor seconds of an experiment, one episode at a time; overhead: daemon, worker\n"
                    "and nats-server against the episodes' processor time and against their wall time\n"
                    "       episodes  simulated s  episodes' s    daemon    worker nats-server  of processor   of wall\n");
        bench.local();
        bench.nats();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "overhead_bench: %s\n", error.what());
        return 1;
    }
    return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/bench.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "common/clock/clock.h"
#include "common/clock/stage_clock.h"
#include "common/log/log.h"
#include "common/math/sample.h"
#include "optimizer/backend/wakeups.h"
#include "optimizer/episode/episode.h"
#include "optimizer/spec/words.h"

namespace k3d::optimizer {

namespace {

constexpr std::array<const char*, 2> kSteppers{"exact", "fast"};
/// An episode this short is nearly all start and end.
constexpr double kShortest_s = 1.0;

/// What one episode cost.
struct Cost {
    double simulated_s = 0.0;
    double cpu_s = 0.0;         ///< of all processes
    double server_s = 0.0;      ///< of the server
    std::array<double, kStageNames.size()> stage_s{};

    double speed() const { return simulated_s / cpu_s; }
    double per_cycle_us(double seconds) const { return 1e6 * seconds * kCycleSeconds / simulated_s; }
    double staged_s() const {
        double sum = 0.0;
        for (const double s : stage_s) sum += s;
        return sum;
    }
};

/// CPU seconds of the children that have ended.
double children_s() {
    rusage used{};
    ::getrusage(RUSAGE_CHILDREN, &used);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

class Bench {
  public:
    explicit Bench(const BenchSettings& settings)
        : settings_(settings), folder_(std::filesystem::temp_directory_path() /
                                       fmt::format("k3d-bench-{}", ::getpid())) {}
    ~Bench() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    Cost play(const std::string& stepper, std::uint64_t seed, double limit_s) {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        const std::string stages = (folder_ / "stages.json").string();
        spec::MatchSpec spec;
        spec.keepers = settings_.keepers;
        spec.takers = settings_.takers;
        for (const std::string& word :
             {"server:physics.stepper=" + stepper, "server:stage_times=" + stages,
              fmt::format("server:keepaway.limit={}", limit_s)}) {
            spec.settings += (spec.settings.empty() ? "" : " ") + spec::quote_word(word);
        }
        spec::check(spec);
        const double before = children_s();
        run({0, seed, 1}, spec);
        Cost cost;
        cost.cpu_s = children_s() - before;
        std::ifstream file(stages);
        const auto json = nlohmann::json::parse(file);
        cost.simulated_s = json.at("cycles").get<double>() * kCycleSeconds;
        cost.server_s = json.at("process_s").get<double>();
        for (std::size_t k = 0; k < kStageNames.size(); ++k) {
            cost.stage_s[k] = json.at(std::string(kStageNames[k]) + "_s").get<double>();
        }
        return cost;
    }

  private:
    void run(const episode::Task& task, const spec::MatchSpec& spec) {
        episode::Episode episode(spec, task, folder_.string(), -1);
        for (;;) {
            if (const auto ending = episode.poll()) {
                if (*ending) return;
                throw std::runtime_error("seed " + std::to_string(task.seed) + ": " +
                                         ending->error().reason);
            }
            wakeups_.wait(episode.next_look());
            if (wakeups_.stop_wanted()) throw std::runtime_error("stopped");
        }
    }

    BenchSettings settings_;
    std::filesystem::path folder_;
    backend::Wakeups wakeups_;
};

using Costs = std::vector<Cost>;

template <class Figure>
std::string row(const std::string& name, const std::array<Costs, kSteppers.size()>& costs,
                int decimals, const Figure& figure) {
    std::string line = fmt::format("{:<28}", name);
    std::array<double, kSteppers.size()> value{};
    for (std::size_t s = 0; s < kSteppers.size(); ++s) {
        std::vector<double> sample;
        for (const Cost& cost : costs[s]) sample.push_back(figure(cost));
        value[s] = k3d::quantile(sample, 0.5);
        line += fmt::format("{:>10.{}f}", value[s], decimals);
    }
    return line + (value[0] > 0.0 ? fmt::format("{:>10.2f}\n", value[1] / value[0]) : "\n");
}

std::string table(const BenchSettings& settings, const std::array<Costs, kSteppers.size()>& played,
                  const std::array<Costs, kSteppers.size()>& shortest) {
    std::string text = fmt::format(
        "{} keepers against {} takers, {} episodes a stepper, seeds {} to {}, medians\n"
        "{:<28}{:>10}{:>10}{:>10}\n",
        settings.keepers, settings.takers, settings.episodes, settings.seed,
        settings.seed + static_cast<std::uint64_t>(settings.episodes) - 1, "", kSteppers[0],
        kSteppers[1], "ratio");
    text += row("simulated s per core-s", played, 2, [](const Cost& c) { return c.speed(); });
    text += row("CPU us per cycle", played, 1,
                [](const Cost& c) { return c.per_cycle_us(c.cpu_s); });
    for (std::size_t k = 0; k < kStageNames.size(); ++k) {
        text += row("  server, " + std::string(kStageNames[k]), played, 1,
                    [k](const Cost& c) { return c.per_cycle_us(c.stage_s[k]); });
    }
    text += row("  server, start and rest", played, 1,
                [](const Cost& c) { return c.per_cycle_us(c.server_s - c.staged_s()); });
    text += row(fmt::format("  {} agents, start included", settings.keepers + settings.takers),
                played, 1, [](const Cost& c) { return c.per_cycle_us(c.cpu_s - c.server_s); });
    text += row(fmt::format("CPU ms, episode of {:.0f} s", kShortest_s), shortest, 1,
                [](const Cost& c) { return 1e3 * c.cpu_s; });
    return text;
}

}  // namespace

std::string bench(const BenchSettings& settings) {
    Bench player(settings);
    std::array<Costs, kSteppers.size()> played, shortest;
    for (int k = 0; k < settings.episodes; ++k) {
        const std::uint64_t seed = settings.seed + static_cast<std::uint64_t>(k);
        for (std::size_t s = 0; s < kSteppers.size(); ++s) {
            played[s].push_back(player.play(kSteppers[s], seed, settings.limit_s));
            shortest[s].push_back(player.play(kSteppers[s], seed, kShortest_s));
            spdlog::info("{}, seed {}: {:.2f} simulated s per core-s", kSteppers[s], seed,
                         played[s].back().speed());
        }
    }
    return table(settings, played, shortest);
}

}  // namespace k3d::optimizer

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/cmaes/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/log/log.h"
#include "optimizer/algorithm/matrix_json.h"
#include "optimizer/algorithm/seeds.h"

namespace k3d::optimizer::algorithm::cmaes {
namespace {

constexpr double kMoreEpisodes = 1.5;   // factor while noise hides the ranks
constexpr double kFewerEpisodes = 0.9;  // factor after a generation that needed no more

constexpr double kMostNumbers = 4e6;    // of one generation, or in a covariance: 32 MB

void check_size(int dimension, int population, const std::string& covariance) {
    const double n = dimension;
    if (n * population > kMostNumbers) {
        throw AlgorithmError(fmt::format("cmaes: a population of {} with {} parameters is too large",
                                         population, dimension));
    }
    if (covariance == "full" && n * n > kMostNumbers) {
        throw AlgorithmError(fmt::format(
            "cmaes: a full covariance of {} parameters is too large; separable takes them", dimension));
    }
}

/// Best and worst of the fitness values are equal, down to the quarter that selection looks at most.
bool is_flat(const std::vector<Outcome>& outcomes, const std::vector<std::size_t>& order) {
    const Outcome& best = outcomes[order.front()];
    const Outcome& other = outcomes[order[(order.size() + 3) / 4]];
    return best.failed || (!other.failed && best.score.mean == other.score.mean);
}

}  // namespace

Search::Search(const spec::AlgorithmSpec& spec, Coordinates space, std::uint64_t seed,
               double budget)
    : spec_(spec.cmaes),
      least_episodes_(spec.sampling.episodes),
      space_(std::move(space)),
      seed_(seed),
      budget_(budget),
      episodes_(spec.sampling.episodes) {
    const int population =
        spec_.population > 0 ? spec_.population : default_population(space_.dimension());
    if (population < 4) {
        throw AlgorithmError(fmt::format("cmaes.population is {}, at least 4 are needed", population));
    }
    if (spec_.noise == "reevaluate" && least_episodes_ < 2) {
        throw AlgorithmError(
            fmt::format("cmaes.noise is \"reevaluate\", which needs standard errors, but "
                        "sampling.episodes is {}; at least 2 are needed", least_episodes_));
    }
    if (spec_.noise == "reevaluate" && spec_.max_episodes < least_episodes_) {
        throw AlgorithmError(fmt::format("cmaes.max_episodes is {}, less than sampling.episodes, {}",
                                         spec_.max_episodes, least_episodes_));
    }
    check_size(space_.dimension(), population, spec_.covariance);
    restarts_.first_population = population;
    open({population, 1.0, false, 0.0}, space_.start());
}

void Search::open(const Attempt& attempt, const Eigen::VectorXd& mean) {
    attempt_ = attempt;
    attempts_ += 1;
    used_ = 0.0;
    constants_ = constants(space_.dimension(), attempt.population, spec_.active,
                           spec_.covariance == "separable");
    distribution_ = start(constants_, mean, attempt.sigma);
    history_ = {};
    steps_ = Eigen::MatrixXd::Zero(constants_.n, constants_.population);  // until begin()
    factors_ = Eigen::VectorXd::Ones(constants_.n);
}

/// Ends the attempt: another one begins, or the search is over.
void Search::close(const std::string& reason) {
    count(restarts_, attempt_, used_);
    last_end_ = reason;
    RandomStream stream(seed_, fmt::format("attempt {}", attempts_), "cmaes.restart");
    const double remaining = budget_ - restarts_.used_large - restarts_.used_small;
    const auto next = next_attempt(spec_, restarts_, remaining, stream);
    const double most = kMostNumbers / space_.dimension();
    if (next && next->population <= most) {
        open(*next, space_.random_start(stream));
    } else {
        stopped_ = reason;
    }
}

void Search::begin(int generation) {
    RandomStream stream(seed_, fmt::format("generation {}", generation), "cmaes.sample");
    factors_ = step_factors(constants_, distribution_, space_.least_deviation());
    steps_ = draw_steps(constants_, distribution_, stream);
}

std::vector<double> Search::values(std::size_t candidate) const {
    const auto column = static_cast<Eigen::Index>(candidate);
    K3D_ASSERT(column < steps_.cols());
    return space_.values(distribution_.mean +
                         distribution_.sigma * factors_.cwiseProduct(steps_.col(column)));
}

std::vector<double> Search::centre() const { return space_.values(distribution_.mean); }

int Search::episodes_wanted(const std::vector<Outcome>& outcomes) const {
    int played = least_episodes_;
    for (const Outcome& outcome : outcomes) {
        if (!outcome.failed) played = std::max(played, outcome.score.n);
    }
    if (spec_.noise == "none" || reliability(outcomes) >= spec_.reliability) return played;
    return std::min(spec_.max_episodes, static_cast<int>(std::ceil(kMoreEpisodes * played)));
}

void Search::meet_noise(const std::vector<Outcome>& outcomes) {
    if (spec_.noise == "none") return;
    int played = least_episodes_;
    for (const Outcome& outcome : outcomes) {
        if (!outcome.failed) played = std::max(played, outcome.score.n);
    }
    const bool enough = reliability(outcomes) >= spec_.reliability;
    if (!enough) distribution_.sigma *= 1.0 + 2.0 / (constants_.n + 10.0);
    // What one generation needed the next one plays from the start, less a little each time.
    episodes_ = played > episodes_ ? played : static_cast<int>(std::floor(kFewerEpisodes * played));
    episodes_ = std::clamp(episodes_, least_episodes_, spec_.max_episodes);
}

void Search::update(const std::vector<Outcome>& outcomes) {
    K3D_ASSERT(outcomes.size() == size());
    const std::vector<std::size_t> order = ranking(outcomes);
    Eigen::MatrixXd ranked(steps_.rows(), steps_.cols());
    for (std::size_t i = 0; i < order.size(); ++i) {
        ranked.col(static_cast<Eigen::Index>(i)) = steps_.col(static_cast<Eigen::Index>(order[i]));
    }
    used_ += constants_.population;
    const auto good = static_cast<std::size_t>(
        std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return !o.failed; }));
    double range = 0.0;
    if (good == 0) {
        // Nothing is known of anybody: look elsewhere with the same distribution.
        distribution_.generation += 1;
    } else {
        cmaes::update(constants_, distribution_, ranked, factors_);
        if (is_flat(outcomes, order)) {
            distribution_.sigma *= std::exp(0.2 + constants_.c_sigma / constants_.d_sigma);
        }
        const double best = outcomes[order.front()].score.mean;
        range = best - outcomes[order[good - 1]].score.mean;
        remember(history_, constants_, best, outcomes[order[good / 2]].score.mean);
    }
    meet_noise(outcomes);
    const StopRules rules{spec_.tolerance_x, spec_.tolerance_fitness, attempt_.sigma};
    auto reason = reason_to_stop(constants_, distribution_, rules, history_, range);
    if (!reason && attempt_.candidates > 0.0 && used_ >= attempt_.candidates) reason = "budget";
    if (reason) close(*reason);
}

void Search::report(nlohmann::json& line) const {
    line["sigma"] = exact(distribution_.sigma);
    line["axis_ratio"] = exact(distribution_.lengths.maxCoeff() / distribution_.lengths.minCoeff());
    line["population"] = constants_.population;
    line["attempt"] = attempts_;
    line["episodes_per_candidate"] = episodes_;
    if (!last_end_.empty()) line["last_attempt_ended_by"] = last_end_;
    line["mean_values"] = exact(centre());
    const Eigen::VectorXd spread = distribution_.sigma * deviations(constants_, distribution_);
    line["deviations"] = exact(std::vector<double>(spread.data(), spread.data() + spread.size()));
}

nlohmann::json Search::save() const {
    return {{"attempt", cmaes::save(attempt_)},
            {"attempts", attempts_},
            {"restarts", cmaes::save(restarts_)},
            {"distribution", cmaes::save(distribution_)},
            {"history", cmaes::save(history_)},
            {"used", exact(used_)},
            {"episodes", episodes_},
            {"steps", exact_matrix(steps_)},
            {"factors", exact_matrix(factors_)},
            {"stopped", stopped_ ? nlohmann::json(*stopped_) : nlohmann::json()},
            {"last_end", last_end_}};
}

void Search::load(const Reader& reader) {
    attempt_ = read_attempt(reader["attempt"]);
    check_size(space_.dimension(), attempt_.population, spec_.covariance);
    attempts_ = reader["attempts"].integer(1, 1000000000);
    restarts_ = read_restarts(reader["restarts"]);
    constants_ = constants(space_.dimension(), attempt_.population, spec_.active,
                           spec_.covariance == "separable");
    distribution_ = read_distribution(reader["distribution"], constants_);
    history_ = read_history(reader["history"]);
    used_ = reader["used"].finite();
    episodes_ = reader["episodes"].integer(least_episodes_, kMaxEpisodes);
    steps_ = read_matrix(reader["steps"], constants_.n, constants_.population);
    factors_ = read_matrix(reader["factors"], constants_.n, 1);
    if (!reader["stopped"].is_null()) stopped_ = reader["stopped"].text();
    last_end_ = reader["last_end"].text();
}

}  // namespace k3d::optimizer::algorithm::cmaes

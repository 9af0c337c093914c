// SPDX-License-Identifier: BSD-3-Clause
// CMA-ES over the parameters of a problem: attempts one after another, each a distribution that is
// sampled and updated generation by generation. Paper: distribution.h, restarts.h.
//
// Noise ("reevaluate"): while less than `reliability` of the spread of fitness within a generation is
// more than noise, all its candidates are played more often; where that is not allowed any more the
// steps grow instead, so that noise cannot make them shrink. The idea, with ranks instead of
// standard errors, is N. Hansen et al., IEEE Trans. Evolutionary Computation 13(1), 2009.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimizer/algorithm/cmaes/distribution.h"
#include "optimizer/algorithm/cmaes/restarts.h"
#include "optimizer/algorithm/cmaes/stop.h"
#include "optimizer/algorithm/coordinates.h"
#include "optimizer/algorithm/score.h"

namespace k3d::optimizer::algorithm::cmaes {

class Search {
  public:
    /// `budget`: candidates the run may play in all; infinite if there is no limit.
    Search(const spec::AlgorithmSpec& spec, Coordinates space, std::uint64_t seed, double budget);

    void begin(int generation);
    std::size_t size() const { return static_cast<std::size_t>(constants_.population); }
    std::vector<double> values(std::size_t candidate) const;
    std::vector<double> centre() const;  ///< the mean: the estimator of the optimum under noise
    int episodes() const { return episodes_; }  ///< per candidate, at a generation's start
    /// Episodes per candidate, in all, that the ranks need; not above what was played: enough.
    int episodes_wanted(const std::vector<Outcome>& outcomes) const;
    void update(const std::vector<Outcome>& outcomes);
    std::optional<std::string> stopped() const { return stopped_; }
    void report(nlohmann::json& line) const;
    nlohmann::json save() const;
    void load(const Reader& reader);  ///< may leave the object unusable if it throws

  private:
    void open(const Attempt& attempt, const Eigen::VectorXd& mean);
    void close(const std::string& reason);
    void meet_noise(const std::vector<Outcome>& outcomes);

    spec::CmaesSpec spec_;
    int least_episodes_;
    Coordinates space_;
    std::uint64_t seed_;
    double budget_;

    Constants constants_;
    Distribution distribution_;
    History history_;
    Attempt attempt_;
    Restarts restarts_;
    int attempts_ = 0;           ///< begun so far
    double used_ = 0.0;          ///< candidates of this attempt
    int episodes_ = 1;           ///< per candidate
    Eigen::MatrixXd steps_;      ///< of the generation under evaluation, by columns
    Eigen::VectorXd factors_;
    std::optional<std::string> stopped_;
    std::string last_end_;       ///< why the attempt before ended
};

}  // namespace k3d::optimizer::algorithm::cmaes

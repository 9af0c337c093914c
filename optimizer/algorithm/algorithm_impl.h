// SPDX-License-Identifier: BSD-3-Clause
// The state behind Algorithm. Private to algorithm.cpp and algorithm_json.cpp.
//
// A generation passes through rounds: training episodes of all, then more of them where the search or
// sequential halving wants them; the search learns from these alone. Then, where fitness is noisy,
// the best and the search's own estimate meet on validation seeds, and the winner challenges the
// champion, who was measured on the same ones.
#pragma once

#include <vector>

#include "optimizer/algorithm/generation.h"
#include "optimizer/algorithm/halving.h"
#include "optimizer/algorithm/search.h"

namespace k3d::optimizer::algorithm {

struct Algorithm::Impl {
    Impl(const spec::AlgorithmSpec& spec, const spec::Problem& problem, std::uint64_t seed);

    spec::AlgorithmSpec spec;
    spec::Problem problem;
    std::uint64_t seed;
    Search search;

    int generation = 0;
    Pool phase = Pool::Train;  ///< of the rounds; Validation: entries are the finalists
    int round = 0;             ///< of sequential halving within the phase
    std::vector<Entry> entries;
    std::uint64_t next_id = 0;
    std::uint64_t episodes = 0;
    std::optional<Champion> champion;
    std::vector<Champion> fame;  ///< champions in order of their crowning, the present one last
    std::vector<nlohmann::json> log;
    nlohmann::json line;                 ///< of this generation, until it is closed
    std::optional<std::string> pending;  ///< why the search ends after this validation
    std::optional<std::string> finished;
    std::optional<std::string> last;  ///< why this generation is the last one; not saved

    void begin();
    void advance();

  private:
    bool another_training_round();
    bool another_validation_round();
    void learn();
    bool add_start(std::vector<Entry>& finalists);
    bool start_validation(std::vector<Entry> finalists);
    void crown(const Entry& entry, const Score& score, bool validated);
    void crown_winner();
    void end_generation();
    std::optional<std::string> reason_to_end() const;
};

}  // namespace k3d::optimizer::algorithm

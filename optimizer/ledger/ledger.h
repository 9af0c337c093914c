// SPDX-License-Identifier: BSD-3-Clause
// The truth of a run: an SQLite file with one row per episode, the failed tries, the algorithm's
// state after each round, and what was run. Everything else can be made again from it.
//
// Each call is one transaction in write-ahead mode: a daemon that is killed, or a machine without
// power, leaves all of it or nothing. When the call returns, the disk has it.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "optimizer/ledger/row.h"

namespace k3d::optimizer::ledger {

/// The file is missing, no ledger, damaged, of another version, or cannot be written (full disk).
/// The text names the file and the reason.
class LedgerError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What was run, as texts: name, experiment (the TOML), file, network, code_version, command, ...
using Facts = std::map<std::string, std::string>;

/// The algorithm's state at the beginning of a round, and what the round before brought.
struct Round {
    int number = 0;
    std::string state;
    std::vector<nlohmann::json> log;  ///< one line per generation closed
};

struct Candidate {
    std::uint64_t number = 0;
    int generation = 0;
    std::string payload;  ///< JSON
};

class Ledger {
  public:
    enum class Access { Read, Write };

    /// A new file; throws LedgerError if there is one already.
    static Ledger create(const std::string& path, const Facts& facts);
    /// Throws LedgerError, also for a file that is only part of a ledger.
    static Ledger open(const std::string& path, Access access);
    Ledger(Ledger&&) noexcept;
    Ledger& operator=(Ledger&&) noexcept;
    ~Ledger();

    Facts facts() const;
    void set_fact(const std::string& name, const std::string& value);

    /// Adds the rows whose keys are new, and the failed tries. Returns the rows whose key had one with
    /// another result: the same episode has then come out in two ways, and the first one stays.
    std::vector<Row> add(const std::vector<Row>& rows, const std::vector<FailedTry>& failed = {});

    std::optional<Row> find(const episode::Key& key) const;
    /// All rows, in the order of their keys.
    std::vector<Row> rows() const;
    std::vector<FailedTry> failed_tries() const;
    int count_failed(const episode::Key& key) const;

    /// Also forgets the state of the rounds before.
    void save_round(const Round& round, const std::vector<Candidate>& candidates);
    std::optional<Round> last_round() const;  ///< without its log
    std::vector<nlohmann::json> log() const;  ///< in the order of generations
    std::vector<Candidate> candidates() const;

    struct Totals {
        std::uint64_t episodes = 0;
        std::uint64_t failed = 0;
        double simulated_s = 0.0;
        double wall_s = 0.0;
    };
    Totals totals() const;
    /// Whether any episode has a result, of the test (Test, Baseline) or of the search.
    bool has_result(bool of_test) const;
    /// Of training episodes in generations before this one, s.
    double simulated_before(int generation) const;

  private:
    struct Impl;
    explicit Ledger(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace k3d::optimizer::ledger

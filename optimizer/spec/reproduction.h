// SPDX-License-Identifier: BSD-3-Clause
// What `k3d-optimizer reproduce` makes: for each part of the paper the searches that learn, and the
// tables of test episodes that compare what they found with the baselines. How long all that takes is
// a budget, a TOML file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/config/fields.h"
#include "optimizer/spec/task_spec.h"

namespace k3d::optimizer::spec {

inline const std::vector<std::string> kParts{"fig2", "fig3", "possession", "table1", "transfer"};

/// An experiment of this name, run again with other seeds.
struct Search {
    std::string name;   ///< file NAME.toml among the experiments
    std::string part;
    std::string label;  ///< of its row in the tables
    std::string network_path = {};  ///< agent's setting that takes the network it finds; empty: finds settings
};

/// All of them, in the order in which they are run.
const std::vector<Search>& searches();

struct SearchBudget {
    int runs = 1;
    std::string set;
    std::string found;  ///< words: files that earlier runs have found, in place of the first runs
    void describe(config::Fields& f) {
        f.integer("runs", runs, {0, 100}, "", "independent runs, with seeds 1, 2, ...; 0: left out");
        f.text("set", set, {}, "words path=value, each stronger than the experiment's file");
        f.text("found", found, {},
               "words: files that earlier runs have found (networks, or settings as TOML), which play in "
               "place of the first runs");
    }
};

/// Files of networks made by hand: where searches start. Those of table 1 play in its tables too.
struct StartNetworks {
    std::string targets;  ///< values K1's targets
    std::string places;   ///< values K3's places
    std::string both;     ///< values both
    std::string possession = {};  ///< chooses the state; plays in no table
};

/// How much is spent on what, and who else plays.
struct Budget {
    std::string description;
    int keepaway_episodes = 100;
    int possession_episodes = 60;
    int transfer_episodes = 40;
    int kick_episodes = 12;
    int rolls = 100;
    std::string takers = "greedy greedy_random";
    std::string baselines = "algorithm2-places start start-places random hold still";
    std::string sides = "8 9 11 12 13 14";
    std::string settings;
    bool slow_takers = true;
    std::string foreign_takers;  ///< command of a foreign program; empty: no such table
    std::string champion;  ///< network file: plays too, and in transfer instead of what was found
    std::string champion_search = "keepaway_linear_getopen";  ///< its best run is the champion otherwise
    StartNetworks start;  ///< not of the TOML: of the experiments
    std::map<std::string, SearchBudget> searches;

    Budget();
    void describe(config::Fields& f);
};

/// Throws config::ConfigError naming file and line.
Budget load_budget(const std::string& file);

/// A search and the number of one of its runs.
struct SearchRun {
    const Search* search = nullptr;  ///< of searches()
    int run = 1;
};

/// Those that take the place of the first runs, networks or agent's configurations. Throws std::invalid_argument for an open quote.
std::vector<std::string> found_files(const SearchBudget& search);

/// What is to be searched, in rounds: the first run of every search before any second one, so that an interrupted day of
/// learning has something of each.
std::vector<SearchRun> runs_in_order(const Budget& budget);

/// Who plays a row: an agent's setting, or what a search has found.
struct RowSpec {
    std::string key;       ///< of its folder
    std::string label;
    std::string settings;  ///< words path=value for the tuned side
    std::string settings_file = {};  ///< agent's configuration with more of them; empty: none
    std::string network = {};  ///< file of a network; empty: of the settings
    std::string network_path = "keeper.policy";  ///< setting that takes this file
    std::string search;    ///< name of the search whose champion plays, from its run or a file above; else empty
    int run = 1;
    bool takes_best = false;  ///< the champion of the budget's champion_search instead
};

/// Test episodes on the same seeds for every row.
struct TableSpec {
    std::string name;       ///< of its folder
    std::string part;
    std::string title;
    TaskSpec task;          ///< the exact stepper, since the server's default is it
    int episodes = 0;
    std::string reference;  ///< key of the row that the others are compared with
    std::vector<RowSpec> rows;
};

/// The tables of a part under a budget.
std::vector<TableSpec> tables_of(const std::string& part, const Budget& budget);

/// What the paper printed, to stand beside our rows.
struct PaperRow {
    std::string key;  ///< of our row that it is to be compared with
    std::string label;
    double attempts = 0.0, attempts_se = 0.0;
    double hold_time_s = 0.0, hold_time_se = 0.0;
};
/// Table 1 of "Learning complex behaviours and Keepaway in 3D Robocup Environment", 100 episodes each;
/// what stands behind its +- is read as a standard error.
const std::vector<PaperRow>& paper_table1();

}  // namespace k3d::optimizer::spec

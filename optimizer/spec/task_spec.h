// SPDX-License-Identifier: BSD-3-Clause
// The [task] section of an experiment: what one episode is, and what it is worth.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/config/fields.h"

namespace k3d::optimizer::spec {

inline const std::vector<std::string> kTaskNames{"keepaway", "walk_forward", "walk_turn", "go_to",
                                                 "kick",     "possession",   "ball_prediction"};

/// The drill (k3d-optimizer drill NAME) that a task is played as; empty for keepaway, a match.
constexpr std::string_view drill_of(std::string_view task) {
    if (task == "walk_forward") return "walk";
    if (task == "walk_turn") return "turn";
    if (task == "go_to") return "go_to";
    if (task == "kick" || task == "possession") return "kick_task";
    if (task == "ball_prediction") return "ball_rolls";
    return "";
}

/// Rows of each table of the drill kick_task: fixed ways in which the ball comes.
inline constexpr int kKickScenarios = 12;

/// How many fixed scenarios the episodes of a task play in turn, episode k the (k mod so many)th;
/// 0: each episode is drawn anew, from its seed.
constexpr int scenarios_of(std::string_view task) {
    return drill_of(task) == "kick_task" ? kKickScenarios : 0;
}

struct TaskSpec {
    std::string name = "keepaway";
    std::string fitness;
    double worst = 0.0;
    std::string tuned = "keeper";
    int keepers = 3;
    int takers = 2;
    std::string taker = "greedy";
    std::string taker_command;
    std::string settings;
    std::string drill;
    double deadline_s = 1800.0;
    double lobby_s = 60.0;
    double hung_agent_s = 30.0;
    std::string server_program;
    std::string agent_program;
    bool operator==(const TaskSpec&) const = default;

    void describe(config::Fields& f) {
        f.text("name", name, kTaskNames, "what is played");
        f.text("fitness", fitness, {},
               "figure of the episode that is maximised, - in front: minimised; empty: the task's own");
        f.number("worst", worst, {-1e9, 1e9}, "",
                 "fitness of an episode that gave no valid result in all its tries; an experiment says it, "
                 "but for keepaway's own figures, none of which is below 0");
        f.text("tuned", tuned, {"keeper", "taker", "agent"},
               "keepaway: who gets the parameters; agent: both sides");
        f.integer("keepers", keepers, {1, 11}, "players", "keepaway: left team");
        f.integer("takers", takers, {1, 11}, "players", "keepaway: right team");
        f.text("taker", taker, {"greedy", "greedy_random", "both"},
               "keepaway: the takers' strategy; both: of even episodes greedy, of odd ones greedy_random");
        f.text("taker_command", taker_command, {},
               "keepaway: a foreign program in the takers' seats, as match --taker-command; runs where "
               "the episode is played");
        f.text("settings", settings, {},
               "words PROGRAM:path=value for server, agent, keeper or taker, the same in all "
               "episodes");
        f.text("drill", drill, {}, "drills: words path=value for the drill itself, as setup.walk_m=5");
        f.number("deadline_s", deadline_s, {0.1, 86400.0}, "s", "wall time of one try");
        f.number("lobby_s", lobby_s, {0.1, 86400.0}, "s", "wall time until all seats are taken");
        f.number("hung_agent_s", hung_agent_s, {0.1, 3600.0}, "s",
                 "wall time an agent may keep the others waiting");
        f.text("server_program", server_program, {}, "empty: k3d-server beside this program");
        f.text("agent_program", agent_program, {}, "empty: k3d-agent beside this program");
    }
};

/// The strategy of the takers in an episode of a candidate, counted from 0.
inline std::string taker_of(const TaskSpec& task, int episode) {
    if (task.taker != "both") return task.taker;
    return episode % 2 == 0 ? "greedy" : "greedy_random";
}

}  // namespace k3d::optimizer::spec

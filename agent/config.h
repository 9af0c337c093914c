// SPDX-License-Identifier: BSD-3-Clause
// All settings of one agent: one section per stage, each path as `--set` takes it.
#pragma once

#include <cstdint>
#include <string>

#include "agent/decision/config.h"
#include "agent/decision/drill/config.h"
#include "agent/localisation/config.h"
#include "agent/motion/config.h"
#include "agent/skills/config.h"
#include "agent/world/config.h"
#include "common/config/fields.h"

namespace k3d::agent {

struct Config {
    std::string role = "auto";
    int robot_type = 0;
    std::uint64_t seed = 1;
    bool beam = false;
    double belief_interval = 0.2;
    bool telemetry_targets = false;
    double patience = 60.0;
    decision::KeepawayConfig keepaway;
    decision::KeeperConfig keeper;
    decision::EvaluationConfig evaluation;
    decision::PossessionConfig possession;
    decision::TakerConfig taker;
    decision::DrillConfig drill;
    skills::SkillConfig skills;
    world::WorldConfig world;
    localisation::LocalisationConfig localisation;
    motion::Config motion;

    void describe(config::Fields& f) {
        f.text("role", role, {"auto", "keeper", "taker", "drill", "soccer"},
               "auto: the left team keeps, the right takes; drill: practises one skill alone");
        f.integer("robot_type", robot_type, {0, 4}, "", "type of Nao");
        f.seed("seed", seed,
               "of this agent's random streams: localisation's follows from it alone, those of its "
               "decisions from the team and the number asked for, too");
        f.boolean("beam", beam, "beam to a kick-off position before kick-off and after goals");
        f.number("belief_interval", belief_interval, {0.02, 60.0}, "s",
                 "how often beliefs are written to the telemetry file");
        f.boolean("telemetry_targets", telemetry_targets,
                  "K1's beliefs list all targets that it has scored");
        f.number("patience", patience, {0.1, 86400.0}, "s",
                 "how long to wait for the server to take the connection, and for each frame");
        f.section("keepaway", keepaway);
        f.section("keeper", keeper);
        f.section("evaluation", evaluation);
        f.section("possession", possession);
        f.section("taker", taker);
        f.section("drill", drill);
        f.section("skills", skills);
        f.section("world", world);
        f.section("localisation", localisation);
        f.section("motion", motion);
    }
};

}  // namespace k3d::agent

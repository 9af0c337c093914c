// SPDX-License-Identifier: BSD-3-Clause
// The simulation: agents, scene and game, one 20 ms cycle at a time (reference 2.1).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/clock/clock.h"
#include "common/clock/stage_clock.h"
#include "common/episode/result.h"
#include "common/log/limiter.h"
#include "common/net/net.h"
#include "server/body/scene.h"
#include "server/config.h"
#include "server/game/game.h"
#include "server/monitor/frames.h"
#include "server/recording/monitor_log.h"
#include "server/recording/output_file.h"
#include "server/recording/recorder.h"
#include "server/recording/replay.h"
#include "server/session/agent_session.h"
#include "server/session/monitors.h"
#include "server/session/pacer.h"
#include "server/session/teams.h"
#include "server/viewer/viewer.h"

namespace k3d::server {

/// How a run ended.
enum class Outcome { Done, AgentLost, Stopped };

/// How far a replay came.
struct ReplayOutcome {
    std::int64_t steps = 0;    ///< that were the same
    Cycle reached;             ///< the clock after the last step
    int episode = 1;
    bool differs = false;      ///< the last step did
    bool ended_early = false;  ///< the simulation ended before the recording did
};

/// Agents see GameOver for this long before the episode's processes are let go.
inline constexpr int kGameOverCycles = 10;

/// Files that a run writes or reads; empty: none.
struct Files {
    std::string results;      ///< receives one line per episode
    std::string monitor_log;  ///< for monitors to play
    std::string record;       ///< for `replay` to re-simulate
    std::string web_folder;   ///< of the page
    std::string beliefs;      ///< folder of agents' telemetry, for the page; empty: none
};

class Simulation {
  public:
    /// Throws config::ConfigError for reserved team names that no two teams can have.
    Simulation(const Config& config, const Files& files);

    /// Opens all ports. Throws net::NetError. "ready agent=40123 monitor=40124 http=40125"
    std::string open_ports();

    /// Opens all files that are written. Only once the ports are open: a second start that finds
    /// them taken must leave the first one's files whole. Throws std::runtime_error.
    void open_files();

    /// Runs cycles until the game's episodes are over, a trainer ends it, or `stop` is set. Throws
    /// std::runtime_error if results or stage times cannot be written after all.
    Outcome run(const volatile int& stop);

    /// Instead: re-simulates a recording, without sockets, up to the first cycle that differs.
    /// Throws recording::RecordError where the recording is damaged.
    void replay(recording::Replay& recording, ReplayOutcome& outcome);

  private:
    void step();
    std::uint64_t state_digest() const;

    // One frame (cycle.cpp).
    void run_cycle();
    void read_commands();
    void await_inputs();
    bool all_have_come();
    void doze();
    void replay_inputs();
    void begin_input_cycle();
    void send_percepts();
    void carry_out_stored_commands();
    void obey_trainers();
    void step_physics();
    void update_game();
    void sense();
    void show();
    void write_stage_times();
    void show_page();
    void tell_monitors();
    void log_for_monitors();
    bool serves_monitors() const;

    // Agents and seats (agents.cpp).
    void accept_agent(std::unique_ptr<net::Connection> accepted);
    void say_left(const session::AgentSession& agent, const std::string& why);
    void accept_monitor(std::unique_ptr<net::Connection> accepted);
    bool everybody_synced();
    void drop_closed_agents();
    void lose(session::AgentSession& agent, const std::string& why);
    void load_robot(session::AgentSession& agent);
    void take_seat(session::AgentSession& agent);
    void line_up(const session::AgentSession& agent);
    void act(session::AgentSession& agent);
    void say(session::AgentSession& agent, const std::string& text);
    void judge_self_collisions();
    void remove_player(session::AgentSession& agent);
    void kill(session::AgentSession& agent);
    void say_ignored(const session::Order& order, std::string_view why);

    // Keepaway's way from lobby to result (episode.cpp).
    bool in_lobby() const { return lobby_; }
    void lobby_cycle();
    void await_lobby_inputs();
    void obey_trainers_in_lobby();
    void begin_episode();
    void begin_percepts(session::AgentSession& agent);
    void finish_episode();
    bool all_are_still_there();
    void tell(const episode::Result& result);
    void check_lobby_deadline();

    Config config_;
    Files files_;
    net::Loop loop_;
    log::Limiter notices_;  ///< what strangers do
    std::optional<recording::Recorder> recorder_;
    recording::ReplayStep* replayed_ = nullptr;  ///< inputs of this step; null in a live run
    session::Pacer pacer_;
    /// By (team, number) from a match's beginning on if it had a lobby; else as they came.
    std::vector<std::unique_ptr<session::AgentSession>> agents_;
    session::Teams teams_;
    session::Monitors monitors_;
    int next_connection_ = 1;  ///< number of the next connection to either port
    std::optional<net::Listener> agent_listener_, local_listener_, monitor_listener_;  ///< once ports are open
    monitor::SceneGraph graph_;
    monitor::Frames frames_;
    std::optional<recording::MonitorLog> monitor_log_;
    std::optional<recording::OutputFile> results_, stage_times_;
    std::optional<viewer::Viewer> viewer_;
    viewer::SceneView view_;

    std::unique_ptr<body::Scene> scene_;
    game::Game game_;
    Cycle clock_;
    StageClock stages_;
    std::int64_t cycles_measured_ = 0;
    std::uint64_t hash_ = 0;
    int episode_ = 1;
    int cycles_since_over_ = 0;
    bool lobby_ = false;
    net::Clock::time_point lobby_since_;
    net::Clock::time_point lobby_cycle_;  ///< when input last began to count anew there
    const volatile int* stop_ = nullptr;  ///< set by a signal's handler, in a live run
    bool cut_short_ = false;              ///< stopped while it waited: this cycle is not played
    bool end_ = false;
    Outcome outcome_ = Outcome::Done;
};

}  // namespace k3d::server

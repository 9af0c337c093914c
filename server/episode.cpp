// SPDX-License-Identifier: BSD-3-Clause
// Simulation: opening the ports, the keepaway lobby, and one episode after another.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "common/config/config.h"
#include "common/log/log.h"
#include "common/version/version.h"
#include "server/cycle.h"

namespace k3d::server {

namespace {

/// While seats are free, an agent that is waited for gets this many percepts, one per frame it
/// sends: enough for its scene and init handshake. The clock starts after them, so that the order
/// and speed of connecting leave no trace.
constexpr int kLobbyPercepts = 5;
constexpr std::chrono::milliseconds kLobbyPoll{20};

bool is_keepaway(const Config& config) { return config.game == "keepaway"; }

/// Whether the clock waits for all players.
bool has_lobby(const Config& config) {
    return is_keepaway(config) || config.pace.lobby_left + config.pace.lobby_right > 0;
}

int seats(const Config& config, wire::Side side) {
    const bool left = side == wire::Side::Left;
    if (is_keepaway(config)) return left ? config.keepaway.keepers : config.keepaway.takers;
    if (!has_lobby(config)) return wire::kMaxUnum;
    return left ? config.pace.lobby_left : config.pace.lobby_right;
}

std::optional<session::TypeQuotas> quotas(const Config& config) {
    if (is_keepaway(config) || !config.soccer.type_quotas) return std::nullopt;
    return session::TypeQuotas{};
}

std::uint16_t port(int number) { return static_cast<std::uint16_t>(number); }

}  // namespace

Simulation::Simulation(const Config& config, const Files& files)
    : config_(config),
      files_(files),
      pacer_(config.pace),
      teams_(config.left_team, config.right_team, seats(config, wire::Side::Left),
             seats(config, wire::Side::Right), quotas(config)),
      monitors_(pacer_.waits_for_agents(),
                [this](int number) {
                    if (recorder_) recorder_->left(number, "left");
                }),
      scene_(std::make_unique<body::Scene>(config.physics.kind())),
      game_(game::Soccer(config.soccer)),
      stages_(!config.stage_times.empty()),
      lobby_(has_lobby(config)),
      lobby_since_(net::Clock::now()) {
    if (lobby_) clock_.count = kLobbyPercepts;
}

void Simulation::open_files() {
    using Begin = recording::OutputFile::Begin;
    if (!files_.results.empty()) {
        results_.emplace("results", files_.results, Begin::BehindWhatIsThere);
    }
    if (stages_.on()) stage_times_.emplace("stage times", config_.stage_times, Begin::Anew);
    if (!files_.monitor_log.empty()) monitor_log_.emplace(files_.monitor_log, config_.monitor);
    if (!files_.record.empty()) {
        const std::string text = config::print(config::describing(config_));
        recorder_.emplace(files_.record, recording::Header{std::string(code_version()), text});
    }
}

std::string Simulation::open_ports() {
    const NetworkConfig& network = config_.network;
    const auto accept = [this](std::unique_ptr<net::Connection> accepted) {
        accept_agent(std::move(accepted));
    };
    const auto refuse = [this](const std::string& peer, const std::string& why) {
        notices_.say(spdlog::level::warn, "agent at {} refused: {}", peer, why);
    };
    agent_listener_.emplace(loop_, network.listen, port(network.agent_port), accept,
                            network.agent_limits(), refuse);
    if (!network.agent_socket.empty()) {
        local_listener_.emplace(loop_, net::UnixPath{network.agent_socket}, accept,
                                network.agent_limits(), refuse);
    }
    monitor_listener_.emplace(
        loop_, network.listen, port(network.server_port),
        [this](std::unique_ptr<net::Connection> accepted) { accept_monitor(std::move(accepted)); },
        network.trainer_limits(),
        [this](const std::string& peer, const std::string& why) {
            notices_.say(spdlog::level::warn, "monitor at {} refused: {}", peer, why);
        });
    if (network.http_port >= 0) {
        viewer_.emplace(loop_, network.listen, port(network.http_port), files_.web_folder,
                        files_.beliefs);
    }
    std::string line =
        fmt::format("ready agent={} monitor={}", agent_listener_->port(), monitor_listener_->port());
    if (viewer_) line += fmt::format(" http={}", viewer_->port());
    return line;
}

Outcome Simulation::run(const volatile int& stop) {
    stop_ = &stop;
    while (!end_ && stop == 0) step();
    if (!end_) outcome_ = Outcome::Stopped;
    if (recorder_) recorder_->end(static_cast<int>(outcome_));
    write_stage_times();
    return outcome_;
}

void Simulation::step() {
    if (in_lobby()) {
        lobby_cycle();
    } else {
        run_cycle();
    }
    if (recorder_ && !cut_short_) recorder_->end_step(state_digest());
}

std::uint64_t Simulation::state_digest() const {
    return recording::digest(hash_, clock_, game::state(game_));
}

void Simulation::lobby_cycle() {
    if (replayed_ != nullptr) {
        replay_inputs();
    } else {
        await_lobby_inputs();
    }
    drop_closed_agents();
    if (net::Clock::now() >= lobby_cycle_) {
        lobby_cycle_ = net::Clock::now() + kLobbyPoll;
        begin_input_cycle();
    }
    obey_trainers_in_lobby();
    static const game::GameState kWaiting;
    for (const auto& agent : agents_) {
        agent->read_frames(notices_);
        const bool asked = agent->frames > 0;
        act(*agent);
        carry_out_stored_commands();
        if (!asked || !agent->type || agent->percepts_sent >= kLobbyPercepts) continue;
        agent->parked_percepts((agent->percepts_sent + 1) * kCycleSeconds, kWaiting);
        agent->send_percepts();
    }
    const bool everybody_knows =
        std::all_of(agents_.begin(), agents_.end(), [](const auto& agent) {
            return !agent->seat || (agent->percepts_sent == kLobbyPercepts && agent->frames > 0);
        });
    if (teams_.full() && everybody_knows) {
        begin_episode();
        sense();
    } else {
        check_lobby_deadline();
    }
    show();
}

void Simulation::await_lobby_inputs() {
    loop_.wait(net::Clock::now() + kLobbyPoll, [this] {
        return std::any_of(agents_.begin(), agents_.end(), [this](const auto& agent) {
            agent->read_frames(notices_);
            const bool robot = agent->type || agent->commands.scene;
            return robot && agent->frames > 0 && agent->percepts_sent < kLobbyPercepts;
        });
    });
}

void Simulation::begin_input_cycle() {
    if (agent_listener_) agent_listener_->begin_cycle();
    if (local_listener_) local_listener_->begin_cycle();
    if (monitor_listener_) monitor_listener_->begin_cycle();
}

void Simulation::obey_trainers_in_lobby() {
    monitors_.read();
    for (const session::Order& order : monitors_.take_commands()) {
        if (std::holds_alternative<wire::KillSimCommand>(order.command)) {
            end_ = true;
        } else {
            say_ignored(order, "the match has not begun");
        }
    }
}

void Simulation::check_lobby_deadline() {
    if (replayed_ != nullptr) return;
    const std::chrono::duration<double> waited = net::Clock::now() - lobby_since_;
    if (config_.pace.lobby <= 0.0 || waited.count() < config_.pace.lobby) return;
    spdlog::error("no match after {:.0f} s: waiting for {}", waited.count(),
                  teams_.full() ? "an agent's answer" : teams_.missing());
    outcome_ = Outcome::AgentLost;
    end_ = true;
}

void Simulation::begin_episode() {
    lobby_ = false;
    hash_ = 0;
    cycles_since_over_ = 0;
    // Built in (team, number) order; agents without a seat come last and own no robot.
    std::stable_sort(agents_.begin(), agents_.end(), [](const auto& a, const auto& b) {
        const auto key = [](const session::AgentSession& s) {
            return s.seat ? std::tuple(0, static_cast<int>(s.seat->team), s.seat->unum)
                          : std::tuple(1, 0, 0);
        };
        return key(*a) < key(*b);
    });
    scene_ = std::make_unique<body::Scene>(config_.physics.kind());
    const std::uint64_t seed = config_.seed + static_cast<std::uint64_t>(episode_ - 1);
    for (const auto& agent : agents_) {
        if (!agent->seat) continue;
        body::Player& player = scene_->add_player(*agent->type, {0.0, 0.0, 1.0});
        player.team = agent->seat->team;
        player.unum = agent->seat->unum;
        player.team_name = agent->team_name;
        agent->player = player.id;
        begin_percepts(*agent);
    }
    if (is_keepaway(config_)) {
        game_.emplace<game::Keepaway>(config_.keepaway, seed, *scene_);
    } else {
        game_.emplace<game::Soccer>(config_.soccer);
        for (const auto& agent : agents_) {
            if (agent->seat) line_up(*agent);
        }
    }
    game::state(game_).team_left = teams_.left();
    game::state(game_).team_right = teams_.right();
    spdlog::info("{} {} of {}, seed {}: '{}' {} '{}'", config_.game, episode_, config_.episodes,
                 seed, teams_.left(), is_keepaway(config_) ? "keep the ball from" : "against",
                 teams_.right());
}

void Simulation::begin_percepts(session::AgentSession& agent) {
    const std::uint64_t seed = config_.seed + static_cast<std::uint64_t>(episode_ - 1);
    // Soccer robots are built before they have a seat; they are told apart by order of arrival.
    const std::string entity =
        agent.seat ? agent.name() : "arrival." + std::to_string(*agent.player);
    agent.senses.emplace(config_.vision, RandomStream(seed, entity, "vision"));
    agent.beam_noise.emplace(seed, entity, "beam");
    agent.ear = {};
    agent.self_collision.release();
}

void Simulation::finish_episode() {
    if (cycles_since_over_++ < kGameOverCycles) return;
    episode::Result result = game::result(game_);
    result.seed = config_.seed + static_cast<std::uint64_t>(episode_ - 1);
    result.state_hash = fmt::format("{:016x}", hash_);
    result.code_version = code_version();
    tell(result);
    if (result.status == episode::Status::AgentLost) outcome_ = Outcome::AgentLost;
    const bool more = episode_ < config_.episodes && has_lobby(config_);
    if (more && outcome_ != Outcome::AgentLost && all_are_still_there()) {
        ++episode_;
        begin_episode();
    } else {
        end_ = true;
    }
}

/// Who leaves after the whistle spoils no result, but the next episode would be short of a player.
bool Simulation::all_are_still_there() {
    if (teams_.full()) return true;
    spdlog::error("{} {} of {} cannot begin: missing {}", config_.game, episode_ + 1,
                  config_.episodes, teams_.missing());
    outcome_ = Outcome::AgentLost;
    return false;
}

void Simulation::tell(const episode::Result& result) {
    if (is_keepaway(config_)) {
        spdlog::info("episode {}: {} ({}), hold time {:.2f} s, {} kicks, {} passes", episode_,
                     episode::name(result.status), result.reason, result.hold_time_s, result.kicks,
                     result.passes_completed);
    } else {
        const game::GameState& state = game::state(game_);
        spdlog::info("match {}: '{}' {} : {} '{}'", episode_, teams_.left(), state.score_left,
                     state.score_right, teams_.right());
    }
    if (results_) results_->write(episode::to_line(result) + '\n');
}

}  // namespace k3d::server

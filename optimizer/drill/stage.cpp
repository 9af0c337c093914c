// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/drill/stage.h"

#include <fmt/format.h>
#include <xxhash.h>

#include "common/config/command_line.h"
#include "optimizer/episode/collect.h"
#include "optimizer/episode/commands.h"
#include "optimizer/spec/ask.h"
#include "optimizer/spec/settings.h"

namespace k3d::optimizer::drill {

namespace {

constexpr double kSeatPatience = 20.0;  // s, simulated, for the robot to appear
constexpr double kStandUp = 1.0;        // s from straight legs to the stance
constexpr double kSettle = 2.5;         // s to find out where one is
constexpr std::chrono::seconds kEndPatience{10};
constexpr const char* kServerLog = "/server.log";
constexpr const char* kAgentLog = "/agent.log";
constexpr const char* kSecondLog = "/second.log";

int port_told(const std::map<std::string, std::string>& ready, const std::string& name) {
    const auto port = process::port_in(ready, name);
    if (!port) throw DrillFailure("the server's ready line names no " + name + " port");
    return *port;
}

std::string pace_of(const spec::DrillSpec& spec, int http_port) {
    if (!spec.pace.empty()) return spec.pace;
    return http_port >= 0 ? "sync" : "fast";
}

bool is_refusal(const process::Exit& exit) {
    return !exit.signalled && exit.code == config::kExitUsage;
}

void add_settings(std::vector<std::string>& words, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
}

}  // namespace

Stage::Stage(const spec::DrillSpec& spec, std::uint64_t seed,
             const std::vector<std::string>& agent_settings,
             const std::vector<std::string>& second_settings, const std::string& folder,
             int http_port, const Listener& listener)
    : listener_(listener),
      folder_(folder),
      host_(spec.host),
      patience_(static_cast<long>(spec.patience_s * 1000.0)),
      own_server_(spec.agent_port == 0),
      syncs_(own_server_ && pace_of(spec, http_port) != "realtime"),
      batch_(own_server_ && pace_of(spec, http_port) == "fast"),
      agent_port_(spec.agent_port),
      monitor_port_(spec.server_port) {
    const bool two = !second_settings.empty();
    if (own_server_) start_server(spec, seed, http_port, two ? 2 : 1);
    trainer_ = std::make_unique<net::Client>(host_, static_cast<std::uint16_t>(monitor_port_),
                                             patience_);
    // The trainer joins before there is an agent: from the first cycle on it is waited for.
    if (syncs_) trainer_->send("(syn)");
    // In the play left by the run before, a robot would begin before it has been placed.
    if (!own_server_) {
        command(wire::PlayModeCommand{"BeforeKickOff"});
        trainer_->send(commands_);
        commands_.clear();
    }
    agent_ = start_agent(spec, seed, 1, agent_settings);
    if (two) second_ = start_agent(spec, seed, 2, second_settings);
}

void Stage::start_server(const spec::DrillSpec& spec, std::uint64_t seed, int http_port,
                         int robots) {
    std::vector<std::string> words{spec::program_path(spec.server_program, "k3d-server"),
                                   "--agent-port", "0", "--server-port", "0",
                                   "--seed", std::to_string(seed),
                                   "--pace", pace_of(spec, http_port),
                                   "--lobby-s", fmt::format("{}", spec.patience_s),
                                   "--hung-agent-s", fmt::format("{}", spec.patience_s),
                                   "--set", fmt::format("pace.lobby_left={}", robots)};
    if (http_port >= 0) {
        words.insert(words.end(), {"--http", std::to_string(http_port), "--beliefs", folder_});
    }
    if (!spec.server_config.empty()) words.insert(words.end(), {"--config", spec.server_config});
    add_settings(words, spec::parse_settings(spec.settings).server);
    agent_socket_ = episode::agent_socket(folder_);
    if (!agent_socket_.empty()) words.insert(words.end(), {"--agent-socket", agent_socket_});
    host_ = "127.0.0.1";
    server_ = std::make_unique<process::Child>(
        process::Spawn{words, folder_ + kServerLog, true, batch_});
    const auto ready = wait_ready();
    agent_port_ = port_told(ready, "agent");
    monitor_port_ = port_told(ready, "monitor");
    if (http_port >= 0) page_port_ = port_told(ready, "http");
}

std::map<std::string, std::string> Stage::wait_ready() {
    try {
        return server_->wait_ready(patience_);
    } catch (const process::ProcessError&) {
        const auto exit = server_->poll();
        if (!exit || !is_refusal(*exit)) throw;
        throw DrillFailure(episode::describe_end("server", *exit, folder_ + kServerLog), true);
    }
}

std::unique_ptr<process::Child> Stage::start_agent(const spec::DrillSpec& spec, std::uint64_t seed,
                                                   int unum,
                                                   const std::vector<std::string>& settings) {
    std::vector<std::string> words{spec::program_path(spec.agent_program, "k3d-agent"),
                                   "--host", host_, "--port", std::to_string(agent_port_),
                                   "--unum", std::to_string(unum), "--team", "Drill", "--role", "drill",
                                   "--type", std::to_string(spec.type),
                                   "--seed", std::to_string(seed),
                                   "--patience-s", fmt::format("{}", spec.patience_s),
                                   "--set", "belief_interval=0.02"};
    if (unum == 1) words.insert(words.end(), {"--telemetry", telemetry_file()});
    if (!agent_socket_.empty()) words.insert(words.end(), {"--socket", agent_socket_});
    if (!spec.agent_config.empty()) words.insert(words.end(), {"--config", spec.agent_config});
    add_settings(words, settings);
    const spec::Settings passed_on = spec::parse_settings(spec.settings);
    add_settings(words, unum == 1 ? passed_on.keeper : passed_on.taker);
    const char* log = unum == 1 ? kAgentLog : kSecondLog;
    return std::make_unique<process::Child>(process::Spawn{words, folder_ + log, false, batch_});
}

void Stage::begin(const Pose2& pose, const wire::BallCommand& ball,
                  const std::optional<Pose2>& second) {
    if (!until(kSeatPatience, [](const Truth& t) { return t.robot.has_value(); })) {
        fail("no robot has appeared");
    }
    const auto never = [](const Truth&) { return false; };
    until(kStandUp, never);
    place(pose);
    if (second) place(*second, 2);
    until(kSettle, never);
    command(wire::PlayModeCommand{"PlayOn"});
    command(ball);
    if (!until(1.0, [](const Truth& t) { return t.play_mode == "PlayOn"; })) {
        fail("the game is not on: " + truth().play_mode);
    }
    recording_ = true;
    track_.push_back(truth());
}

void Stage::command(const wire::TrainerCommand& command) { wire::encode(command, commands_); }

void Stage::place(const Pose2& pose, int unum) {
    const double height = truth().robot->torso.z() + 0.005;
    // On the wire 0 means forward along +y.
    command(wire::AgentCommand{unum, wire::Side::Left,
                               Vec3(pose.position.x(), pose.position.y(), height),
                               wrap_degrees(degrees(pose.yaw) - 90.0)});
}

const Truth& Stage::next() {
    // Differences tell of moves above 5 mm only; full frames are exact.
    commands_ += "(reqfullstate)";
    if (syncs_) commands_ += "(syn)";
    if (!syncs_ || asked_) trainer_->send(commands_);  // the first (syn) was sent on joining
    asked_ = true;
    commands_.clear();
    receive();
    if (recording_) {
        if (!truth().robot) fail("the robot has left");
        track_.push_back(truth());
    }
    return truth();
}

void Stage::receive() {
    std::string_view frame;
    do {
        wait_for(frame);
        scene_.read(frame);
        // A frame told while the lobby waits is no turn of ours.
    } while (syncs_ && frame.find("(syn 1)") == std::string_view::npos);
    if (recording_) hash_ = XXH3_64bits_withSeed(frame.data(), frame.size(), hash_);
}

/// In slices, so that an agent that could not start, or the user's wish to stop, is noticed at
/// once.
void Stage::wait_for(std::string_view& frame) {
    constexpr std::chrono::milliseconds kSlice{100};
    const auto deadline = net::Clock::now() + patience_;
    for (;;) {
        if (listener_.wants_to_stop()) throw Stopped();
        const auto slice_end = net::Clock::now() + kSlice;
        try {
            if (!trainer_->receive(frame, kSlice)) fail("the server has left");
            return;
        } catch (const net::NetError& error) {
            const bool waited = net::Clock::now() >= slice_end;
            if (!waited || net::Clock::now() >= deadline) fail(error.what());
        }
        if (agent_ && agent_->poll()) fail("the agent has left");
        if (second_ && second_->poll()) fail("the second agent has left");
    }
}

bool Stage::until(double seconds, const std::function<bool(const Truth&)>& done) {
    const auto frames = static_cast<long>(seconds / kFrameSeconds + 0.5);
    for (long i = 0; i < frames; ++i) {
        if (done(next())) return true;
    }
    return false;
}

std::string Stage::hash() const { return fmt::format("{:016x}", hash_); }

std::string Stage::telemetry_file() const { return folder_ + "/agent.telemetry.jsonl"; }

void Stage::finish() {
    if (own_server_) {
        trainer_->send(syncs_ ? "(killsim)(syn)" : "(killsim)");
        if (!server_->wait(kEndPatience)) fail("the server does not end");
    } else {
        agent_->terminate();
        if (second_) second_->terminate();
    }
    if (!agent_->wait(kEndPatience)) fail("the agent does not end");
    if (second_ && !second_->wait(kEndPatience)) fail("the second agent does not end");
}

/// Whoever ended first is the cause.
void Stage::fail(const std::string& what) {
    std::string why = what;
    bool refused = false;
    const auto add_end = [&](process::Child* child, const char* name, const char* log) {
        if (child == nullptr) return;
        if (const auto exit = child->wait(std::chrono::milliseconds(200))) {
            why += "; " + episode::describe_end(name, *exit, folder_ + log);
            refused = refused || is_refusal(*exit);
        }
    };
    add_end(agent_.get(), "agent", kAgentLog);
    add_end(second_.get(), "second agent", kSecondLog);
    add_end(server_.get(), "server", kServerLog);
    throw DrillFailure(why, refused);
}

}  // namespace k3d::optimizer::drill

// SPDX-License-Identifier: BSD-3-Clause
// The place of one drill: a server and one agent as processes of their own, a second agent where the
// drill needs a robot that kicks to be watched, and a trainer that places ball and robots and sees the
// truth. On a server that runs already only the agents are ours.
//
// A server of ours waits for the trainer's (syn) after each frame, so that a drill with the same
// seed is the same drill; the reference server waits for nobody.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/net/net.h"
#include "common/process/child.h"
#include "common/wire/trainer.h"
#include "optimizer/drill/scene.h"
#include "optimizer/spec/drill_spec.h"

namespace k3d::optimizer::drill {

inline constexpr double kFrameSeconds = 0.04;  ///< from one frame of the monitor stream to the next

/// Why a drill could not be carried out; one line.
class DrillFailure : public std::runtime_error {
  public:
    explicit DrillFailure(const std::string& what, bool is_refused = false)
        : std::runtime_error(what), refused(is_refused) {}
    bool refused;  ///< server or agent took their settings for a mistake: so they do in every run
};

/// The user wants to stop.
class Stopped : public std::runtime_error {
  public:
    Stopped() : std::runtime_error("stopped") {}
};

/// What a run tells its caller, and asks it; both must be there.
struct Listener {
    std::function<void(int)> page;        ///< hears the page's port once there is one
    std::function<bool()> wants_to_stop;  ///< asked before every frame
};

class Stage {
  public:
    /// `agent_settings`: path=value words; `second_settings` those of the second robot, empty:
    /// there is none. `http_port` -1: no page. All files go to `folder`. Throws DrillFailure,
    /// process::ProcessError, net::NetError. Once `listener`, which outlives it, wants to stop,
    /// waiting for a frame throws Stopped.
    Stage(const spec::DrillSpec& spec, std::uint64_t seed,
          const std::vector<std::string>& agent_settings,
          const std::vector<std::string>& second_settings, const std::string& folder, int http_port,
          const Listener& listener);

    /// Lets the robots stand up, places them in their own half and gives them time to find out where
    /// they are; then the game is on, and the drill's time and track begin.
    void begin(const Pose2& pose, const wire::BallCommand& ball,
               const std::optional<Pose2>& second = std::nullopt);
    void command(const wire::TrainerCommand& command);
    /// Moves the robot, or the second one; it keeps its joints, stands upright and looks along
    /// pose.yaw.
    void place(const Pose2& pose, int unum = 1);

    /// Sends what was commanded and waits for the next frame.
    const Truth& next();
    /// Goes on until `done` holds or so much simulated time has passed; returns whether it holds.
    bool until(double seconds, const std::function<bool(const Truth&)>& done);

    const Truth& truth() const { return scene_.truth(); }
    const RobotTruth& robot() const { return *scene_.truth().robot; }
    /// Every frame since begin(), the first one with the game on.
    const std::vector<Truth>& track() const { return track_; }
    std::string hash() const;  ///< 16 hex digits over the track's frames
    std::string telemetry_file() const;
    int page_port() const { return page_port_; }

    /// Ends server and agent; the telemetry is complete then.
    void finish();

  private:
    void start_server(const spec::DrillSpec& spec, std::uint64_t seed, int http_port, int robots);
    std::map<std::string, std::string> wait_ready();
    std::unique_ptr<process::Child> start_agent(const spec::DrillSpec& spec, std::uint64_t seed,
                                                int unum, const std::vector<std::string>& settings);
    void receive();
    void wait_for(std::string_view& frame);
    [[noreturn]] void fail(const std::string& what);

    const Listener& listener_;
    std::string folder_;
    std::string host_;
    std::chrono::milliseconds patience_;
    bool own_server_;
    bool syncs_;
    bool batch_;
    int agent_port_ = 0;
    std::string agent_socket_;  ///< of our own server, if its name is short enough
    int monitor_port_ = 0;
    int page_port_ = -1;
    std::unique_ptr<process::Child> server_;
    std::unique_ptr<net::Client> trainer_;
    std::unique_ptr<process::Child> agent_;
    std::unique_ptr<process::Child> second_;
    std::string commands_;
    Scene scene_;
    bool asked_ = false;  ///< next() was called before
    bool recording_ = false;
    std::vector<Truth> track_;
    std::uint64_t hash_ = 0;
};

}  // namespace k3d::optimizer::drill

// SPDX-License-Identifier: BSD-3-Clause
#include "agent/world/world_model.h"

#include "common/field/field.h"
#include "common/nao/camera.h"

namespace k3d::agent::world {

namespace {

constexpr double kMaxStep = 1.0;    // s between two frames; more, or less than none, is a jump
constexpr double kPoseJump = 0.15;  // m: a correction that is no mere noise
constexpr double kYawJump = radians(3.0);
constexpr double kAngleNoise = radians(nao::kSightThetaNoiseDeg);
constexpr double kBallOffset = 0.008;        // m: rounding, calibration, error of the camera's pose
constexpr double kPlayerOffset = 0.03;       // m: limbs sway about the middle
constexpr double kSafeView = radians(50.0);  // well inside the view of +-60 degrees
constexpr double kSafeDistance = 0.3;        // m: nearer than 0.1 m nothing is seen

/// Error of a sighting at `distance`, in the team frame.
double sight_sd(double offset, double distance, double yaw_sd) {
    const double angle = std::hypot(kAngleNoise, yaw_sd);
    return std::hypot(offset, angle * distance);
}

}  // namespace

WorldModel::WorldModel(const WorldConfig& world,
                       const localisation::LocalisationConfig& localisation, std::uint64_t seed,
                       std::string team)
    : identity_{std::move(team), 0},
      localiser_(localisation, seed),
      ball_(world.ball),
      players_(world.players, world.taker) {}

void WorldModel::reset() {
    localiser_.reset();
    ball_.reset();
    players_.reset();
}

void WorldModel::follow_game(const wire::Percepts& percepts) {
    if (!percepts.game) return;
    const wire::GameState& told = *percepts.game;
    Game& game = beliefs_.game;
    if (told.unum) identity_.unum = game.unum = *told.unum;
    if (told.team) game.side = *told.team;
    game.time = told.time;
    if (told.play_mode == game.play_mode) return;
    if (told.play_mode == "BeforeKickOff" && !game.play_mode.empty()) reset();
    game.play_mode = told.play_mode;
}

void WorldModel::locate(const perception::View* view, const motion::State& body, double dt) {
    const bool was_localised = beliefs_.self.localised;
    const Pose2 expected =
        body.upright ? beliefs_.self.pose.then(body.odometry) : beliefs_.self.pose;
    const localisation::Location& location =
        localiser_.update(view, body.odometry, body.upright, beliefs_.game.side, dt);
    const Pose2& pose = location.pose;
    const bool jumped = (pose.position - expected.position).norm() > kPoseJump ||
                        std::abs(wrap_angle(pose.yaw - expected.yaw)) > kYawJump;
    if (was_localised && location.localised && jumped) {
        // What was seen was seen from the wrong place: it did not move, the robot's idea did.
        ball_.reseat(expected, pose);
        players_.reseat(expected, pose);
    }
    beliefs_.self = {pose, location.position_sd, location.yaw_sd, location.localised, body.upright};
}

void WorldModel::see(const perception::View& view) {
    const Self& self = beliefs_.self;
    if (view.ball) {
        const Vec2 local = view.ball->head<2>();
        ball_.see(self.pose.to_global(local), sight_sd(kBallOffset, local.norm(), self.yaw_sd),
                  beliefs_.now);
    } else {
        look_for_ball(view);
    }
    for (const perception::PlayerSight& sight : view.players) {
        players_.see(sight.mate, sight.unum, self.pose.to_global(sight.position),
                     sight_sd(kPlayerOffset, sight.position.norm(), self.yaw_sd), sight.fallen,
                     beliefs_.now);
    }
}

/// Nothing hides anything from this camera: a ball that should be in view and is not, is elsewhere.
void WorldModel::look_for_ball(const perception::View& view) {
    if (!ball_.known(beliefs_.now)) return;
    const Vec2 local = beliefs_.self.pose.to_local(ball_.position());
    const Vec3 from_camera = Vec3(local.x(), local.y(), field::kBallRadius) - view.camera;
    const Vec3 ball = view.camera_rotation.conjugate() * from_camera;
    const double theta = std::atan2(ball.y(), ball.x());
    const double phi = std::atan2(ball.z(), std::hypot(ball.x(), ball.y()));
    const bool in_view = std::abs(theta) < kSafeView && std::abs(phi) < kSafeView;
    if (in_view && ball.norm() > kSafeDistance) ball_.miss();
}

void WorldModel::hear(std::span<const talk::Message> messages) {
    for (const talk::Message& message : messages) {
        if (message.unum == identity_.unum) continue;
        players_.hear(message.unum, message.position, message.fallen, beliefs_.now);
        if (const auto& opponent = message.opponent)
            players_.hear_of_opponent(opponent->unum, opponent->position, beliefs_.now);
        if (message.ball) ball_.hear(*message.ball, message.ball_velocity, beliefs_.now);
    }
}

const Beliefs& WorldModel::update(const wire::Percepts& percepts, const motion::State& body,
                                  std::span<const talk::Message> messages) {
    const double dt = started_ ? percepts.time - beliefs_.now : 0.0;
    if (dt < 0.0 || dt > kMaxStep) reset();
    started_ = true;
    beliefs_.now = percepts.time;
    follow_game(percepts);

    const perception::View* view = nullptr;
    if (percepts.see && body.upright) {
        perception::look(*percepts.see, body, identity_, view_);
        view = &view_;
    }
    locate(view, body, dt > 0.0 && dt <= kMaxStep ? dt : 0.0);
    ball_.predict(beliefs_.now);
    players_.predict(beliefs_.now);
    if (view != nullptr && beliefs_.self.localised) see(*view);
    hear(messages);
    ball_.report(beliefs_.now, beliefs_.ball);
    players_.report(beliefs_.now, identity_.unum, beliefs_.mates, beliefs_.opponents);
    return beliefs_;
}

}  // namespace k3d::agent::world

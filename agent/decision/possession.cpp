// SPDX-License-Identifier: BSD-3-Clause
// The four actions of getting possession and who chooses among them.
#include "agent/decision/possession.h"

#include <memory>

#include "agent/skills/intercept.h"
#include "agent/skills/kick_meeting.h"

namespace k3d::agent::decision {
namespace {

using motion::BodyRequest;

/// Walk to a point of the ball's path and face the ball.
BodyRequest meet(const PossessionInput& in, const Vec2& point, skills::GoTo& go_to,
                 const skills::SkillConfig& skill) {
    const Pose2& self = in.beliefs.self.pose;
    const Pose2 goal{within_square(point, in.half_area),
                     yaw_of(in.beliefs.ball.position - self.position)};
    return go_to.step(self, goal, in.robots, skill);
}

/// Keeps to a state for a while, so that it gets somewhere.
Chooser<PossessionInput> choose_by_chance(const RandomStream& chances) {
    constexpr double kWhile = 1.0;  // s
    auto stream = std::make_shared<RandomStream>(chances);
    auto until = std::make_shared<double>(-1.0);
    return [=](const PossessionInput& in, int state) {
        if (in.beliefs.now < *until) return state;
        *until = in.beliefs.now + kWhile;
        return stream->below(static_cast<int>(kPossessionStates));
    };
}

/// What an agent that foresees nothing acts on: a ball that lies where it is now.
BodyRequest without_foresight(const PossessionInput& in,
                              const std::function<BodyRequest(const PossessionInput&)>& act) {
    world::Beliefs seen = in.beliefs;
    seen.ball.moving = false;
    seen.ball.velocity = Vec2::Zero();
    seen.ball.finish = seen.ball.position_before = seen.ball.position;
    return act({seen, in.body, in.target, in.pressure, in.may_kick, in.committed, in.half_area,
                in.robots});
}

BodyRequest position(const PossessionInput& in, skills::KickMeeting& kick_meeting,
                     const skills::SkillConfig& skill, const skills::KickGeometry& kick) {
    const Pose2& self = in.beliefs.self.pose;
    const bool standing = in.body.activity == motion::Activity::Standing;
    const skills::Meeting meeting = kick_meeting.plan(self, in.beliefs.ball, in.target,
                                                      in.may_kick, standing, kick, skill);
    const skills::KickSituation situation{
        self,     meeting.point, meeting.ball_at_hit, in.target,       in.pressure,   in.may_kick,
        standing, in.committed,  meeting.arrived,     meeting.rolling, meeting.strike,
    };
    return skills::position_for_kick(situation, kick, in.robots, skill);
}

}  // namespace

PossessionVariables possession_variables(const PossessionInput& in) {
    const Pose2& self = in.beliefs.self.pose;
    const world::Ball& ball = in.beliefs.ball;
    const double agent_ball = (ball.position - self.position).norm();
    const double bearing = wrap_angle(yaw_of(in.target - self.position) - self.yaw);
    return {
        agent_ball,
        (ball.finish - self.position).norm(),
        (ball.finish - ball.position).norm(),
        degrees(angle_at(ball.position, self.position, ball.finish)),
        degrees(std::abs(bearing)),
        agent_ball - (ball.position_before - self.position).norm(),
    };
}

int choose_by_rules(const PossessionVariables& v, int state, const PossessionConfig& c) {
    const double agent_ball = v[0];
    const double agent_finish = v[1];
    const double ball_finish = v[2];
    const double seen_apart_deg = v[3];
    const bool ball_comes = v[5] < 0.0;
    // A ball about to arrive: who steps now steps on it.
    if (ball_finish > c.at_rest && ball_comes && agent_ball < c.wait_distance) return kHold;
    // Positioning begins while the ball still rolls, so that no time is lost when it lies. A state
    // once chosen keeps a quarter more room, so that noise does not flip it.
    if (agent_finish < c.position_distance * (state == kPosition ? 1.25 : 1.0)) return kPosition;
    const double apart = state == kIntercept ? 0.75 * c.passing_by_deg : c.passing_by_deg;
    if (seen_apart_deg > apart && ball_finish > c.position_distance) return kIntercept;
    return kGoToFinish;
}

PossessionBehaviour make_possession(const PossessionConfig& config, const skills::SkillConfig& skill,
                                    const skills::KickGeometry& kick, RandomStream chances) {
    auto to_path = std::make_shared<skills::GoTo>();
    auto to_finish = std::make_shared<skills::GoTo>();
    auto meeting = std::make_shared<skills::KickMeeting>();
    std::vector<Action<PossessionInput, BodyRequest>> actions(kPossessionStates);
    actions[kIntercept] = {"intercept",
                           [=](const PossessionInput& in) {
                               const Vec2& self = in.beliefs.self.pose.position;
                               const Vec2 point =
                                   skill.intercept == "foot"
                                       ? skills::perpendicular_foot(self, in.beliefs.ball)
                                       : skills::earliest_meeting(self, in.beliefs.ball,
                                                                  skill.forward_speed);
                               return meet(in, point, *to_path, skill);
                           },
                           [=] { to_path->reset(); }};
    actions[kGoToFinish] = {"go_to_finish",
                            [=](const PossessionInput& in) {
                                return meet(in, in.beliefs.ball.finish, *to_finish, skill);
                            },
                            [=] { to_finish->reset(); }};
    actions[kPosition] = {"position",
                          [=](const PossessionInput& in) {
                              return position(in, *meeting, skill, kick);
                          },
                          [=] { meeting->reset(); }};
    actions[kHold] = {"hold", [](const PossessionInput&) -> BodyRequest { return motion::Stand{}; }};

    Chooser<PossessionInput> chooser = [config](const PossessionInput& in, int state) {
        return choose_by_rules(possession_variables(in), state, config);
    };
    if (config.chooser == "straight") {
        chooser = [](const PossessionInput&, int) { return int{kPosition}; };
        actions[kPosition].get_skill = [act = actions[kPosition].get_skill](
                                           const PossessionInput& in) {
            return without_foresight(in, act);
        };
    }
    if (config.chooser == "random") chooser = choose_by_chance(chances);
    if (!config.network.empty()) {
        network::Network net(network::load_file(config.network), config.network);
        network::require_shape(net, kPossessionInputs, kPossessionOutputs, config.network);
        chooser = network_chooser<PossessionInput>(std::move(net), possession_variables);
    }
    return {std::move(actions), std::move(chooser), kGoToFinish, kHold};
}

}  // namespace k3d::agent::decision

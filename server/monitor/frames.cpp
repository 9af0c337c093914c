// SPDX-License-Identifier: BSD-3-Clause
#include "server/monitor/frames.h"

#include <fmt/format.h>

#include <cmath>

#include "common/field/field.h"
#include "common/log/log.h"
#include "common/sexpr/writer.h"

namespace k3d::server::monitor {

namespace {

constexpr double kTold = 0.005;  // reference 8.3

void append_number(std::string_view name, double value, std::string& out) {
    out += '(';
    out += name;
    out += ' ';
    sexpr::append_general(value, out);
    out += ')';
}

void append_integer(std::string_view name, int value, std::string& out) {
    out += '(';
    out += name;
    out += ' ';
    sexpr::append_integer(value, out);
    out += ')';
}

void append_team(std::string_view name, const std::string& team, std::string& out) {
    if (!team.empty()) out += fmt::format("({} {})", name, team);
}

/// What stays for a match. The rules' times are the reference's own, whether or not they are judged.
void append_constants(const GameView& view, std::string& out) {
    append_number("FieldLength", field::kLength, out);
    append_number("FieldWidth", field::kWidth, out);
    append_number("FieldHeight", field::kHeight, out);
    append_number("GoalWidth", field::kGoalWidth, out);
    append_number("GoalDepth", field::kGoalDepth, out);
    append_number("GoalHeight", field::kGoalHeight, out);
    append_number("BorderSize", 0.0, out);
    append_number("FreeKickDistance", field::kCentreRadius, out);
    append_number("WaitBeforeKickOff", 30.0, out);
    append_number("AgentRadius", field::kAgentRadius, out);
    append_number("BallRadius", field::kBallRadius, out);
    append_number("BallMass", field::kBallMass, out);
    append_number("RuleGoalPauseTime", 3.0, out);
    append_number("RuleKickInPauseTime", 1.0, out);
    append_number("RuleHalfTime", view.half_time, out);
    append_number("PassModeMinOppBallDist", 1.0, out);
    append_number("PassModeDuration", 4.0, out);
    out += "(play_modes";
    for (int mode = 0; mode <= static_cast<int>(game::PlayMode::PassRight); ++mode) {
        out += ' ';
        out += game::name(static_cast<game::PlayMode>(mode));
    }
    out += ')';
}

void append_waits(const GameView& view, std::string& out) {
    if (view.pass_wait_left > 0.0) {
        append_number("pass_mode_score_wait_left", view.pass_wait_left, out);
    }
    if (view.pass_wait_right > 0.0) {
        append_number("pass_mode_score_wait_right", view.pass_wait_right, out);
    }
}

void append_game(const GameView& view, std::string& out) {
    append_number("time", view.time, out);
    append_team("team_left", view.team_left, out);
    append_team("team_right", view.team_right, out);
    append_integer("half", view.half, out);
    append_integer("score_left", view.score_left, out);
    append_integer("score_right", view.score_right, out);
    append_integer("play_mode", static_cast<int>(view.mode), out);
    append_waits(view, out);
}

/// The time, and what else is not as it was told.
void append_changes(const GameView& view, const GameView& told, std::string& out) {
    append_number("time", view.time, out);
    if (view.team_left != told.team_left) append_team("team_left", view.team_left, out);
    if (view.team_right != told.team_right) append_team("team_right", view.team_right, out);
    if (view.half != told.half) append_integer("half", view.half, out);
    if (view.score_left != told.score_left) append_integer("score_left", view.score_left, out);
    if (view.score_right != told.score_right) append_integer("score_right", view.score_right, out);
    if (view.mode != told.mode) append_integer("play_mode", static_cast<int>(view.mode), out);
    append_waits(view, out);
}

void append_transform(const Matrix& matrix, std::string& out) {
    out += "(SLT";
    for (const double element : matrix) {
        out += ' ';
        sexpr::append_general(element, out);
    }
    out += ')';
}

void append_full(const Node& node, std::string& out) {
    if (node.kind == NodeKind::Transform) {
        out += "(nd TRF ";
        append_transform(node.transform, out);
    } else if (node.kind == NodeKind::Light) {
        out += "(nd Light ";
        out += node.look;
    } else {
        out += node.kind == NodeKind::StaticMesh ? "(nd StaticMesh" : "(nd SMN";
        out += node.visible ? " (setVisible 1) " : " (setVisible 0) ";
        if (node.transparent) out += "(setTransparent) ";
        out += node.look;
    }
}

/// Runs `append` on every node and sets the parentheses.
template <class Append>
void append_tree(const std::vector<Node>& nodes, std::string& out, const Append& append) {
    out += '(';
    int open = 0;  // nodes whose parenthesis is not closed
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        out.append(static_cast<std::size_t>(open - nodes[i].depth), ')');
        append(i);
        open = nodes[i].depth + 1;
    }
    out.append(static_cast<std::size_t>(open), ')');
    out += ')';
}

}  // namespace

GameView view_of(const game::GameState& state, double half_time) {
    return {state.time,        state.team_left, state.team_right, state.half, state.score_left,
            state.score_right, state.mode,      half_time,        state.pass_wait_left,
            state.pass_wait_right};
}

std::string Frames::full(const SceneGraph& graph, const GameView& view) const {
    std::string out = "(";
    append_constants(view, out);
    append_game(view, out);
    out += ")(RSG 0 1)";
    append_tree(graph.nodes(), out, [&](std::size_t i) { append_full(graph.nodes()[i], out); });
    return out;
}

bool Frames::restart(const SceneGraph& graph, const GameView& view) {
    if (revision_ == graph.revision()) return false;
    revision_ = graph.revision();
    transforms_.clear();
    visible_.clear();
    for (const Node& node : graph.nodes()) {
        transforms_.push_back(node.transform);
        visible_.push_back(node.visible);
    }
    game_ = view;
    return true;
}

std::string Frames::difference(const SceneGraph& graph, const GameView& view) {
    K3D_ASSERT(revision_ == graph.revision());
    const std::vector<Node>& nodes = graph.nodes();
    std::string out = "(";
    append_changes(view, game_, out);
    game_ = view;
    out += ")(RDS 0 1)";
    append_tree(nodes, out, [&](std::size_t i) {
        const Node& node = nodes[i];
        out += "(nd";
        if (node.kind == NodeKind::StaticMesh) out += " StaticMesh";
        if (node.kind == NodeKind::SingleMesh) out += " SMN";
        if (!tell(i, graph)) return;
        out += ' ';
        if (node.kind == NodeKind::Transform) {
            append_transform(node.transform, out);
        } else {
            out += node.visible ? "(setVisible 1)" : "(setVisible 0)";
        }
    });
    return out;
}

bool Frames::tell(std::size_t i, const SceneGraph& graph) {
    const Node& node = graph.nodes()[i];
    if (node.kind != NodeKind::Transform) {
        const bool toggled = visible_[i] != node.visible;
        visible_[i] = node.visible;
        return toggled;
    }
    for (std::size_t k = 0; k < node.transform.size(); ++k) {
        // So written that a NaN is told, too.
        if (std::abs(node.transform[k] - transforms_[i][k]) <= kTold) continue;
        transforms_[i] = node.transform;
        return true;
    }
    return false;
}

}  // namespace k3d::server::monitor

// SPDX-License-Identifier: BSD-3-Clause
// Writing a percept frame, in the reference's order: the robot's parts depth first.
#include "common/sexpr/writer.h"
#include "common/wire/percepts.h"

namespace k3d::wire {

namespace {

using nao::JointId;

constexpr int kDecimals = 2;

void number(double value, std::string& out) {
    out += ' ';
    sexpr::append_fixed(value, kDecimals, out);
}

void vector(const Vec3& v, std::string& out) {
    number(v.x(), out);
    number(v.y(), out);
    number(v.z(), out);
}

void integer(std::string_view before, int value, std::string& out) {
    out += before;
    sexpr::append_integer(value, out);
    out += ')';
}

void pol(const Pol& p, std::string& out) {
    out += "(pol";
    number(p.distance, out);
    number(p.theta_deg, out);
    number(p.phi_deg, out);
    out += ')';
}

void game_state(const GameState& game, std::string& out) {
    out += "(GS";
    if (game.unum) integer(" (unum ", *game.unum, out);
    if (game.team) {
        out += " (team ";
        out += side_name(*game.team);
        out += ')';
    }
    integer(" (sl ", game.score_left, out);
    integer(" (sr ", game.score_right, out);
    out += " (t";
    number(game.time, out);
    out += ") (pm ";
    out += game.play_mode;
    out += "))";
}

void heard(const Heard& message, std::string& out) {
    out += "(hear ";
    out += message.team;
    number(message.time, out);
    if (message.direction_deg) {
        number(*message.direction_deg, out);
        out += ' ';
    } else {
        out += " self ";
    }
    out += message.text;
    out += ')';
}

void foot(FootSensor sensor, const Percepts& percepts, std::string& out) {
    const auto i = static_cast<std::size_t>(sensor);
    if (!percepts.feet[i]) return;
    out += "(FRP (n ";
    out += kFootNames[i];
    out += ") (c";
    vector(percepts.feet[i]->point, out);
    out += ") (f";
    vector(percepts.feet[i]->force, out);
    out += "))";
}

/// The sensor of a foot comes before the joint that moves it.
void foot_before(JointId joint, const Percepts& percepts, std::string& out) {
    switch (joint) {
        case JointId::RAnkleRoll:
            return foot(FootSensor::Right, percepts, out);
        case JointId::LAnkleRoll:
            return foot(FootSensor::Left, percepts, out);
        case JointId::RToe:
            return foot(FootSensor::RightToe, percepts, out);
        case JointId::LToe:
            return foot(FootSensor::LeftToe, percepts, out);
        default:
            return;
    }
}

void part(std::string_view tag, const std::optional<Pol>& where, std::string& out) {
    if (!where) return;
    out += " (";
    out += tag;
    out += ' ';
    pol(*where, out);
    out += ')';
}

void player(const SeenPlayer& seen, std::string& out) {
    out += " (P (team ";
    out += seen.team;
    integer(") (id ", seen.unum, out);
    part("head", seen.head, out);
    part("rlowerarm", seen.rlowerarm, out);
    part("llowerarm", seen.llowerarm, out);
    part("rfoot", seen.rfoot, out);
    part("lfoot", seen.lfoot, out);
    out += ')';
}

void see(const See& view, std::string& out) {
    out += "(See";
    const std::size_t empty = out.size();
    for (std::size_t i = 0; i < view.landmarks.size(); ++i) {
        part(field::kLandmarks[i].name, view.landmarks[i], out);
    }
    part("B", view.ball, out);
    for (const SeenPlayer& seen : view.players) player(seen, out);
    if (view.my_position) {
        out += " (mypos";
        vector(*view.my_position, out);
        out += ')';
    }
    if (view.my_orientation_deg) {
        out += " (myorien";
        number(*view.my_orientation_deg, out);
        out += ')';
    }
    if (view.ball_position) {
        out += " (ballpos";
        vector(*view.ball_position, out);
        out += ')';
    }
    for (const SeenLine& line : view.lines) {
        out += " (L ";
        pol(line.begin, out);
        out += ' ';
        pol(line.end, out);
        out += ')';
    }
    if (out.size() == empty) out += ' ';  // some agents need the blank of `(See )`
    out += ')';
}

}  // namespace

void encode(const Percepts& percepts, const nao::Model& model, std::string& out) {
    out += "(time (now";
    number(percepts.time, out);
    out += "))";
    if (percepts.game) game_state(*percepts.game, out);
    for (const Heard& message : percepts.heard) heard(message, out);
    out += "(GYR (n torso) (rt";
    vector(percepts.gyro_deg, out);
    out += "))(ACC (n torso) (a";
    vector(percepts.acceleration, out);
    out += "))";
    for (const nao::JointDef& joint : model.joints) {
        foot_before(joint.id, percepts, out);
        out += "(HJ (n ";
        out += joint.perceptor;
        out += ") (ax";
        number(percepts.joints_deg[nao::index(joint.id)], out);
        out += "))";
        if (joint.id == JointId::HeadPitch && percepts.see) see(*percepts.see, out);
    }
}

}  // namespace k3d::wire

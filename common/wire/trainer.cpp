// SPDX-License-Identifier: BSD-3-Clause
#include "common/wire/trainer.h"

#include <algorithm>
#include <array>

#include "common/sexpr/reader.h"
#include "common/sexpr/writer.h"

namespace k3d::wire {

namespace {

using sexpr::Node;
using Decoded = std::optional<TrainerCommand>;

// Capitalised on this port, unlike in percepts.
std::string_view capitalised(Side side) {
    return side == Side::Left ? "Left" : side == Side::Right ? "Right" : "None";
}

std::optional<Side> to_side(const std::optional<Node>& node) {
    const std::string_view text = node ? node->atom() : std::string_view{};
    if (text == "Left") return Side::Left;
    if (text == "Right") return Side::Right;
    if (text == "None") return Side::None;
    return std::nullopt;
}

/// The `count` numbers behind the tag of `list`, which must be all it holds.
template <std::size_t count>
std::optional<std::array<double, count>> numbers(const Node& list) {
    if (list.size() != static_cast<int>(count) + 1) return std::nullopt;
    std::array<double, count> values;
    auto n = list.first();
    for (double& value : values) {
        n = n->next();
        const auto number = n->number();
        if (!number) return std::nullopt;
        value = *number;
    }
    return values;
}

/// Beyond this, in m or m/s, nothing of a match can be meant, and physics would break.
constexpr double kMaxCoordinate = 1000.0;
constexpr double kMaxTime = 1e6;  // s
constexpr int kMaxScore = 9999;

std::optional<Vec3> vector_of(double x, double y, double z) {
    const Vec3 v(x, y, z);
    if (v.cwiseAbs().maxCoeff() > kMaxCoordinate) return std::nullopt;
    return v;
}

std::optional<Vec3> vector(const Node& list) {
    const auto v = numbers<3>(list);
    if (!v) return std::nullopt;
    return vector_of((*v)[0], (*v)[1], (*v)[2]);
}

std::optional<int> integer_in(const Node& list, std::string_view tag) {
    const auto group = list.find(tag);
    const auto value = group ? group->at(1) : std::nullopt;
    return value ? value->integer() : std::nullopt;
}

Decoded decode_ball(const Node& list) {
    BallCommand command;
    if (const auto pos = list.find("pos")) {
        command.position = vector(*pos);
        if (!command.position) return std::nullopt;
    }
    if (const auto vel = list.find("vel")) {
        command.velocity = vector(*vel);
        if (!command.velocity) return std::nullopt;
    }
    if (!command.position && !command.velocity) return std::nullopt;
    return command;
}

/// `(unum N)(team Left)`, needed by agent, kill and repos.
bool decode_player(const Node& list, int& unum, Side& team) {
    const auto number = integer_in(list, "unum");
    const auto group = list.find("team");
    const auto side = group ? to_side(group->at(1)) : std::nullopt;
    if (!number || !side) return false;
    unum = *number;
    team = *side;
    return true;
}

/// Whether `(battery v)` or `(temperature v)` is told, which the simulation has no use for.
bool decode_legacy(const Node& list) {
    for (const std::string_view tag : {"battery", "temperature"}) {
        if (const auto group = list.find(tag); group && numbers<1>(*group)) return true;
    }
    return false;
}

Decoded decode_agent(const Node& list) {
    if (list.size() == 1) return ClearSelectedCommand{};
    AgentCommand command;
    if (!decode_player(list, command.unum, command.team)) return std::nullopt;
    if (const auto pos = list.find("pos")) {
        command.position = vector(*pos);
    } else if (const auto move = list.find("move")) {
        if (const auto v = numbers<4>(*move)) {
            command.position = vector_of((*v)[0], (*v)[1], (*v)[2]);
            command.yaw_deg = (*v)[3];
        }
    } else if (decode_legacy(list)) {
        return command;
    }
    if (!command.position) return std::nullopt;
    return command;
}

template <class Command>
Decoded decode_player_command(const Node& list) {
    Command command;
    command.selected = list.size() == 1;
    if (!command.selected && !decode_player(list, command.unum, command.team)) return std::nullopt;
    return command;
}

Decoded decode_select(const Node& list) {
    SelectCommand command;
    if (list.size() == 1) {
        command.who = SelectCommand::Who::Next;
    } else if (list.size() == 2 && integer_in(list, "unum") == -1) {
        command.who = SelectCommand::Who::Nobody;
    } else if (!decode_player(list, command.unum, command.team)) {
        return std::nullopt;
    }
    return command;
}

Decoded decode_score(const Node& list) {
    const auto left = integer_in(list, "left");
    const auto right = integer_in(list, "right");
    if (!left || !right || std::min(*left, *right) < 0 || std::max(*left, *right) > kMaxScore) {
        return std::nullopt;
    }
    return ScoreCommand{*left, *right};
}

Decoded decode_play_mode(const Node& list) {
    if (list.size() != 2 || list.at(1)->is_list()) return std::nullopt;
    return PlayModeCommand{std::string(list.at(1)->atom())};
}

Decoded decode_kick_off(const Node& list) {
    const auto side = to_side(list.at(1));
    if (!side) return std::nullopt;
    return KickOffCommand{*side};
}

Decoded decode_time(const Node& list) {
    const auto time = numbers<1>(list);
    if (!time || (*time)[0] < 0.0 || (*time)[0] > kMaxTime) return std::nullopt;
    return TimeCommand{(*time)[0]};
}

/// None if the command is unknown or damaged.
Decoded decode_one(const Node& node) {
    const std::string_view tag = node.tag();
    if (tag == "ball") return decode_ball(node);
    if (tag == "agent") return decode_agent(node);
    if (tag == "playMode") return decode_play_mode(node);
    if (tag == "kickOff") return decode_kick_off(node);
    if (tag == "dropBall") return DropBallCommand{};
    if (tag == "time") return decode_time(node);
    if (tag == "score") return decode_score(node);
    if (tag == "kill") return decode_player_command<KillCommand>(node);
    if (tag == "repos") return decode_player_command<ReposCommand>(node);
    if (tag == "select") return decode_select(node);
    if (tag == "reqfullstate") return FullStateCommand{};
    if (tag == "killsim") return KillSimCommand{};
    if (tag == "syn") return TrainerSynCommand{};
    if (tag == "init" || tag == "getAck") return IdleCommand{};
    return std::nullopt;
}

/// One overload per command.
struct Encoder {
    std::string& out;

    void number(double value) {
        out += ' ';
        sexpr::append_exact(value, out);
    }
    void vector_group(std::string_view tag, const Vec3& v, const std::optional<double>& fourth) {
        out += '(';
        out += tag;
        for (const double value : v) number(value);
        if (fourth) number(*fourth);
        out += ')';
    }
    void player(std::string_view tag, int unum, Side team) {
        out += '(';
        out += tag;
        out += " (unum ";
        sexpr::append_integer(unum, out);
        out += ")(team ";
        out += capitalised(team);
        out += ')';
    }

    void operator()(const BallCommand& c) {
        out += "(ball";
        if (c.position) {
            out += ' ';
            vector_group("pos", *c.position, std::nullopt);
        }
        if (c.velocity) {
            out += ' ';
            vector_group("vel", *c.velocity, std::nullopt);
        }
        out += ')';
    }
    void operator()(const AgentCommand& c) {
        player("agent", c.unum, c.team);
        if (c.position) {
            vector_group(c.yaw_deg ? "move" : "pos", *c.position, c.yaw_deg);
        } else {
            out += "(battery 0)";
        }
        out += ')';
    }
    void operator()(const ClearSelectedCommand&) { out += "(agent)"; }
    void operator()(const PlayModeCommand& c) {
        out += "(playMode ";
        out += c.mode;
        out += ')';
    }
    void operator()(const KickOffCommand& c) {
        out += "(kickOff ";
        out += capitalised(c.side);
        out += ')';
    }
    void operator()(const DropBallCommand&) { out += "(dropBall)"; }
    void operator()(const TimeCommand& c) {
        out += "(time";
        number(c.time);
        out += ')';
    }
    void operator()(const ScoreCommand& c) {
        out += "(score (left ";
        sexpr::append_integer(c.left, out);
        out += ")(right ";
        sexpr::append_integer(c.right, out);
        out += "))";
    }
    void operator()(const KillCommand& c) {
        if (c.selected) return void(out += "(kill)");
        player("kill", c.unum, c.team);
        out += ')';
    }
    void operator()(const ReposCommand& c) {
        if (c.selected) return void(out += "(repos)");
        player("repos", c.unum, c.team);
        out += ')';
    }
    void operator()(const SelectCommand& c) {
        if (c.who == SelectCommand::Who::Next) return void(out += "(select)");
        if (c.who == SelectCommand::Who::Nobody) return void(out += "(select (unum -1))");
        player("select", c.unum, c.team);
        out += ')';
    }
    void operator()(const FullStateCommand&) { out += "(reqfullstate)"; }
    void operator()(const KillSimCommand&) { out += "(killsim)"; }
    void operator()(const TrainerSynCommand&) { out += "(syn)"; }
    void operator()(const IdleCommand&) { out += "(init)"; }
};

}  // namespace

void encode(const TrainerCommand& command, std::string& out) {
    std::visit(Encoder{out}, command);
}

int decode(std::string_view payload, std::vector<TrainerCommand>& commands) {
    // Kept between calls only for its memory.
    static thread_local sexpr::Document document;
    int faults = document.parse(payload) == sexpr::Error::None ? 0 : 1;
    for (auto node = document.first(); node; node = node->next()) {
        if (auto command = decode_one(*node)) {
            commands.push_back(std::move(*command));
        } else {
            ++faults;
        }
    }
    return faults;
}

}  // namespace k3d::wire

// SPDX-License-Identifier: BSD-3-Clause
#include "common/wire/commands.h"

#include "common/sexpr/reader.h"
#include "common/sexpr/writer.h"

namespace k3d::wire {

namespace {

using sexpr::Node;

constexpr int kRateDecimals = 5;  // 1e-5 rad/s is far below what a motor or a percept resolves

bool decode_scene(const Node& list, Commands& commands) {
    const auto file = list.at(1);
    if (!file || file->is_list()) return false;
    SceneCommand scene;
    scene.file = file->atom();
    for (auto n = file->next(); n; n = n->next()) {
        if (n->is_list()) return false;
        scene.arguments.emplace_back(n->atom());
    }
    commands.scene = std::move(scene);
    return true;
}

bool decode_init(const Node& list, Commands& commands) {
    InitCommand init;
    if (const auto group = list.find("unum")) {
        const auto unum = group->at(1);
        const auto value = unum ? unum->integer() : std::nullopt;
        if (!value) return false;
        init.unum = *value;
    }
    if (const auto group = list.find("teamname")) {
        const auto team = group->at(1);
        if (!team || team->is_list()) return false;
        init.team = team->atom();
    }
    commands.init = std::move(init);
    return true;
}

// Arguments too many are ignored, as the reference does: `(say two words)` says "two".

std::optional<double> number_at(const Node& list, int position) {
    const auto n = list.at(position);
    return n ? n->number() : std::nullopt;
}

bool decode_beam(const Node& list, Commands& commands) {
    const auto x = number_at(list, 1);
    const auto y = number_at(list, 2);
    const auto angle = number_at(list, 3);
    if (!x || !y || !angle) return false;
    commands.beam = BeamCommand{*x, *y, *angle};
    return true;
}

bool decode_say(const Node& list, Commands& commands) {
    const auto text = list.at(1);
    if (!text || text->is_list()) return false;
    commands.say.emplace_back(text->atom());
    return true;
}

bool decode_joint(nao::JointId id, const Node& list, Commands& commands) {
    const auto rate = number_at(list, 1);
    if (!rate) return false;
    commands.joint_rates[nao::index(id)] = *rate;
    return true;
}

/// Joints come in the order of the ids, mostly: number `next` is tried before a search.
std::optional<nao::JointId> joint_named(std::string_view name, std::size_t& next) {
    auto joint = static_cast<nao::JointId>(next);
    if (nao::effector_name(joint) != name) {
        const auto found = nao::joint_by_effector(name);
        if (!found) return std::nullopt;
        joint = *found;
    }
    next = (nao::index(joint) + 1) % nao::kJointCount;
    return joint;
}

/// False if the command is unknown or damaged. `next`: of the joint expected.
bool decode_one(const Node& node, std::size_t& next, Commands& commands) {
    const std::string_view tag = node.tag();
    if (tag == "syn") return commands.syn = true;
    if (const auto joint = joint_named(tag, next)) return decode_joint(*joint, node, commands);
    if (tag == "say") return decode_say(node, commands);
    if (tag == "beam") return decode_beam(node, commands);
    if (tag == "scene") return decode_scene(node, commands);
    if (tag == "init") return decode_init(node, commands);
    if (tag == "pass") return commands.pass = true;
    return false;
}

void append_argument(double value, std::string& out) {
    out += ' ';
    sexpr::append_exact(value, out);
}

}  // namespace

void encode(const Commands& commands, std::string& out) {
    for (std::size_t i = 0; i < nao::kJointCount; ++i) {
        if (!commands.joint_rates[i]) continue;
        out += '(';
        out += nao::effector_name(static_cast<nao::JointId>(i));
        out += ' ';
        sexpr::append_fixed(*commands.joint_rates[i], kRateDecimals, out);
        out += ')';
    }
    if (commands.scene) {
        out += "(scene ";
        out += commands.scene->file;
        for (const std::string& argument : commands.scene->arguments) {
            out += ' ';
            out += argument;
        }
        out += ')';
    }
    if (commands.init) {
        out += "(init (unum ";
        sexpr::append_integer(commands.init->unum, out);
        out += ')';
        if (!commands.init->team.empty()) {
            out += "(teamname ";
            out += commands.init->team;
            out += ')';
        }
        out += ')';
    }
    if (commands.beam) {
        out += "(beam";
        append_argument(commands.beam->x, out);
        append_argument(commands.beam->y, out);
        append_argument(commands.beam->angle_deg, out);
        out += ')';
    }
    for (const std::string& text : commands.say) {
        out += "(say ";
        out += text;
        out += ')';
    }
    if (commands.pass) out += "(pass)";
    if (commands.syn) out += "(syn)";
}

int decode(std::string_view payload, Commands& commands) {
    // Kept between calls only for its memory.
    static thread_local sexpr::Document document;
    int faults = document.parse(payload) == sexpr::Error::None ? 0 : 1;
    std::size_t next = 0;
    for (auto node = document.first(); node; node = node->next()) {
        if (!decode_one(*node, next, commands)) ++faults;
    }
    return faults;
}

}  // namespace k3d::wire

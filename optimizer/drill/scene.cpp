// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/drill/scene.h"

namespace k3d::optimizer::drill {

namespace {

using sexpr::Node;

bool has(const Node& list, std::string_view atom) {
    for (auto n = list.first(); n; n = n->next()) {
        if (n->is_atom() && n->atom() == atom) return true;
    }
    return false;
}

bool ends_with(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

double number_at(const Node& list, int position) {
    const auto item = list.at(position);
    const auto value = item ? item->number() : std::nullopt;
    if (!value) {
        throw SceneError("monitor frame: number " + std::to_string(position) + " of (" +
                         std::string(list.tag()) + " ..) is missing or damaged");
    }
    return *value;
}

template <std::size_t N>
void read_numbers(const Node& list, std::array<double, N>& out) {
    auto node = list.first();
    for (std::size_t i = 0; i < N; ++i) {
        node = node ? node->next() : std::nullopt;
        const auto value = node ? node->number() : std::nullopt;
        if (!value) throw SceneError("monitor frame: a transform lacks numbers");
        out[i] = *value;
    }
}

}  // namespace

const Truth& Scene::read(std::string_view frame) {
    if (document_.parse(frame) != sexpr::Error::None) {
        throw SceneError("monitor frame: not an expression: " + std::string(frame.substr(0, 60)));
    }
    const auto state = document_.first();
    const auto header = state ? state->next() : std::nullopt;
    const auto scene = header ? header->next() : std::nullopt;
    if (!scene) throw SceneError("monitor frame: state, header or scene is missing");
    const bool full = header->tag() == "RSG";
    if (!full && header->tag() != "RDS") {
        throw SceneError("monitor frame: header '" + std::string(header->tag()) + "'");
    }
    read_state(*state);
    if (full) {
        items_.clear();
        ball_ = torso_ = -1;
        for (auto n = scene->first(); n; n = n->next()) add(*n, -1);
    } else if (!items_.empty()) {
        std::size_t next = 0;
        for (auto n = scene->first(); n; n = n->next()) change(*n, next);
        if (next != items_.size()) throw SceneError("monitor frame: a difference of another shape");
    }
    look();
    return truth_;
}

void Scene::read_state(const Node& state) {
    if (const auto modes = state.find("play_modes")) {
        modes_.clear();
        for (auto n = modes->first()->next(); n; n = n->next()) modes_.emplace_back(n->atom());
    }
    if (const auto time = state.find("time")) truth_.time = number_at(*time, 1);
    if (const auto mode = state.find("play_mode")) {
        const auto index = static_cast<std::size_t>(number_at(*mode, 1));
        if (index >= modes_.size()) {
            throw SceneError("monitor frame: play mode " + std::to_string(index) + " of " +
                             std::to_string(modes_.size()));
        }
        truth_.play_mode = modes_[index];
    }
}

void Scene::add(const Node& node, int parent) {
    const int self = static_cast<int>(items_.size());
    items_.push_back({parent, false, {}});
    const auto kind = node.at(1);
    if (kind && kind->is_atom() && kind->atom() == "StaticMesh") note_mesh(node, parent);
    for (auto n = node.first(); n; n = n->next()) {
        if (n->tag() == "SLT") {
            Item& item = items_[static_cast<std::size_t>(self)];
            item.transform = true;
            read_numbers(*n, item.matrix);
        } else if (n->tag() == "nd") {
            add(*n, self);
        }
    }
}

void Scene::note_mesh(const Node& node, int parent) {
    const auto load = node.find("load");
    const auto file = load ? load->at(1) : std::nullopt;
    if (!file) return;
    if (ends_with(file->atom(), "soccerball.obj")) ball_ = parent;
    const bool body = file->atom().find("naobody") != std::string_view::npos;
    const auto materials = node.find("resetMaterials");
    if (body && materials && has(*materials, "matNum1") && has(*materials, "matLeft")) {
        torso_ = parent;
    }
}

void Scene::change(const Node& node, std::size_t& next) {
    if (next >= items_.size()) throw SceneError("monitor frame: a difference of another shape");
    Item& item = items_[next++];
    for (auto n = node.first(); n; n = n->next()) {
        if (n->tag() == "SLT") {
            read_numbers(*n, item.matrix);
        } else if (n->tag() == "nd") {
            change(*n, next);
        }
    }
}

Eigen::Matrix4d Scene::world(int item) const {
    Eigen::Matrix4d total = Eigen::Matrix4d::Identity();
    for (; item >= 0; item = items_[static_cast<std::size_t>(item)].parent) {
        const Item& i = items_[static_cast<std::size_t>(item)];
        if (i.transform) total = Eigen::Map<const Eigen::Matrix4d>(i.matrix.data()) * total;
    }
    return total;
}

void Scene::look() {
    if (ball_ >= 0) truth_.ball = world(ball_).topRightCorner<3, 1>();
    truth_.robot.reset();
    if (torso_ < 0) return;
    // The body's mesh stands turned in its own transform: its z axis points forward, its y axis up
    // (reference 8.4).
    const Eigen::Matrix4d mesh = world(torso_);
    RobotTruth robot;
    robot.torso = mesh.topRightCorner<3, 1>();
    robot.pose = {robot.torso.head<2>(), std::atan2(mesh(1, 2), mesh(0, 2))};
    robot.up = mesh(2, 1);
    truth_.robot = robot;
}

}  // namespace k3d::optimizer::drill

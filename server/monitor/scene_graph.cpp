// SPDX-License-Identifier: BSD-3-Clause
#include "server/monitor/scene_graph.h"

#include "common/field/field.h"
#include "server/monitor/looks.h"

namespace k3d::server::monitor {

namespace {

Matrix matrix(const Vec3& right, const Vec3& up, const Vec3& forward, const Vec3& position) {
    Matrix m{right.x(),   right.y(),   right.z(),   0, up.x(),       up.y(),       up.z(),       0,
             forward.x(), forward.y(), forward.z(), 0, position.x(), position.y(), position.z(), 1};
    for (double& element : m) element += 0.0;  // -0 becomes 0
    return m;
}

Matrix moved(const Vec3& position) {
    return matrix(Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), position);
}

Matrix pose(const Quat& rotation, const Vec3& position) {
    const Eigen::Matrix3d m = rotation.toRotationMatrix();
    return matrix(m.col(0), m.col(1), m.col(2), position);
}

/// From a mesh that was drawn with y up, looking along z, to a body's axes.
const Matrix kTurned = matrix(-Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY(), Vec3::Zero());

/// Appends nodes at the depth it is told.
class Builder {
  public:
    explicit Builder(std::vector<Node>& nodes) : nodes_(nodes) {}

    std::size_t transform(int depth, const Matrix& at) {
        Node& node = nodes_.emplace_back();
        node.depth = depth;
        node.transform = at;
        return nodes_.size() - 1;
    }
    std::size_t leaf(int depth, NodeKind kind, std::string look) {
        Node& node = nodes_.emplace_back();
        node.depth = depth;
        node.kind = kind;
        node.look = std::move(look);
        return nodes_.size() - 1;
    }
    Node& transparent_leaf(int depth, NodeKind kind, std::string look) {
        Node& node = nodes_[leaf(depth, kind, std::move(look))];
        node.transparent = true;
        return node;
    }

  private:
    std::vector<Node>& nodes_;
};

void add_lights_and_backdrop(Builder& add) {
    add.transform(0, moved({-10, 10, 10}));
    add.leaf(1, NodeKind::Light, light("0.8"));
    add.transform(0, moved({10, -10, 10}));
    add.leaf(1, NodeKind::Light, light("0"));
    add.transform(0, kTurned);
    add.leaf(1, NodeKind::StaticMesh,
             static_mesh("naosoccerfield", {2.5, 1, 2.5}, "None_rcs-naofield.png"));
    std::string sky;
    for (int side = 1; side <= 6; ++side) {
        sky += (side == 1 ? "" : " ") + ("Material_skyrender_000" + std::to_string(side)) + ".tif";
    }
    add.transform(0, kTurned);
    add.leaf(1, NodeKind::StaticMesh, static_mesh("skybox", Vec3::Constant(10), sky));
}

/// A goal with the places of its panels and flags, in a frame whose x points into the field.
void add_goal(Builder& add, bool left) {
    constexpr double kOffset = field::kLength / 2.0 + field::kGoalDepth / 2.0;
    const double into_field = left ? 1.0 : -1.0;
    add.transform(0, matrix(into_field * Vec3::UnitX(), into_field * Vec3::UnitY(), Vec3::UnitZ(),
                            {-into_field * kOffset, 0, field::kGoalHeight / 2.0}));
    add.transform(1, matrix(Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX(), {0.3, 0, -0.4}));
    add.transparent_leaf(2, NodeKind::StaticMesh,
                         static_mesh(left ? "leftsoccergoal" : "rightsoccergoal",
                                     {2.18, 0.88, 0.68},
                                     left ? "naogoalnet yellow" : "naogoalnet sky-blue"));
    for (const Vec3& part : {Vec3(0, -1.07, 0), Vec3(0, 1.07, 0), Vec3(-0.28, 0, 0),
                             Vec3(0, 0, 0.42), Vec3(0.3, 1.05, 0.4), Vec3(0.3, -1.05, 0.4)}) {
        add.transform(1, moved(part));
    }
}

void add_walls_and_marks(Builder& add) {
    for (const char* name : {"wall-left", "wall-right", "wall-back", "wall-front"}) {
        for (const field::SolidBox& box : field::solids()) {
            if (box.name != name) continue;
            add.transform(0, moved(box.centre));
            add.leaf(1, NodeKind::SingleMesh, single_mesh("StdUnitBox", box.size, "matGrey"));
        }
    }
    for (const field::LandmarkDef& mark : field::kLandmarks) {
        // The posts' flags belong to the goals.
        if (mark.name.front() == 'F') add.transform(0, moved({mark.x, mark.y, mark.z}));
    }
    for (int line = 0; line < field::kLineCount; ++line) add.transform(0, moved(Vec3::Zero()));
}

}  // namespace

SceneGraph::SceneGraph() { build(); }

void SceneGraph::update(const body::Scene& scene) {
    std::vector<Robot> robots;
    for (const auto& player : scene.players) {
        robots.push_back({player->id, player->robot->model().type, player->unum, player->team});
    }
    if (robots != robots_) {
        robots_ = std::move(robots);
        build();
    }
    nodes_[ball_].transform = pose(scene.ball.rotation(), scene.ball.position());
    std::size_t part = 0;
    for (std::size_t i = 0; i < scene.players.size(); ++i) {
        const body::Robot& robot = *scene.players[i]->robot;
        for (std::size_t k = 0; k < robot.model().bodies.size(); ++k) {
            nodes_[parts_[part++]].transform = pose(robot.rotation(k), robot.position(k));
        }
        nodes_[markers_[i]].visible = scene.players[i]->selected;
    }
}

void SceneGraph::build() {
    nodes_.clear();
    parts_.clear();
    markers_.clear();
    Builder add(nodes_);
    add_lights_and_backdrop(add);
    add_goal(add, true);
    add_goal(add, false);
    add_walls_and_marks(add);
    ball_ = add.transform(0, moved({0, 0, field::kBallRadius}));
    add.leaf(1, NodeKind::StaticMesh,
             static_mesh("soccerball", Vec3::Constant(field::kBallRadius),
                         "soccerball_rcs-soccerball.png"));
    for (const Robot& robot : robots_) {
        add.transform(0, moved(Vec3::Zero()));  // what makes the parts one robot
        for (const nao::BodyDef& body : nao::model(robot.type).bodies) {
            parts_.push_back(add.transform(1, moved(Vec3::Zero())));
            const PartLook part = look_of(body, robot.type, robot.unum, robot.team);
            if (part.turned) add.transform(2, kTurned);
            add.leaf(part.turned ? 3 : 2, part.kind, part.look);
            if (body.part != nao::Part::Torso) continue;
            add.transform(2, moved(Vec3::Zero()));
            add.transparent_leaf(3, NodeKind::SingleMesh,
                                 single_mesh("StdUnitCylinder 1 1", {0.2, 0.2, 0.02}, "matSelect"));
            markers_.push_back(nodes_.size() - 1);
        }
    }
    ++revision_;
}

}  // namespace k3d::server::monitor

// SPDX-License-Identifier: BSD-3-Clause
// The scene as monitors know it: a tree of transforms, lights and meshes (reference 8.3).
//
// Node kinds, order, mesh files and materials are the reference server's, so that its monitors find
// ball, goals and robots: each robot is one top-level node, with a transform per body in the order
// of nao::model(type).bodies. Transforms are relative to the parent node; m, field frame.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "server/body/scene.h"

namespace k3d::server::monitor {

/// Column by column: right, 0, up, 0, forward, 0, position, 1; the columns are the node's axes.
using Matrix = std::array<double, 16>;

enum class NodeKind { Transform, Light, StaticMesh, SingleMesh };

struct Node {
    NodeKind kind = NodeKind::Transform;
    int depth = 0;           ///< 0: a child of the root
    Matrix transform{};      ///< of a Transform
    bool visible = true;     ///< of a mesh
    bool transparent = false;
    std::string look;        ///< of meshes and lights: what stands behind visibility in a full frame
};

class SceneGraph {
  public:
    SceneGraph();

    /// Takes over poses and selections; builds the robots anew if others play than before.
    void update(const body::Scene& scene);

    /// Parents stand before their children, children in order.
    const std::vector<Node>& nodes() const { return nodes_; }
    /// Counts the builds: another number means another structure.
    int revision() const { return revision_; }

  private:
    /// What the structure follows from.
    struct Robot {
        int id, type, unum;
        wire::Side team;
        bool operator==(const Robot&) const = default;
    };
    void build();

    std::vector<Node> nodes_;
    std::size_t ball_ = 0;         ///< node of the ball's transform
    std::vector<Robot> robots_;
    std::vector<std::size_t> parts_;    ///< nodes of all robots' bodies, robot by robot
    std::vector<std::size_t> markers_;  ///< node of each robot's selection marker
    int revision_ = 0;
};

}  // namespace k3d::server::monitor

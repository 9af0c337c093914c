// SPDX-License-Identifier: BSD-3-Clause
// What monitors draw: mesh files, scales and materials of the reference (8.3, 8.4), as the text that
// stands behind `(setVisible 1)` in a full frame.
#pragma once

#include <string>
#include <string_view>

#include "common/field/field.h"
#include "common/nao/model.h"
#include "common/wire/percepts.h"
#include "server/monitor/scene_graph.h"

namespace k3d::server::monitor {

/// A mesh whose own axes are not the body's stands in one more transform.
struct PartLook {
    NodeKind kind;
    std::string look;
    bool turned = false;
};

/// A robot's body; unum 0 and no team mean that it has no seat yet.
PartLook look_of(const nao::BodyDef& body, int type, int unum, wire::Side team);

std::string static_mesh(std::string_view file, const Vec3& scale, std::string_view materials);
std::string single_mesh(std::string_view primitive, const Vec3& scale, std::string_view material);
std::string light(std::string_view ambient);

}  // namespace k3d::server::monitor

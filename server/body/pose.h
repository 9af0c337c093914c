// SPDX-License-Identifier: BSD-3-Clause
// Reads an ODE body's state as our vectors. For server/body only.
#pragma once

#include <ode/ode.h>

#include "common/math/geometry.h"

namespace k3d::server::body {

inline Vec3 position_of(dBodyID body) {
    const dReal* p = dBodyGetPosition(body);
    return {p[0], p[1], p[2]};
}
inline Quat rotation_of(dBodyID body) {
    const dReal* q = dBodyGetQuaternion(body);
    return {q[0], q[1], q[2], q[3]};
}
inline Vec3 velocity_of(dBodyID body) {
    const dReal* v = dBodyGetLinearVel(body);
    return {v[0], v[1], v[2]};
}
inline Vec3 angular_velocity_of(dBodyID body) {
    const dReal* w = dBodyGetAngularVel(body);
    return {w[0], w[1], w[2]};
}

}  // namespace k3d::server::body

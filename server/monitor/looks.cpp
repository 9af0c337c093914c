// SPDX-License-Identifier: BSD-3-Clause
#include "server/monitor/looks.h"

#include <fmt/format.h>

#include "common/sexpr/writer.h"

namespace k3d::server::monitor {

namespace {

using nao::Part;

std::string scale_text(const Vec3& scale) {
    std::string text = " (sSc";
    for (const double s : scale) {
        text += ' ';
        sexpr::append_general(s, text);
    }
    return text + ")";
}

/// The materials by which monitors tell robots apart, before the plain colours.
struct Materials {
    std::string side, number, type;

    Materials(int robot_type, int unum, wire::Side team)
        : side(team == wire::Side::Left    ? "matLeft"
               : team == wire::Side::Right ? "matRight"
                                           : "matTeam"),
          number(unum > 0 ? fmt::format("matNum{} ", unum) : "matNum "),
          // The reference has no material for the type with toes.
          type(robot_type < 4 ? fmt::format(" matType{}", robot_type) : "") {}
};

PartLook mesh(const std::string& file, double scale, const std::string& materials) {
    return {NodeKind::StaticMesh, static_mesh(file, Vec3::Constant(scale), materials + " naowhite")};
}

PartLook joint_ball(std::string_view material) {
    return {NodeKind::SingleMesh, single_mesh("StdUnitSphere", Vec3::Constant(0.01), material)};
}

/// A foot or toe: one mesh, stretched so that both together are as long as a foot without toe.
PartLook foot(char side, const Vec3& scale, const Materials& m) {
    return {NodeKind::StaticMesh,
            static_mesh(fmt::format("{}foot", side), scale, m.side + " naowhite")};
}

}  // namespace

std::string static_mesh(std::string_view file, const Vec3& scale, std::string_view materials) {
    return fmt::format("(load models/{}.obj){}(resetMaterials {})", file, scale_text(scale),
                       materials);
}

std::string single_mesh(std::string_view primitive, const Vec3& scale, std::string_view material) {
    return fmt::format("(load {}){} (sMat {})", primitive, scale_text(scale), material);
}

std::string light(std::string_view ambient) {
    return fmt::format("(setDiffuse 1 1 1 1) (setAmbient {0} {0} {0} 1) (setSpecular 0.1 0.1 0.1 1)",
                       ambient);
}

PartLook look_of(const nao::BodyDef& body, int type, int unum, wire::Side team) {
    const Materials m(type, unum, team);
    const char side = body.name.front() == 'r' ? 'r' : 'l';  // of limbs
    switch (body.part) {
        case Part::Torso: {
            PartLook look = mesh(fmt::format("naobody{}", type), 0.1, m.number + m.side + m.type);
            look.turned = true;
            return look;
        }
        case Part::Neck:
            return {NodeKind::SingleMesh,
                    single_mesh("StdCapsule 0.015 0.08", Vec3::Ones(), "matDarkGrey")};
        case Part::Head: {
            PartLook look = mesh("naohead", 0.1, m.side + " naoblack naogrey");
            look.turned = true;
            return look;
        }
        case Part::RUpperArm:
        case Part::LUpperArm:
            return mesh(fmt::format("{}upperarm{}", side, type), 0.07, m.side + m.type);
        case Part::RLowerArm:
        case Part::LLowerArm:
            return mesh(fmt::format("{}lowerarm", side), 0.05, m.side);
        case Part::RThigh:
            return mesh("rthigh", 0.07, m.number + m.side);
        case Part::LThigh:
            return mesh("lthigh", 0.07, m.side);
        case Part::RShank:
        case Part::LShank:
            return mesh(fmt::format("{}shank{}", side, type), 0.08, m.side + m.type);
        case Part::RFoot:
        case Part::LFoot:
            return foot(side, Vec3(0.08, type == 4 ? 0.062241 : 0.08, 0.08), m);
        case Part::RToe:
        case Part::LToe:
            return foot(side, Vec3(0.08, 0.0228259, 0.04), m);
        case Part::RAnkle:
        case Part::LAnkle:
            return joint_ball("matRed");
        default:  // shoulders, elbows, hips
            return joint_ball("matYellow");
    }
}

}  // namespace k3d::server::monitor

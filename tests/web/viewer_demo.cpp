// SPDX-License-Identifier: BSD-3-Clause
// A moving scene shown through the real Viewer, without physics: for tests of the page, and for
// work on it. Five robots walk in circles, the ball rolls between them.
// usage: viewer_demo [PORT [WEB-FOLDER [EPISODE]]]   prints `ready http=PORT`; runs until ended
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "common/clock/clock.h"
#include "common/nao/model.h"
#include "server/viewer/viewer.h"

namespace {

using namespace k3d;

/// A swing of arms and legs, `phase` in rad.
nao::JointArray stride(double phase) {
    nao::JointArray angles{};
    const double swing = std::sin(phase);
    const auto set = [&](nao::JointId id, double deg) { angles[nao::index(id)] = radians(deg); };
    set(nao::JointId::RShoulderPitch, -80 - 25 * swing);
    set(nao::JointId::LShoulderPitch, -80 + 25 * swing);
    set(nao::JointId::RElbow, 40);
    set(nao::JointId::LElbow, -40);
    set(nao::JointId::RHipPitch, 25 + 20 * swing);
    set(nao::JointId::LHipPitch, 25 - 20 * swing);
    set(nao::JointId::RKneePitch, -45);
    set(nao::JointId::LKneePitch, -45);
    set(nao::JointId::RAnklePitch, 20 - 20 * swing);
    set(nao::JointId::LAnklePitch, 20 + 20 * swing);
    set(nao::JointId::HeadYaw, 40 * std::sin(phase / 5));
    return angles;
}

/// Poses of all parts of a robot whose torso is at `torso`, looking along `yaw`.
std::vector<server::viewer::PartPose> parts_of(int type, const Vec3& torso, double yaw,
                                               const nao::JointArray& angles) {
    const nao::Model& model = nao::model(type);
    std::vector<server::viewer::PartPose> parts(model.bodies.size());
    // A body looks along its y axis.
    parts[0] = {torso, Quat(Eigen::AngleAxisd(yaw - kPi / 2, Vec3::UnitZ()))};
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const nao::BodyDef& body = model.bodies[i];
        const nao::JointDef& joint = model.joints[i - 1];
        const server::viewer::PartPose& parent = parts[static_cast<std::size_t>(body.parent)];
        const double angle = angles[nao::index(joint.id)];
        parts[i].rotation = parent.rotation * Quat(Eigen::AngleAxisd(angle, joint.axis));
        parts[i].position = parent.position + parent.rotation * (body.offset + joint.anchor) -
                            parts[i].rotation * joint.anchor;
    }
    return parts;
}

server::viewer::SceneView scene_at(double time, int episode) {
    struct Walker {
        wire::Side team;
        int unum;
        Vec2 centre;
    };
    static const std::array<Walker, 5> kWalkers{{
        {wire::Side::Left, 1, {-3.5, -3.0}},
        {wire::Side::Left, 2, {3.5, -2.5}},
        {wire::Side::Left, 3, {0.5, 3.5}},
        {wire::Side::Right, 1, {-1.2, 0.2}},
        {wire::Side::Right, 2, {1.4, 0.6}},
    }};
    server::viewer::SceneView scene;
    scene.time = time;
    scene.game_time = time;
    scene.play_mode = time < 3.0 ? "BeforeKickOff" : "PlayOn";
    scene.team_left = "keepers";
    scene.team_right = "takers";
    scene.episode = episode;
    // It shrinks as the league's does, again and again.
    scene.area = Vec2::Constant(10.0 - std::fmod(time, 30.0) / 15.0);
    for (const Walker& walker : kWalkers) {
        const double way = 0.5 * time + walker.unum;
        const Vec2 at = walker.centre + 0.8 * direction(way);
        scene.robots.push_back(
            {walker.team, walker.unum, 0,
             parts_of(0, {at.x(), at.y(), 0.36}, way + kPi / 2, stride(8.0 * time + walker.unum))});
    }
    const double way = 0.4 * time;
    const double radius = 0.042;
    scene.ball.position = {2.0 * std::cos(way), -2.5 + 0.8 * std::sin(way), radius};
    scene.ball.rotation = Quat(Eigen::AngleAxisd(-time * 6, Vec3(0.3, 1, 0).normalized()));
    return scene;
}

int run(int argc, char** argv) {
    const auto number = [&](int i, int otherwise) {
        return argc > i ? std::atoi(argv[i]) : otherwise;
    };
    net::Loop loop;
    server::viewer::Viewer viewer(loop, "127.0.0.1", static_cast<std::uint16_t>(number(1, 0)),
                                  argc > 2 ? argv[2] : server::viewer::web_folder_beside_program());
    std::printf("ready http=%d\n", viewer.port());
    std::fflush(stdout);
    const auto start = net::Clock::now();
    for (Cycle cycle;; ++cycle) {
        const auto due = start + std::chrono::milliseconds(20) * cycle.count;
        loop.wait(due, [] { return false; });
        if (viewer.watched()) viewer.publish(scene_at(cycle.seconds(), number(3, 1)));
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "viewer_demo: %s\n", error.what());
        return 1;
    }
}

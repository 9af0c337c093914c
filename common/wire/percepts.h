// SPDX-License-Identifier: BSD-3-Clause
// One percept frame, server to agent: what the text means, and its two codecs.
//
// Values are as on the wire: degrees, deg/s, m, m/s^2, N, body frames (x right, y forward, z up);
// the agent's perception stage converts. Text form: SimSpark reference 3. Two decimals, one blank
// after every tag, never an exponent.
#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/field/field.h"
#include "common/math/geometry.h"
#include "common/nao/model.h"

namespace k3d::wire {

/// `(pol d theta phi)`: distance m, theta positive to the left, phi positive up, degrees.
struct Pol {
    double distance = 0.0;
    double theta_deg = 0.0;
    double phi_deg = 0.0;
};

enum class Side { Left, Right, None };

inline constexpr std::string_view side_name(Side side) {
    return side == Side::Left ? "left" : side == Side::Right ? "right" : "none";
}

inline constexpr int kMaxUnum = 11;  ///< players of a team have the numbers from 1 on

struct GameState {
    std::optional<int> unum;    ///< once, in the first frame after the team was assigned
    std::optional<Side> team;   ///< with unum
    int score_left = 0;
    int score_right = 0;
    double time = 0.0;          ///< game time, s
    std::string play_mode;      ///< "PlayOn", names of reference 7.1
};

/// `(hear TEAM time self|direction text)`.
struct Heard {
    std::string team;
    double time = 0.0;                     ///< game time, s
    std::optional<double> direction_deg;   ///< none: the listener's own message
    std::string text;
};

/// `(FRP (n rf) (c ..) (f ..))`: foot frame.
struct FootForce {
    Vec3 point = Vec3::Zero();
    Vec3 force = Vec3::Zero();
};
enum class FootSensor { Right, Left, RightToe, LeftToe };
inline constexpr std::size_t kFootSensorCount = 4;
inline constexpr std::array<std::string_view, kFootSensorCount> kFootNames{"rf", "lf", "rf1",
                                                                           "lf1"};

/// `(P (team T) (id N) (head (pol ..)) ...)`: parts out of view are absent.
struct SeenPlayer {
    std::string team;
    int unum = 0;
    std::optional<Pol> head, rlowerarm, llowerarm, rfoot, lfoot;
};

struct SeenLine {
    Pol begin, end;
};

/// `(See ..)`: origin at the head's centre, axes of the head (after the reference's theta - 90).
struct See {
    std::array<std::optional<Pol>, field::kLandmarkCount> landmarks;  ///< by field::Landmark
    std::optional<Pol> ball;
    std::vector<SeenPlayer> players;
    std::vector<SeenLine> lines;
    // Ground truth, only from a server started with --ground-truth.
    std::optional<Vec3> my_position;
    std::optional<double> my_orientation_deg;
    std::optional<Vec3> ball_position;
};

struct Percepts {
    double time = 0.0;  ///< `now`, s
    std::optional<GameState> game;
    std::vector<Heard> heard;
    Vec3 gyro_deg = Vec3::Zero();       ///< torso frame, deg/s
    Vec3 acceleration = Vec3::Zero();   ///< torso frame, m/s^2; (0, 0, 9.81) at rest
    nao::JointArray joints_deg{};       ///< valid where has_joint is set
    std::bitset<nao::kJointCount> has_joint;
    std::array<std::optional<FootForce>, kFootSensorCount> feet;
    std::optional<See> see;             ///< absent in cycles without vision

    /// Of no meaning: what a frame lacks lends its memory to one that has it, in decode().
    struct Spare {
        See see;
        std::vector<Heard> heard;
    };
    Spare spare;
};

/// No time, angle, length or force of a match is as large.
inline constexpr double kLargestPercept = 1e9;

/// Appends the frame's payload (no length prefix) to `out`, in the order of reference 3.2.
/// Players of See stand where the caller put them. `model` fixes which joints are sent.
void encode(const Percepts& percepts, const nao::Model& model, std::string& out);

/// Parses a payload into `percepts` (which is reset first; buffers are reused).
/// Unknown groups are skipped and counted, damaged ones (a number beyond kLargestPercept is damage,
/// too) dropped and counted: the return value is that count, 0 for a clean frame. Never throws,
/// whatever the bytes.
int decode(std::string_view payload, Percepts& percepts);

}  // namespace k3d::wire

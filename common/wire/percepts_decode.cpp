// SPDX-License-Identifier: BSD-3-Clause
// Reading a percept frame. Every group is judged alone: what is unknown or damaged is counted and
// left out, the rest of the frame stands.
#include <cmath>

#include "common/sexpr/reader.h"
#include "common/wire/percepts.h"

namespace k3d::wire {

namespace {

using sexpr::Node;

// What a full See holds; more only takes more memory.
constexpr std::size_t kUsualPlayers = 21;
constexpr std::size_t kUsualLines = 32;

/// Whoever squares or multiplies what is left gets no infinity, and no nan from one.
std::optional<double> number(const Node& node) {
    const auto value = node.number();
    return value && std::abs(*value) <= kLargestPercept ? value : std::nullopt;
}

/// The number after `previous`; moves `previous` on to it.
std::optional<double> next_number(std::optional<Node>& previous) {
    if (previous) previous = previous->next();
    return previous ? number(*previous) : std::nullopt;
}

/// `(tag x)`
std::optional<double> one_number(const Node& list) {
    auto n = list.first();
    const auto value = next_number(n);
    if (!value || n->next()) return std::nullopt;
    return value;
}

std::optional<int> one_integer(const Node& list) {
    const auto n = list.at(1);
    if (!n || n->next()) return std::nullopt;
    return n->integer();
}

/// `(tag word)`; empty if it is anything else.
std::string_view one_word(const Node& list) {
    const auto n = list.at(1);
    return n && !n->next() ? n->atom() : std::string_view{};
}

/// `(tag x y z)`
std::optional<Vec3> vector(const Node& list) {
    auto n = list.first();
    const auto x = next_number(n);
    const auto y = next_number(n);
    const auto z = next_number(n);
    if (!x || !y || !z || n->next()) return std::nullopt;
    return Vec3(*x, *y, *z);
}

std::optional<Vec3> vector_in(const Node& list, std::string_view tag) {
    const auto group = list.find(tag);
    return group ? vector(*group) : std::nullopt;
}

/// `(pol d theta phi)`
std::optional<Pol> pol(const std::optional<Node>& node) {
    if (!node || node->tag() != "pol") return std::nullopt;
    const auto v = vector(*node);
    if (!v) return std::nullopt;
    return Pol{v->x(), v->y(), v->z()};
}

/// `(tag (pol ..))`
std::optional<Pol> one_pol(const Node& list) {
    const auto n = list.at(1);
    return n && !n->next() ? pol(n) : std::nullopt;
}

std::optional<int> unum_of(const Node& list) {
    const auto value = one_integer(list);
    return value && *value >= 1 && *value <= kMaxUnum ? value : std::nullopt;
}

std::optional<Side> side_of(const Node& list) {
    const std::string_view word = one_word(list);
    if (word == "left") return Side::Left;
    if (word == "right") return Side::Right;
    if (word == "none") return Side::None;
    return std::nullopt;
}

template <class Value, class Target>
bool take(const std::optional<Value>& value, Target& target) {
    if (value) target = *value;
    return value.has_value();
}

class Decoder {
  public:
    explicit Decoder(Percepts& percepts) : percepts_(percepts) {}

    int run(std::string_view payload) {
        reset();
        // Kept between calls only for its memory.
        static thread_local sexpr::Document document;
        int faults = document.parse(payload) == sexpr::Error::None ? 0 : 1;
        for (auto node = document.first(); node; node = node->next()) faults += group(*node);
        if (!has_game_) percepts_.game.reset();
        if (!has_see_ && percepts_.see) {
            percepts_.spare.see = std::move(*percepts_.see);
            percepts_.see.reset();
        }
        return faults;
    }

  private:
    /// Empties the frame but for the memory of game and See, which most frames use again.
    void reset() {
        constexpr std::size_t kKept = 8;
        percepts_.heard.reserve(kKept);
        percepts_.spare.heard.reserve(kKept);
        percepts_.time = 0.0;
        for (Heard& heard : percepts_.heard) {
            auto& kept = percepts_.spare.heard;
            if (kept.size() < kKept) kept.push_back(std::move(heard));
        }
        percepts_.heard.clear();
        percepts_.gyro_deg = Vec3::Zero();
        percepts_.acceleration = Vec3::Zero();
        percepts_.joints_deg.fill(0.0);
        percepts_.has_joint.reset();
        percepts_.feet.fill(std::nullopt);
    }

    /// All group readers return the number of faults.
    int group(const Node& node) {
        const std::string_view tag = node.tag();
        if (tag == "HJ") return hinge(node);
        if (tag == "FRP") return foot(node);
        if (tag == "See") return see(node);
        if (tag == "GYR") return take(vector_in(node, "rt"), percepts_.gyro_deg) ? 0 : 1;
        if (tag == "ACC") return take(vector_in(node, "a"), percepts_.acceleration) ? 0 : 1;
        if (tag == "time") {
            const auto now = node.find("now");
            return now && take(one_number(*now), percepts_.time) ? 0 : 1;
        }
        if (tag == "GS") return game_state(node);
        if (tag == "hear") return hear(node);
        return 1;
    }

    int hinge(const Node& node) {
        const auto name = node.find("n");
        const auto angle = node.find("ax");
        if (!name || !angle) return 1;
        const auto value = one_number(*angle);
        const auto joint = joint_named(one_word(*name));
        if (!value || !joint) return 1;
        percepts_.joints_deg[nao::index(*joint)] = *value;
        percepts_.has_joint.set(nao::index(*joint));
        return 0;
    }

    /// Joints come in the order of the ids, mostly: the next one is tried before a search.
    std::optional<nao::JointId> joint_named(std::string_view name) {
        auto joint = static_cast<nao::JointId>(next_joint_);
        if (nao::perceptor_name(joint) != name) {
            const auto found = nao::joint_by_perceptor(name);
            if (!found) return std::nullopt;
            joint = *found;
        }
        next_joint_ = (nao::index(joint) + 1) % nao::kJointCount;
        return joint;
    }

    int foot(const Node& node) {
        const auto name = node.find("n");
        const auto point = vector_in(node, "c");
        const auto force = vector_in(node, "f");
        if (!name || !point || !force) return 1;
        const std::string_view word = one_word(*name);
        for (std::size_t i = 0; i < kFootSensorCount; ++i) {
            if (kFootNames[i] != word) continue;
            percepts_.feet[i] = FootForce{*point, *force};
            return 0;
        }
        return 1;
    }

    int game_state(const Node& node) {
        if (!percepts_.game) percepts_.game.emplace();
        GameState& game = *percepts_.game;
        game.unum.reset();
        game.team.reset();
        game.score_left = game.score_right = 0;
        game.time = 0.0;
        game.play_mode.clear();
        has_game_ = true;
        int faults = 0;
        for (auto n = node.first()->next(); n; n = n->next()) {
            if (!game_field(*n, game)) ++faults;
        }
        return faults;
    }

    static bool game_field(const Node& node, GameState& game) {
        const std::string_view tag = node.tag();
        if (tag == "unum") return take(unum_of(node), game.unum);
        if (tag == "team") return take(side_of(node), game.team);
        if (tag == "sl") return take(one_integer(node), game.score_left);
        if (tag == "sr") return take(one_integer(node), game.score_right);
        if (tag == "t") return take(one_number(node), game.time);
        if (tag != "pm") return false;
        game.play_mode = one_word(node);
        return !game.play_mode.empty();
    }

    int hear(const Node& node) {
        if (node.size() != 5) return 1;
        const auto team = node.at(1);
        const auto time = team->next();
        const auto direction = time->next();
        const auto text = direction->next();
        const auto said_at = number(*time);
        if (team->is_list() || !said_at || text->is_list()) return 1;
        std::optional<double> direction_deg;
        if (direction->atom() != "self") {
            direction_deg = number(*direction);
            if (!direction_deg) return 1;
        }
        Heard heard;
        if (auto& kept = percepts_.spare.heard; !kept.empty()) {
            heard = std::move(kept.back());
            kept.pop_back();
        }
        heard.direction_deg = direction_deg;
        heard.team = team->atom();
        heard.time = *said_at;
        heard.text = text->atom();
        percepts_.heard.push_back(std::move(heard));
        return 0;
    }

    int see(const Node& node) {
        if (!percepts_.see) percepts_.see.emplace(std::move(percepts_.spare.see));
        See& view = *percepts_.see;
        view.landmarks.fill(std::nullopt);
        view.ball.reset();
        view.players.clear();
        view.players.reserve(kUsualPlayers);
        view.lines.clear();
        view.lines.reserve(kUsualLines);
        view.my_position.reset();
        view.my_orientation_deg.reset();
        view.ball_position.reset();
        has_see_ = true;
        int faults = 0;
        for (auto n = node.first()->next(); n; n = n->next()) faults += seen(*n, view);
        return faults;
    }

    static int seen(const Node& node, See& view) {
        const std::string_view tag = node.tag();
        if (tag == "L") return line(node, view);
        if (tag == "P") return player(node, view);
        if (tag == "B") return take(one_pol(node), view.ball) ? 0 : 1;
        for (std::size_t i = 0; i < field::kLandmarks.size(); ++i) {
            if (field::kLandmarks[i].name == tag) {
                return take(one_pol(node), view.landmarks[i]) ? 0 : 1;
            }
        }
        if (tag == "mypos") return take(vector(node), view.my_position) ? 0 : 1;
        if (tag == "myorien") return take(one_number(node), view.my_orientation_deg) ? 0 : 1;
        if (tag == "ballpos") return take(vector(node), view.ball_position) ? 0 : 1;
        return 1;
    }

    static int line(const Node& node, See& view) {
        const auto first = node.at(1);
        const auto second = first ? first->next() : std::nullopt;
        const auto begin = pol(first);
        const auto end = pol(second);
        if (!begin || !end || second->next()) return 1;
        view.lines.push_back({*begin, *end});
        return 0;
    }

    static int player(const Node& node, See& view) {
        SeenPlayer seen;
        int faults = 0;
        for (auto n = node.first()->next(); n; n = n->next()) {
            if (!player_field(*n, seen)) ++faults;
        }
        if (seen.team.empty() || seen.unum == 0) return faults + 1;
        view.players.push_back(std::move(seen));
        return faults;
    }

    static bool player_field(const Node& node, SeenPlayer& seen) {
        const std::string_view tag = node.tag();
        if (tag == "team") {
            seen.team = one_word(node);
            return !seen.team.empty();
        }
        if (tag == "id") return take(unum_of(node), seen.unum);
        if (tag == "head") return take(one_pol(node), seen.head);
        if (tag == "rlowerarm") return take(one_pol(node), seen.rlowerarm);
        if (tag == "llowerarm") return take(one_pol(node), seen.llowerarm);
        if (tag == "rfoot") return take(one_pol(node), seen.rfoot);
        if (tag == "lfoot") return take(one_pol(node), seen.lfoot);
        return false;
    }

    Percepts& percepts_;
    std::size_t next_joint_ = 0;
    bool has_game_ = false;
    bool has_see_ = false;
};

}  // namespace

int decode(std::string_view payload, Percepts& percepts) {
    return Decoder(percepts).run(payload);
}

}  // namespace k3d::wire

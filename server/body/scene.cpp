// SPDX-License-Identifier: BSD-3-Clause
#include "server/body/scene.h"

#include <algorithm>

namespace k3d::server::body {

std::string Player::entity() const {
    return std::string(wire::side_name(team)) + "." + std::to_string(unum);
}

Player& Scene::add_player(int type, const Vec3& torso) {
    auto player = std::make_unique<Player>();
    player->id = next_id_++;
    player->robot = std::make_unique<Robot>(world, nao::model(type), player->id, torso);
    players.push_back(std::move(player));
    return *players.back();
}

void Scene::remove_player(int id) {
    std::erase_if(players, [id](const auto& player) { return player->id == id; });
}

Player* Scene::find(int id) const {
    const auto found = std::find_if(players.begin(), players.end(),
                                    [id](const auto& player) { return player->id == id; });
    return found == players.end() ? nullptr : found->get();
}

Player* Scene::find(wire::Side team, int unum) const {
    const auto found =
        std::find_if(players.begin(), players.end(), [team, unum](const auto& player) {
            return player->team == team && player->unum == unum;
        });
    return found == players.end() ? nullptr : found->get();
}

}  // namespace k3d::server::body

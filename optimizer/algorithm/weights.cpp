// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/weights.h"

#include <fmt/format.h>

#include "common/log/log.h"

namespace k3d::optimizer::algorithm {

std::vector<spec::Parameter> weights_of(const network::Definition& definition, double deviation) {
    std::vector<spec::Parameter> parameters;
    const auto add = [&](std::string name, double start) {
        spec::Parameter parameter;
        parameter.name = std::move(name);
        parameter.start = start;
        parameter.deviation = deviation;
        parameters.push_back(std::move(parameter));
    };
    for (const network::Link& link : definition.links) {
        add(fmt::format("{} {} -> {}", link.recurrent ? "recurrent link" : "link", link.from, link.to),
            link.weight);
    }
    for (const network::Node& node : definition.nodes) add("bias " + node.name, node.bias);
    return parameters;
}

network::Definition with_weights(network::Definition definition, const std::vector<double>& values) {
    K3D_ASSERT(values.size() == definition.links.size() + definition.nodes.size());
    auto value = values.begin();
    for (network::Link& link : definition.links) link.weight = *value++;
    for (network::Node& node : definition.nodes) node.bias = *value++;
    return definition;
}

}  // namespace k3d::optimizer::algorithm

// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/settings.h"

#include <fmt/format.h>

#include <stdexcept>

#include "optimizer/spec/words.h"

namespace k3d::optimizer::spec {

Settings parse_settings(std::string_view text) {
    Settings settings;
    for (const std::string& word : split_words(text)) {
        const std::size_t colon = word.find(':');
        const std::size_t equals = word.find('=');
        const std::string program = word.substr(0, colon);
        const bool agent = program == "agent";
        const bool known =
            agent || program == "server" || program == "keeper" || program == "taker";
        if (!known || equals == std::string::npos || colon + 1 >= equals) {
            throw std::invalid_argument(fmt::format(
                "setting '{}' is not PROGRAM:path=value with PROGRAM server, agent, keeper or "
                "taker",
                word));
        }
        const std::string setting = word.substr(colon + 1);
        if (program == "server") settings.server.push_back(setting);
        if (agent || program == "keeper") settings.keeper.push_back(setting);
        if (agent || program == "taker") settings.taker.push_back(setting);
    }
    return settings;
}

}  // namespace k3d::optimizer::spec

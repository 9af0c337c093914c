// SPDX-License-Identifier: BSD-3-Clause
// Settings passed on to the programs of an episode: "server:keepaway.side=12
// keeper:kick.power=0.8".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace k3d::optimizer::spec {

/// "path=value" lists for --set; what is said of `agent` stands in both keeper and taker.
struct Settings {
    std::vector<std::string> server;
    std::vector<std::string> keeper;
    std::vector<std::string> taker;
};

/// Throws std::invalid_argument naming the word that is not PROGRAM:path=value.
Settings parse_settings(std::string_view text);

}  // namespace k3d::optimizer::spec

// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a configuration file: taken and printed back alike, or refused without a change.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "common/config/config.h"

namespace {

using namespace k3d;

struct Inner {
    double height = 0.03;
    std::vector<double> gains{1.0, 2.0};
    void describe(config::Fields& f) {
        f.number("height", height, {0.0, 0.1}, "m", "a length");
        f.numbers("gains", gains, {-5.0, 5.0}, "", "two numbers");
    }
};

struct Outer {
    Inner inner;
    int port = 3100;
    std::uint64_t seed = 1;
    bool noise = true;
    std::string pace = "sync";
    std::string name = "any";
    void describe(config::Fields& f) {
        f.integer("port", port, {0, 65535}, "", "a port");
        f.seed("seed", seed, "a seed");
        f.boolean("noise", noise, "a switch");
        f.text("pace", pace, {"realtime", "sync", "fast"}, "a choice");
        f.text("name", name, {}, "a text");
        f.section("inner", inner);
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    Outer outer;
    const std::string before = config::print(config::describing(outer));
    try {
        config::load_text(config::describing(outer), text, "fuzz.toml");
    } catch (const config::ConfigError&) {
        if (config::print(config::describing(outer)) != before) std::abort();
        return 0;
    }
    const std::string printed = config::print(config::describing(outer));
    Outer again;
    config::load_text(config::describing(again), printed, "printed.toml");
    if (config::print(config::describing(again)) != printed) std::abort();
    return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "common/log/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace k3d::log {

namespace {

spdlog::level::level_enum level_named(std::string_view level) {
    if (level == "trace") return spdlog::level::trace;
    if (level == "debug") return spdlog::level::debug;
    if (level == "info") return spdlog::level::info;
    if (level == "warning") return spdlog::level::warn;
    if (level == "error") return spdlog::level::err;
    if (level == "off") return spdlog::level::off;
    throw std::invalid_argument("log level \"" + std::string(level) +
                                "\" is none of trace, debug, info, warning, error, off");
}

}  // namespace

void start(std::string_view program, std::string_view level) {
    const auto chosen = level_named(level);
    auto logger = std::make_shared<spdlog::logger>(
        std::string(program), std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
    logger->set_pattern("%n %H:%M:%S.%e %^%l%$: %v");
    logger->set_level(chosen);
    logger->flush_on(spdlog::level::trace);
    spdlog::set_default_logger(std::move(logger));
}

void assertion_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: broken assumption: %s\n", file, line, condition);
    std::fflush(stderr);
    std::abort();
}

}  // namespace k3d::log

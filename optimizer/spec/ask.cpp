// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/ask.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "common/config/command_line.h"

namespace k3d::optimizer::spec {

namespace {

constexpr std::chrono::seconds kPatience{30};

/// A file of its own for what a program prints.
struct Capture {
    std::string path = (std::filesystem::temp_directory_path() / "k3d-ask-XXXXXX").string();
    Capture() {
        const int fd = ::mkstemp(path.data());
        if (fd < 0) throw std::runtime_error("cannot make a file in " + path);
        ::close(fd);
    }
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;
    ~Capture() { ::unlink(path.c_str()); }
};

bool is_refusal(const Answer& answer) {
    return answer.exit && !answer.exit->signalled && answer.exit->code == config::kExitUsage;
}

void require_taken_by(const std::string& program, const std::string& what,
                      const std::vector<std::string>& settings) {
    if (settings.empty()) return;
    std::vector<std::string> words{program, "--print-config"};
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    try {
        const Answer answer = ask(words);
        if (!is_refusal(answer)) return;
        throw config::ConfigError(fmt::format("{}: {}", what, last_words(answer.text)));
    } catch (const process::StartError&) {
        return;
    }
}

}  // namespace

std::string program_path(const std::string& wanted, const char* name) {
    if (!wanted.empty()) return wanted;
    return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

std::string last_words(const std::string& text) {
    std::istringstream lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        // The line before this one, which ends every message about flags, names the flag.
        if (!line.empty() && !line.starts_with("Run with --help")) last = line;
    }
    return last;
}

Answer ask(const std::vector<std::string>& words) {
    const Capture said;
    process::Child child({words, said.path, false});
    Answer answer{child.wait(kPatience), ""};
    std::ostringstream text;
    text << std::ifstream(said.path).rdbuf();
    answer.text = text.str();
    return answer;
}

void require_taken(const std::string& what, const TaskSpec& task, const Settings& settings) {
    const std::string agent = program_path(task.agent_program, "k3d-agent");
    require_taken_by(program_path(task.server_program, "k3d-server"), what, settings.server);
    require_taken_by(agent, what, settings.keeper);
    if (!task.taker_command.empty() || settings.taker == settings.keeper) return;
    require_taken_by(agent, what, settings.taker);
}

}  // namespace k3d::optimizer::spec

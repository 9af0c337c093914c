// SPDX-License-Identifier: BSD-3-Clause
// Who may include whom: libraries in their own folders, programs apart, stages in the data's order.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>

#include "structure/source_tree.h"

namespace k3d::structure {
namespace {

struct Include {
    const SourceFile* from;
    std::size_t line;    ///< counted from 1
    std::string target;  ///< what stands between the quotes or angle brackets

    std::string text() const {
        return from->path + ":" + std::to_string(line) + " includes " + target;
    }
};

/// The target of an #include line; none if the line is none.
std::optional<std::string> include_target(const std::string& line) {
    std::size_t at = line.find_first_not_of(" \t");
    if (at == std::string::npos || line[at] != '#') return std::nullopt;
    at = line.find_first_not_of(" \t", at + 1);
    if (at == std::string::npos || line.compare(at, 7, "include") != 0) return std::nullopt;
    const std::size_t open = line.find_first_of("<\"", at);
    if (open == std::string::npos) return std::nullopt;
    const std::size_t close = line.find_first_of(">\"", open + 1);
    return line.substr(open + 1, close - open - 1);
}

const std::vector<std::string> kPrograms = {"server", "agent", "optimizer"};

/// Every include in common and the programs; tests may include anything.
std::vector<Include> all_includes() {
    std::vector<Include> includes;
    for (const SourceFile& file : source_tree()) {
        if (!file.is_cpp() || file.below("tests")) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            if (const auto target = include_target(file.lines[i])) {
                includes.push_back({&file, i + 1, *target});
            }
        }
    }
    return includes;
}

bool starts_with(const std::string& text, const std::string& prefix) {
    return text.rfind(prefix, 0) == 0;
}

/// "server/physics/world.h" -> "physics" for program "server"; empty for a file beside main.cpp.
std::string stage_of(const std::string& path, const std::string& program) {
    const std::size_t begin = program.size() + 1;
    const std::size_t end = path.find('/', begin);
    return end == std::string::npos ? "" : path.substr(begin, end - begin);
}

TEST(IncludeRules, IncludeLinesAreRead) {
    EXPECT_EQ(include_target("#include <ode/ode.h>"), "ode/ode.h");
    EXPECT_EQ(include_target("  #  include \"common/net/net.h\"  // why"), "common/net/net.h");
    EXPECT_FALSE(include_target("// #include <ode/ode.h>"));
    EXPECT_FALSE(include_target("#define include"));
    EXPECT_GT(all_includes().size(), 20u) << "the source tree was not found";
}

TEST(IncludeRules, OdeStaysInPhysicsAndBody) {
    for (const Include& i : all_includes()) {
        if (starts_with(i.target, "ode/")) {
            EXPECT_TRUE(i.from->below("server/physics") || i.from->below("server/body"))
                << i.text();
        }
    }
}

TEST(IncludeRules, AsioStaysInNet) {
    for (const Include& i : all_includes()) {
        if (starts_with(i.target, "boost/asio")) {
            EXPECT_EQ(i.from->path, "common/net/asio.h") << i.text();
        }
        if (i.target == "common/net/asio.h" || i.target == "common/net/loop_impl.h") {
            EXPECT_TRUE(i.from->below("common/net") || i.from->below("common/http")) << i.text();
        }
    }
}

TEST(IncludeRules, BeastStaysInHttp) {
    for (const Include& i : all_includes()) {
        if (starts_with(i.target, "boost/beast")) {
            EXPECT_TRUE(i.from->below("common/http")) << i.text();
        }
    }
}

TEST(IncludeRules, ProgramsKnowOnlyCommonAndThemselves) {
    for (const Include& i : all_includes()) {
        for (const std::string& program : kPrograms) {
            if (starts_with(i.target, program + "/")) {
                EXPECT_TRUE(i.from->below(program)) << i.text();
            }
        }
        EXPECT_FALSE(starts_with(i.target, "tests/") || starts_with(i.target, "../")) << i.text();
    }
}

/// The stages of each program, in the order the data flows through them. In the agent the body
/// stands first: its motion tells perception where the camera is and how far the robot went. What
/// team-mates say is part of the world, and skills are what decisions choose from.
const std::map<std::string, std::vector<std::string>> kStages = {
    {"server",
     {"physics", "body", "effectors", "percepts", "game", "monitor", "session", "recording",
      "viewer"}},
    {"agent",
     {"config", "kinematics", "motion", "talk", "perception", "localisation", "world", "skills",
      "decision", "action"}},
    {"optimizer",
     {"spec", "algorithm", "episode", "drill", "fitness", "backend", "ledger", "report"}},
};

TEST(IncludeRules, AStageIncludesOnlyStagesBeforeIt) {
    for (const auto& [program, stages] : kStages) {
        const auto rank = [&stages = stages](const std::string& stage) {
            return std::find(stages.begin(), stages.end(), stage) - stages.begin();
        };
        for (const Include& i : all_includes()) {
            if (!i.from->below(program) || !starts_with(i.target, program + "/")) continue;
            const std::string from = stage_of(i.from->path, program);
            const std::string to = stage_of(i.target, program);
            if (from.empty()) continue;                       // main and the frame join the stages
            if (i.target == program + "/config.h") continue;  // the settings of a run
            if (to.empty()) {
                ADD_FAILURE() << i.text() << ", which stands above the stages";
            } else {
                EXPECT_LE(rank(to), rank(from)) << i.text() << ", a later stage";
            }
        }
    }
}

TEST(IncludeRules, EveryFolderOfAProgramIsAStage) {
    for (const auto& [program, stages] : kStages) {
        for (const SourceFile& file : source_tree()) {
            if (!file.is_cpp() || !file.below(program)) continue;
            const std::string stage = stage_of(file.path, program);
            EXPECT_TRUE(stage.empty() ||
                        std::find(stages.begin(), stages.end(), stage) != stages.end())
                << file.path << ": '" << stage << "' is no stage of " << program;
        }
    }
}

/// A path of folders that leads from `folder` back to itself; empty if there is none.
std::vector<std::string> cycle_through(const std::string& folder,
                                       std::map<std::string, std::set<std::string>>& uses) {
    std::vector<std::vector<std::string>> paths = {{folder}};
    std::set<std::string> seen;
    while (!paths.empty()) {
        const std::vector<std::string> path = paths.back();
        paths.pop_back();
        for (const std::string& next : uses[path.back()]) {
            std::vector<std::string> longer = path;
            longer.push_back(next);
            if (next == folder) return longer;
            if (seen.insert(next).second) paths.push_back(longer);
        }
    }
    return {};
}

TEST(IncludeRules, FoldersOfCommonFormNoCycle) {
    std::map<std::string, std::set<std::string>> uses;
    for (const Include& i : all_includes()) {
        if (!i.from->below("common") || !starts_with(i.target, "common/")) continue;
        const std::string from = stage_of(i.from->path, "common");
        const std::string to = stage_of(i.target, "common");
        if (from != to) uses[from].insert(to);
    }
    const auto folders = uses;
    for (const auto& [folder, unused] : folders) {
        std::string text;
        for (const std::string& step : cycle_through(folder, uses)) text += " -> " + step;
        EXPECT_EQ(text, "") << "common/" << folder << " includes itself in the end";
    }
}

}  // namespace
}  // namespace k3d::structure

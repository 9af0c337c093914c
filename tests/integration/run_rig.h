// SPDX-License-Identifier: BSD-3-Clause
// Runs of k3d-optimizer as processes, on episodes of a fraction of a second.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "common/process/child.h"

namespace k3d::testing {

inline constexpr std::chrono::seconds kRunPatience{300};

class RunRig : public ::testing::Test {
  protected:
    RunRig() {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = (std::filesystem::temp_directory_path() /
                   ("k3d-run-" + std::to_string(getpid()) + "-" + info->name()))
                      .string();
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_ + "/quick");
        ::setenv("K3D_QUICK_FOLDER", (folder_ + "/quick").c_str(), 1);
        write("exp.toml", quick_experiment());
    }
    ~RunRig() override {
        ::unsetenv("K3D_QUICK_FOLDER");
        if (!HasFailure()) std::filesystem::remove_all(folder_);
    }

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name)) << text;
    }
    std::string content(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(path(name)).rdbuf();
        return text.str();
    }

    static std::string quick_experiment() {
        const std::string program = std::string(K3D_BIN_DIR) + "/quick_episode";
        return "name = \"quick\"\nseed = 5\n[task]\nkeepers = 1\ntakers = 1\nserver_program = \"" +
               program + "\"\nagent_program = \"" + program +
               "\"\n[algorithm]\nname = \"cmaes\"\nmax_generations = 4\n"
               "[algorithm.sampling]\nepisodes = 4\nvalidation_episodes = 3\nfinalists = 2\n"
               "[algorithm.cmaes]\npopulation = 6\n[test]\nepisodes = 4\n"
               "[parameters.keeper.hold_threshold]\nlower = 0.0\nupper = 6.0\nstart = 1.0\n"
               "[parameters.keeper.role_hysteresis]\nlower = 0.0\nupper = 3.0\n";
    }

    process::Child start(std::vector<std::string> words, const std::string& log) const {
        words.insert(words.begin(), std::string(K3D_BIN_DIR) + "/k3d-optimizer");
        return process::Child({words, path(log), false});
    }
    /// Runs to its end and returns the exit code, -1 if there is none in time.
    int run(const std::vector<std::string>& words, const std::string& log) const {
        process::Child child = start(words, log);
        const auto exit = child.wait(kRunPatience);
        return exit ? exit->code : -1;
    }

    /// However slow the machine is: until `reached` is true; false if the child ends before that.
    template <class Reached>
    static bool await(process::Child& child, const Reached& reached) {
        const auto deadline = std::chrono::steady_clock::now() + kRunPatience;
        while (!reached() && std::chrono::steady_clock::now() < deadline) {
            if (child.wait(std::chrono::milliseconds(20))) return false;
        }
        return reached();
    }
    /// Until the second, episodes take their time: a run must not end before what it is to suffer.
    void slow_episodes() const { write("quick.slow", ""); }
    void quick_episodes() const { std::filesystem::remove(path("quick.slow")); }

    /// An episode is being played, so daemon or worker have nothing more to set up.
    bool plays() const { return !std::filesystem::is_empty(path("quick")); }
    bool tells(const std::string& log, const std::string& words) const {
        return content(log).find(words) != std::string::npos;
    }
    /// The rows so far; none while there is no ledger yet.
    std::string rows_so_far(const std::string& run_name) const {
        if (!std::filesystem::exists(path(run_name) + "/ledger.sqlite")) return "";
        return run({"show", path(run_name), "--csv"}, "shown") == 0 ? content("shown") : "";
    }

    std::string shown(const std::string& run_name, const std::string& flag) const {
        EXPECT_EQ(run({"show", path(run_name), flag}, "shown"), 0) << content("shown");
        return content("shown");
    }
    /// All that must not depend on workers, faults and time.
    std::string canonical(const std::string& run_name) const {
        return shown(run_name, "--canonical") + shown(run_name, "--state");
    }

    /// What `show` tells of tries that gave no result, a line each.
    std::string failed_tries(const std::string& run_name) const {
        EXPECT_EQ(run({"show", path(run_name)}, "shown"), 0) << content("shown");
        std::istringstream lines(content("shown"));
        std::string failed;
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("failed try ")) failed += line + "\n";
        }
        return failed;
    }

    std::string folder_;
};

}  // namespace k3d::testing

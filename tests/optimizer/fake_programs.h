// SPDX-License-Identifier: BSD-3-Clause
// A server and an agent as shell scripts, so that tests choose how they die, hang or lie.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "optimizer/spec/match_spec.h"

namespace k3d::optimizer {

inline std::string content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// A scratch folder with the scripts. Temporary files of the code under test go there too.
class FakePrograms : public testing::Test {
  protected:
    FakePrograms() {
        std::string path = testing::TempDir() + "k3d_fake_XXXXXX";
        base_ = ::mkdtemp(path.data());
        std::filesystem::create_directory(base_ + "/tmp");
        ::setenv("TMPDIR", (base_ + "/tmp").c_str(), 1);
        server_plays(kOneResult);
        agents_play(kUntilTheEnd);
        spec_.server_program = base_ + "/server";
        spec_.agent_program = base_ + "/agent";
        spec_.results = base_ + "/out.jsonl";
        spec_.keepers = 2;
        spec_.takers = 1;
        spec_.deadline_s = 60.0;
    }
    ~FakePrograms() override {
        ::unsetenv("TMPDIR");
        std::filesystem::remove_all(base_);
    }

    /// `body` runs after the ready line; $seed, $results, $status and $base are set, and `result`
    /// writes a line. Agents play on until the script ends.
    void server_plays(const std::string& body) {
        script("server", R"(
            while [ $# -gt 0 ]; do
                case $1 in --seed) seed=$2 ;; --results) results=$2 ;; --http) http=$2 ;; esac
                shift 2
            done
            port=$(( $$ % 60000 + 1024 ))
            : > $base/port-$port
            trap 'rm -f $base/port-$port' EXIT
            status=finished
            result() {
                printf '{"schema":1,"game":"keepaway","seed":%s,"status":"%s",' $seed $status
                printf '"reason":"ball_out","hold_time_s":%s.5,"attempts":null,"kicks":2,' $seed
                printf '"passes_completed":1,"players":[{"team":"left","unum":1,"falls":0,'
                printf '"distance_m":1.0,"mean_speed":0.1}],"metrics":{},'
                printf '"state_hash":"00","code_version":"x"}\n'
            }
            echo "ready agent=$port monitor=1${http:+ http=$http}"
            )" + body);
    }

    /// `body` runs with $port, $role, $unum and $telemetry set; `until_end` waits for the server.
    void agents_play(const std::string& body) {
        script("agent", R"(
            while [ $# -gt 0 ]; do
                case $1 in --port) port=$2 ;; --role) role=$2 ;; --unum) unum=$2 ;;
                    --telemetry) telemetry=$2 ;; esac
                shift 2
            done
            until_end() { while [ -e $base/port-$port ]; do sleep 0.02; done; }
            kick() { echo '{"time": 1.5, "event": "kick_attempt"}' >> $telemetry; }
            )" + body);
    }

    void script(const std::string& name, const std::string& text) {
        const std::string path = base_ + "/" + name;
        std::ofstream(path) << "#!/bin/sh\nbase=" << base_ << "\necho $$ >> $base/pids\n" << text;
        std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    }

    std::vector<pid_t> pids() const {
        std::ifstream in(base_ + "/pids");
        std::vector<pid_t> pids;
        for (pid_t pid; in >> pid;) pids.push_back(pid);
        return pids;
    }

    /// Waits, with a deadline, until none of the started scripts runs.
    bool all_gone() const {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        for (const pid_t pid : pids()) {
            while (::kill(pid, 0) == 0) {
                if (std::chrono::steady_clock::now() > deadline) return false;
                ::usleep(2000);
            }
        }
        return true;
    }

    bool temporary_files_left() const { return !std::filesystem::is_empty(base_ + "/tmp"); }

    static constexpr const char* kOneResult = "sleep 0.1; result >> $results";
    static constexpr const char* kUntilTheEnd = "[ $role = taker ] || kick; until_end";

    std::string base_;
    spec::MatchSpec spec_;
};

}  // namespace k3d::optimizer

// SPDX-License-Identifier: BSD-3-Clause
// A nats-server with JetStream on a port of its own, that can be killed and started again.
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "common/process/child.h"

namespace k3d::testing {

class NatsProcess {
  public:
    /// Its files go to `folder`.
    explicit NatsProcess(std::string folder) : folder_(std::move(folder)) {
        std::filesystem::create_directories(folder_ + "/ports");
        start("-1");
        port_ = port_told();
    }

    std::string url() const { return "nats://127.0.0.1:" + port_; }

    pid_t pid() const { return child_->pid(); }
    void kill() { child_->kill(); }
    void start_again() { start(port_); }
    /// Killed before: as on another machine, or another folder.
    void start_without_files() {
        std::filesystem::remove_all(folder_ + "/jetstream");
        start(port_);
    }
    void start_without_streams() { start(port_, false); }

  private:
    void start(const std::string& port, bool streams = true) {
        const char* own = "/usr/sbin/nats-server";
        std::vector<std::string> words{std::filesystem::exists(own) ? own : "nats-server",
                                       "-a",
                                       "127.0.0.1",
                                       "-p",
                                       port,
                                       "--ports_file_dir",
                                       folder_ + "/ports"};
        if (streams) words.insert(words.end(), {"-js", "-sd", folder_});
        child_ = std::make_unique<process::Child>(process::Spawn{words, folder_ + "/log", false});
    }

    /// {"nats":["nats://127.0.0.1:43210"]}
    std::string port_told() const {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (std::chrono::steady_clock::now() < deadline) {
            for (const auto& entry : std::filesystem::directory_iterator(folder_ + "/ports")) {
                std::string text;
                std::getline(std::ifstream(entry.path()), text, '\0');
                const auto begin = text.find("127.0.0.1:");
                const auto end = text.find('"', begin);
                if (begin != std::string::npos && end != std::string::npos) {
                    return text.substr(begin + 10, end - begin - 10);
                }
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        throw std::runtime_error("nats-server told no port");
    }

    std::string folder_;
    std::string port_;
    std::unique_ptr<process::Child> child_;
};

}  // namespace k3d::testing

// SPDX-License-Identifier: BSD-3-Clause
// A server and an agent that stand in for the real ones where only the optimiser is tested: an
// episode of a fraction of a second whose result follows from the seed and from what the keepers
// were given. The server knows it only from the agents, over a socket; both die as real ones do.
//
//     quick_episode --results FILE --seed N ...   the server; leaves a file named after its pid in
//                                                 $K3D_QUICK_FOLDER while it runs, and for good
//                                                 a line with FILE in $K3D_QUICK_FOLDER.started;
//                                                 takes its time while there is a file
//                                                 $K3D_QUICK_FOLDER.slow
//     quick_episode --unum N --port P ...         an agent, or several with --and between them
//     quick_episode --print-fields                what k3d-agent says
//     quick_episode --print-config ...            takes all settings
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "common/episode/result.h"
#include "common/random/stream.h"

namespace {

constexpr int kSteps = 5;
constexpr int kSlow = 4;  ///< times as long

struct Flags {
    std::map<std::string, std::string> words;
    double a = 2.4;  ///< keeper.hold_threshold
    double b = 0.4;  ///< keeper.role_hysteresis

    void take_setting(const std::string& text) {
        const auto equals = text.find('=');
        if (text.substr(0, equals) == "keeper.hold_threshold") a = std::stod(text.substr(equals + 1));
        if (text.substr(0, equals) == "keeper.role_hysteresis") {
            b = std::stod(text.substr(equals + 1));
        }
    }
    std::string at(const char* name) const {
        const auto found = words.find(name);
        return found == words.end() ? "" : found->second;
    }
};

sockaddr_in loopback(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
}

int serve(const Flags& flags) {
    const std::string folder = std::getenv("K3D_QUICK_FOLDER");
    const std::string mark = folder + "/" + std::to_string(::getpid());
    std::ofstream(mark).flush();
    std::ofstream(folder + ".started", std::ios::app) << flags.at("--results") + "\n";
    const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof address;
    if (::bind(listener, reinterpret_cast<sockaddr*>(&address), size) != 0) return 1;
    ::listen(listener, 16);
    ::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
    std::cout << "ready agent=" << ntohs(address.sin_port) << " monitor=1" << std::endl;

    const int seats = std::stoi(flags.at("--keepers")) + std::stoi(flags.at("--takers"));
    std::vector<int> agents;
    double told[2] = {0.0, 0.0};
    for (int i = 0; i < seats; ++i) {
        const int agent = ::accept(listener, nullptr, nullptr);
        double said[2];
        if (::recv(agent, said, sizeof said, MSG_WAITALL) != sizeof said) return 3;
        told[0] += said[0];
        told[1] += said[1];
        agents.push_back(agent);
    }
    const std::uint64_t seed = std::stoull(flags.at("--seed"));
    k3d::RandomStream stream(seed, "quick", "episode");
    k3d::episode::Result result;
    result.game = "keepaway";
    result.seed = seed;
    result.reason = "ball_out";
    result.hold_time_s = 30.0 - std::pow(told[0] - 3.0, 2) - std::pow(told[1] - 1.0, 2) +
                         stream.normal(0.0, 0.5);
    result.state_hash = "0123456789abcdef";
    result.code_version = "quick";
    const int step_us = 10000 + stream.below(30000);
    for (int i = 0; i < kSteps; ++i) {
        const bool slow = std::filesystem::exists(folder + ".slow");
        ::usleep(static_cast<useconds_t>(slow ? kSlow * step_us : step_us));
    }
    std::ofstream(flags.at("--results"), std::ios::app) << k3d::episode::to_line(result) << '\n';
    for (const int agent : agents) ::close(agent);
    ::unlink(mark.c_str());
    return 0;
}

/// Speaks as one agent: what its keeper was given. The connection, or < 0.
int join(const Flags& flags) {
    const int server = ::socket(AF_INET, SOCK_STREAM, 0);
    const sockaddr_in address = loopback(std::stoi(flags.at("--port")));
    if (::connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return -1;
    const bool keeper = flags.at("--role") == "keeper";
    const double said[2] = {keeper ? flags.a : 0.0, keeper ? flags.b : 0.0};
    return ::send(server, said, sizeof said, 0) == sizeof said ? server : -1;
}

/// All agents of this process: those of keepers write telemetry until the server closes.
int play(const std::vector<Flags>& agents) {
    std::vector<int> servers;
    std::vector<std::ofstream> telemetries;
    for (const Flags& agent : agents) {
        servers.push_back(join(agent));
        if (servers.back() < 0) return 1;
        if (agent.at("--role") == "keeper") telemetries.emplace_back(agent.at("--telemetry"));
    }
    timeval patience{0, 20000};
    ::setsockopt(servers.front(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    char byte = 0;
    for (int i = 0; ::recv(servers.front(), &byte, 1, 0) < 0; ++i) {
        for (std::ofstream& telemetry : telemetries)
            telemetry << "{\"time\": " << i << "}\n" << std::flush;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<Flags> agents(1);
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--print-fields") {
            const std::string own = K3D_BIN_DIR "/k3d-agent";
            ::execl(own.c_str(), own.c_str(), argv[i], nullptr);
            return 1;
        }
        if (word == "--print-config") return 0;
        if (word == "--and") {
            agents.emplace_back();
            continue;
        }
        if (i + 1 == argc) return 2;
        const std::string value = argv[++i];
        if (word == "--set") {
            agents.back().take_setting(value);
        } else {
            agents.back().words[word] = value;
        }
    }
    const Flags& first = agents.front();
    return first.words.contains("--results") ? serve(first) : play(agents);
}

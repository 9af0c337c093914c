// SPDX-License-Identifier: BSD-3-Clause
// A foreign agent for tests: takes a seat, stands, and writes every frame it gets to a file.
// usage: frame_recorder HOST PORT UNUM TEAM FILE
#include <fstream>
#include <iostream>
#include <string>

#include "common/net/net.h"

int main(int argc, char** argv) {
    if (argc != 6) {
        std::cerr << "usage: frame_recorder HOST PORT UNUM TEAM FILE\n";
        return 2;
    }
    try {
        constexpr std::chrono::seconds kPatience{60};
        k3d::net::Client client(argv[1], static_cast<std::uint16_t>(std::stoi(argv[2])), kPatience);
        std::ofstream file(std::string(argv[5]) + "." + argv[4] + "." + argv[3]);
        client.send("(scene rsg/agent/nao/nao.rsg)(syn)");
        std::string_view frame;
        for (int n = 0; client.receive(frame, kPatience); ++n) {
            file << frame << '\n';
            client.send(n == 0 ? "(init (unum " + std::string(argv[3]) + ")(teamname " + argv[4] +
                                     "))(syn)"
                               : std::string("(syn)"));
        }
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "frame_recorder: " << error.what() << '\n';
        return 1;
    }
}

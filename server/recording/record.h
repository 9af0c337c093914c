// SPDX-License-Identifier: BSD-3-Clause
// A run's recording: everything that came in from outside, by step, and what state followed.
//
// A file is kMagic, then blocks; each is a whole zstd frame on its own, so that a file whose writer
// was killed is readable up to its last block:
//   u32 stored bytes | u32 plain bytes | u64 XXH3 of the stored bytes | stored bytes   little-endian
// The plain bytes of all blocks are one sequence of entries, none of which crosses a block:
//   'H' text code version, text configuration (TOML)            first, and once
//   'A' number connection, byte port, byte may command, text peer
//   'F' number connection, text frame                           as taken by the simulation
//   'L' number connection, text why                             an agent is lost, a monitor has left
//   'S' u64 digest of the state                                 ends a step: a cycle, or a lobby's turn
//   'E' byte outcome                                            the run's end, in order
// A number is a LEB128, a text a number of bytes and the bytes.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

namespace k3d::server::recording {

inline constexpr std::string_view kMagic = "k3d-server recording 1\n";
inline constexpr std::size_t kBlockHeaderBytes = 16;
/// Largest plain size of a block that a reader accepts.
inline constexpr std::size_t kMaxBlock = 16 * 1024 * 1024;

/// What is wrong with a recording, with the file and the byte.
class RecordError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class Port : std::uint8_t { Agent, Monitor };

struct Header {
    std::string code_version;
    std::string config;  ///< TOML, resolved
};
struct Accepted {
    int connection = 0;  ///< numbered from 1, over both ports
    Port port = Port::Agent;
    bool commands = false;  ///< of a monitor: it may command
    std::string peer;
};
struct Received {
    int connection = 0;
    std::string frame;
};
struct Left {
    int connection = 0;
    std::string why;
};
struct StepEnd {
    std::uint64_t digest = 0;
};
struct End {
    int outcome = 0;
};
using Entry = std::variant<Header, Accepted, Received, Left, StepEnd, End>;

}  // namespace k3d::server::recording

// SPDX-License-Identifier: BSD-3-Clause
// The one kind of net::Connection, over an accepted socket; private to common/net.
#pragma once

#include <memory>

#include "common/net/asio.h"
#include "common/net/net.h"

namespace k3d::net {

/// What a listener and its connections know of each other.
struct Shared {
    Limits limits;
    std::size_t open = 0;     ///< connections not spent yet
    std::uint64_t cycle = 0;  ///< 0: input is not counted
};

/// Stream sockets of either kind, TCP or Unix.
using Socket = boost::asio::generic::stream_protocol::socket;
using Endpoint = boost::asio::generic::stream_protocol::endpoint;

/// Takes over a connected socket and starts reading.
std::unique_ptr<Connection> make_connection(Socket socket, std::string peer,
                                            std::shared_ptr<Shared> shared);

bool is_tcp(const Endpoint& endpoint);

/// Of a Unix-domain socket. Throws NetError where the name is none: `cannot` + " unix:NAME: ...".
Endpoint endpoint_of(const UnixPath& path, const std::string& cannot);

}  // namespace k3d::net

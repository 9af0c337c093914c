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

/// Takes over a connected socket and starts reading.
std::unique_ptr<Connection> make_connection(boost::asio::ip::tcp::socket socket,
                                            std::shared_ptr<Shared> shared);

/// "127.0.0.1:51234", "[::1]:51234"
std::string text_of(const boost::asio::ip::tcp::endpoint& endpoint);

}  // namespace k3d::net

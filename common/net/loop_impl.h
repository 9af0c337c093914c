// SPDX-License-Identifier: BSD-3-Clause
// What is behind net::Loop; for common/net and common/http only.
#pragma once

#include "common/net/asio.h"
#include "common/net/net.h"

namespace k3d::net {

struct Loop::Impl {
    boost::asio::io_context io{1};  // one thread: lets Asio leave out its locks
};

}  // namespace k3d::net

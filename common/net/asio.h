// SPDX-License-Identifier: BSD-3-Clause
// The one way to include Boost.Asio. <utility> must come first: Boost 1.74 uses std::exchange
// without including it, which C++20 coroutine headers trip over.
#pragma once

#include <utility>

#include <boost/asio.hpp>

// SPDX-License-Identifier: BSD-3-Clause
#include "common/net/connection.h"
#include "common/net/loop_impl.h"

namespace k3d::net {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

/// Handlers hold it, so it outlives the Listener until the last has run.
struct Listener::Impl : std::enable_shared_from_this<Listener::Impl> {
    Impl(asio::io_context& io, OnAccept on_accept)
        : acceptor(io), pause(io), on_accept_(std::move(on_accept)) {}

    void open(const std::string& address, std::uint16_t port) {
        const std::string place = address + ":" + std::to_string(port);
        error_code fault;
        const auto ip = asio::ip::make_address(address, fault);
        if (fault) throw NetError("cannot listen on " + place + ": not an IP address");
        const tcp::endpoint endpoint(ip, port);
        acceptor.open(endpoint.protocol(), fault);
        if (!fault) acceptor.set_option(tcp::acceptor::reuse_address(true), fault);
        if (!fault) acceptor.bind(endpoint, fault);
        if (!fault) acceptor.listen(asio::socket_base::max_listen_connections, fault);
        if (fault) throw NetError("cannot listen on " + place + ": " + fault.message());
    }

    void accept() {
        acceptor.async_accept([self = shared_from_this()](error_code fault, tcp::socket socket) {
            if (!self->acceptor.is_open()) return;
            if (fault) return self->accept_later();
            self->on_accept_(make_connection(std::move(socket)));
            if (self->acceptor.is_open()) self->accept();
        });
    }

    /// Out of file descriptors, mostly: trying again at once would only burn the processor.
    void accept_later() {
        pause.expires_after(std::chrono::milliseconds(100));
        pause.async_wait([self = shared_from_this()](error_code) {
            if (self->acceptor.is_open()) self->accept();
        });
    }

    void close() {
        error_code ignored;
        acceptor.close(ignored);
        pause.cancel();
    }

    tcp::acceptor acceptor;
    asio::steady_timer pause;

  private:
    OnAccept on_accept_;
};

Listener::Listener(Loop& loop, const std::string& address, std::uint16_t port, OnAccept on_accept)
    : impl_(std::make_shared<Impl>(loop.impl().io, std::move(on_accept))) {
    impl_->open(address, port);
    impl_->accept();
}

Listener::~Listener() {
    impl_->close();
}

std::uint16_t Listener::port() const {
    return impl_->acceptor.local_endpoint().port();
}

}  // namespace k3d::net

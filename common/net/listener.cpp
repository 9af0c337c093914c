// SPDX-License-Identifier: BSD-3-Clause
#include "common/net/connection.h"
#include "common/net/loop_impl.h"

namespace k3d::net {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

/// Handlers hold it, so it outlives the Listener until the last has run.
struct Listener::Impl : std::enable_shared_from_this<Listener::Impl> {
    Impl(asio::io_context& io, OnAccept on_accept, const Limits& limits, OnRefuse on_refuse)
        : acceptor(io),
          pause(io),
          shared(std::make_shared<Shared>(Shared{limits})),
          on_accept_(std::move(on_accept)),
          on_refuse_(std::move(on_refuse)) {}

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
            self->take(std::move(socket));
            if (self->acceptor.is_open()) self->accept();
        });
    }

    void take(tcp::socket socket) {
        const Limits& limits = shared->limits;
        if (shared->open < limits.connections) {
            return on_accept_(make_connection(std::move(socket), shared));
        }
        if (!on_refuse_) return;
        error_code ignored;
        on_refuse_(text_of(socket.remote_endpoint(ignored)),
                   std::to_string(shared->open) + " connections open, limit " +
                       std::to_string(limits.connections));
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
    std::shared_ptr<Shared> shared;

  private:
    OnAccept on_accept_;
    OnRefuse on_refuse_;
};

Listener::Listener(Loop& loop, const std::string& address, std::uint16_t port, OnAccept on_accept,
                   const Limits& limits, OnRefuse on_refuse)
    : impl_(std::make_shared<Impl>(loop.impl().io, std::move(on_accept), limits,
                                   std::move(on_refuse))) {
    impl_->open(address, port);
    impl_->accept();
}

Listener::~Listener() {
    impl_->close();
}

std::uint16_t Listener::port() const {
    return impl_->acceptor.local_endpoint().port();
}

void Listener::begin_cycle() {
    ++impl_->shared->cycle;
}

}  // namespace k3d::net

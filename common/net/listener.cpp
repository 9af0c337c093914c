// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "common/net/connection.h"
#include "common/net/loop_impl.h"

namespace k3d::net {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

tcp::endpoint ip_endpoint(const Endpoint& endpoint) {
    tcp::endpoint ip;
    if (is_tcp(endpoint) && endpoint.size() <= ip.capacity()) {
        std::memcpy(ip.data(), endpoint.data(), endpoint.size());
        ip.resize(endpoint.size());
    }
    return ip;
}

}  // namespace

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
        open(tcp::endpoint(ip, port), place);
    }

    void open(const UnixPath& path) {
        const Endpoint endpoint = endpoint_of(path, "cannot listen on");
        remove_if_left(endpoint, path.name);
        open(endpoint, "unix:" + path.name);
        file_ = path.name;
    }

    /// A killed server leaves its socket's file, at which nobody listens any more.
    void remove_if_left(const Endpoint& endpoint, const std::string& file) {
        Socket probe(acceptor.get_executor());
        error_code fault;
        probe.connect(endpoint, fault);
        std::error_code ignored;
        const bool deserted = fault == asio::error::connection_refused;
        if (deserted && std::filesystem::is_socket(file, ignored)) ::unlink(file.c_str());
    }

    void open(const Endpoint& endpoint, const std::string& place) {
        error_code fault;
        acceptor.open(endpoint.protocol(), fault);
        if (!fault && is_tcp(endpoint)) {
            acceptor.set_option(tcp::acceptor::reuse_address(true), fault);
        }
        if (!fault) acceptor.bind(endpoint, fault);
        if (!fault) acceptor.listen(asio::socket_base::max_listen_connections, fault);
        if (fault) throw NetError("cannot listen on " + place + ": " + fault.message());
    }

    /// Who connected; a Unix-domain peer has no address of its own.
    std::string peer_of(const Socket& socket) const {
        if (!file_.empty()) return "unix:" + file_;
        error_code ignored;
        const tcp::endpoint peer = ip_endpoint(socket.remote_endpoint(ignored));
        const std::string address = peer.address().to_string();
        return (peer.address().is_v6() ? "[" + address + "]" : address) + ":" +
               std::to_string(peer.port());
    }

    void accept() {
        acceptor.async_accept([self = shared_from_this()](error_code fault, Socket socket) {
            if (!self->acceptor.is_open()) return;
            if (fault) return self->accept_later();
            self->take(std::move(socket));
            if (self->acceptor.is_open()) self->accept();
        });
    }

    void take(Socket socket) {
        const Limits& limits = shared->limits;
        if (shared->open < limits.connections) {
            std::string peer = peer_of(socket);
            return on_accept_(make_connection(std::move(socket), std::move(peer), shared));
        }
        if (!on_refuse_) return;
        on_refuse_(peer_of(socket),
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
        if (!file_.empty()) ::unlink(file_.c_str());
    }

    asio::basic_socket_acceptor<asio::generic::stream_protocol> acceptor;
    asio::steady_timer pause;
    std::shared_ptr<Shared> shared;

  private:
    OnAccept on_accept_;
    OnRefuse on_refuse_;
    std::string file_;  ///< of a Unix-domain socket
};

Listener::Listener(Loop& loop, const std::string& address, std::uint16_t port, OnAccept on_accept,
                   const Limits& limits, OnRefuse on_refuse)
    : impl_(std::make_shared<Impl>(loop.impl().io, std::move(on_accept), limits,
                                   std::move(on_refuse))) {
    impl_->open(address, port);
    impl_->accept();
}

Listener::Listener(Loop& loop, const UnixPath& path, OnAccept on_accept, const Limits& limits,
                   OnRefuse on_refuse)
    : impl_(std::make_shared<Impl>(loop.impl().io, std::move(on_accept), limits,
                                   std::move(on_refuse))) {
    impl_->open(path);
    impl_->accept();
}

Listener::~Listener() {
    impl_->close();
}

std::uint16_t Listener::port() const {
    return ip_endpoint(impl_->acceptor.local_endpoint()).port();
}

void Listener::begin_cycle() {
    ++impl_->shared->cycle;
}

}  // namespace k3d::net

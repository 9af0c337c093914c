// SPDX-License-Identifier: BSD-3-Clause
// The one translation unit that includes Boost.Beast (it takes half a minute to compile).
#include "common/http/server.h"

// clang-format off
#include "common/net/asio.h"  // before any Beast header
// clang-format on

#include <array>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <optional>
#include <set>
#include <utility>

#include "common/http/files.h"
#include "common/log/log.h"
#include "common/net/loop_impl.h"

namespace k3d::http {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace web = boost::beast::http;
namespace websocket = boost::beast::websocket;
using tcp = asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr int kRequestsPerConnection = 200;  // then it must reconnect: a flood cannot hold the loop
constexpr std::size_t kDrainBytes = 64 * 1024;
constexpr std::chrono::seconds kDrainTime{1};
constexpr std::chrono::milliseconds kAcceptPause{100};

struct Core;

/// Whoever has a connection of ours; counted while it exists. Lives as long as its handlers.
class Peer {
  public:
    explicit Peer(std::shared_ptr<Core> core);
    virtual ~Peer();
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;
    virtual void cut() = 0;  ///< closes the connection; its handlers then end by error

  protected:
    std::shared_ptr<Core> core_;
};

/// What the server and its peers share; outlives the server while handlers are pending.
struct Core {
    Server::Options options;
    Server::OnSocket on_socket;
    std::set<Peer*> peers;
    bool over = false;
};

Peer::Peer(std::shared_ptr<Core> core) : core_(std::move(core)) {
    core_->peers.insert(this);
}
Peer::~Peer() {
    core_->peers.erase(this);
}

/// An open WebSocket.
class Watcher : public Peer, public std::enable_shared_from_this<Watcher> {
  public:
    Watcher(std::shared_ptr<Core> core, beast::tcp_stream stream,
            web::request<web::empty_body> request)
        : Peer(std::move(core)), socket_(std::move(stream)), request_(std::move(request)) {}

    void open();
    bool ready() const { return open_ && !sending_; }
    bool closed() const { return !open_; }
    bool send(Socket::Kind kind, std::string_view message);
    void cut() override {
        open_ = false;
        beast::get_lowest_layer(socket_).close();
    }

  private:
    void opened();

    websocket::stream<beast::tcp_stream> socket_;
    web::request<web::empty_body> request_;
    beast::flat_buffer incoming_;
    std::string outgoing_;
    bool open_ = false;
    bool sending_ = false;
};

/// The owner's end: closes the connection when it goes.
class Handle final : public Socket {
  public:
    explicit Handle(std::shared_ptr<Watcher> watcher) : watcher_(std::move(watcher)) {}
    ~Handle() override { watcher_->cut(); }
    bool ready() const override { return watcher_->ready(); }
    bool closed() const override { return watcher_->closed(); }
    bool send(Kind kind, std::string_view message) override {
        return watcher_->send(kind, message);
    }

  private:
    std::shared_ptr<Watcher> watcher_;
};

void Watcher::open() {
    const Limits& limits = core_->options.limits;
    websocket::stream_base::timeout deadlines{};
    deadlines.handshake_timeout = limits.request;
    deadlines.idle_timeout = limits.silence;
    deadlines.keep_alive_pings = true;
    socket_.set_option(deadlines);
    socket_.read_message_max(limits.message_bytes);
    socket_.auto_fragment(false);  // one message, one frame
    error_code ignored;
    auto& tcp_socket = beast::get_lowest_layer(socket_).socket();
    tcp_socket.set_option(tcp::no_delay(true), ignored);
    tcp_socket.set_option(asio::socket_base::send_buffer_size(static_cast<int>(limits.send_buffer)),
                          ignored);
    socket_.async_accept(request_, [self = shared_from_this()](error_code error) {
        if (!error && !self->core_->over) self->opened();
    });
}

void Watcher::opened() {
    open_ = true;
    // Reading also answers pings and notices the end. A page has nothing to say: a whole message
    // ends the connection, so that no flood of them can hold the loop.
    socket_.async_read(incoming_, [self = shared_from_this()](error_code error, std::size_t size) {
        if (!error) spdlog::debug("http: a WebSocket's peer sent {} bytes; closing it", size);
        self->cut();
    });
    core_->on_socket(std::make_unique<Handle>(shared_from_this()));
}

bool Watcher::send(Socket::Kind kind, std::string_view message) {
    if (!ready()) return false;
    sending_ = true;
    outgoing_.assign(message);
    socket_.text(kind == Socket::Kind::Text);
    socket_.async_write(asio::buffer(outgoing_),
                        [self = shared_from_this()](error_code error, std::size_t) {
                            self->sending_ = false;
                            if (error) self->cut();
                        });
    return true;
}

/// A connection that asks for files, one request after another.
class Visitor : public Peer, public std::enable_shared_from_this<Visitor> {
  public:
    Visitor(std::shared_ptr<Core> core, tcp::socket socket)
        : Peer(std::move(core)), stream_(std::move(socket)) {}

    void read();
    void cut() override { stream_.close(); }

  private:
    void on_header(error_code error);
    void answer();
    void answer_file(const std::filesystem::path& file);
    void answer_text(web::status status, std::string text);
    template <class Body>
    void write(web::response<Body> response);
    void part();
    void drain();

    beast::tcp_stream stream_;
    beast::flat_buffer buffer_;
    std::optional<web::request_parser<web::empty_body>> parser_;
    bool head_ = false;
    bool keep_ = false;
    int requests_ = 0;
    std::array<char, 4096> scratch_{};
    std::size_t drained_ = 0;
};

void Visitor::read() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(core_->options.limits.header_bytes));
    stream_.expires_after(core_->options.limits.request);  // for the whole header, however it drips
    web::async_read_header(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](error_code error, std::size_t) { self->on_header(error); });
}

void Visitor::on_header(error_code error) {
    if (core_->over) return;
    head_ = false;
    keep_ = false;
    if (!error) {
        // A body is never read, so what follows one would be taken for a request.
        const bool body = parser_->chunked() || parser_->content_length().value_or(0) > 0;
        keep_ = parser_->keep_alive() && !body && ++requests_ < kRequestsPerConnection;
        return answer();
    }
    if (error == web::error::end_of_stream) return;
    if (error == web::error::header_limit) {
        return answer_text(
            web::status::request_header_fields_too_large,
            "header longer than " + std::to_string(core_->options.limits.header_bytes) + " bytes");
    }
    if (error.category() == web::make_error_code(web::error::bad_method).category()) {
        spdlog::debug("http: not a request: {}", error.message());
        return answer_text(web::status::bad_request, "not an HTTP request: " + error.message());
    }
}

void Visitor::answer() {
    const auto& request = parser_->get();
    head_ = request.method() == web::verb::head;
    const std::string_view target(request.target().data(), request.target().size());
    if (target.substr(0, target.find('?')) == core_->options.socket_path) {
        if (!websocket::is_upgrade(request)) {
            return answer_text(web::status::upgrade_required, "only a WebSocket is served here");
        }
        stream_.expires_never();  // the WebSocket has deadlines of its own
        return std::make_shared<Watcher>(core_, std::move(stream_), parser_->release())->open();
    }
    if (!head_ && request.method() != web::verb::get) {
        return answer_text(web::status::method_not_allowed, "only GET and HEAD are served");
    }
    const Found found = find_file(core_->options.folder, target);
    switch (found.what) {
        case Found::What::File:
            return answer_file(found.file);
        case Found::What::Missing:
            return answer_text(web::status::not_found, found.reason);
        case Found::What::Malformed:
            return answer_text(web::status::bad_request, found.reason);
    }
}

void Visitor::answer_file(const std::filesystem::path& file) {
    web::file_body::value_type body;
    error_code error;
    body.open(file.c_str(), beast::file_mode::scan, error);
    if (error) return answer_text(web::status::not_found, "cannot read it: " + error.message());
    const std::uint64_t size = body.size();
    const auto describe = [&](auto& response) {
        const std::string_view type = mime_type(file);
        response.set(web::field::content_type, beast::string_view(type.data(), type.size()));
        response.content_length(size);
    };
    if (head_) {
        web::response<web::empty_body> response;
        describe(response);
        return write(std::move(response));
    }
    web::response<web::file_body> response;
    response.body() = std::move(body);
    describe(response);
    write(std::move(response));
}

void Visitor::answer_text(web::status status, std::string text) {
    text += '\n';
    const auto describe = [&](auto& response) {
        response.result(status);
        response.set(web::field::content_type, "text/plain; charset=utf-8");
        response.content_length(text.size());
        if (status == web::status::method_not_allowed) response.set(web::field::allow, "GET, HEAD");
        if (status == web::status::upgrade_required) response.set(web::field::upgrade, "websocket");
    };
    if (head_) {
        web::response<web::empty_body> response;
        describe(response);
        return write(std::move(response));
    }
    web::response<web::string_body> response;
    describe(response);
    response.body() = std::move(text);
    write(std::move(response));
}

template <class Body>
void Visitor::write(web::response<Body> response) {
    response.set(web::field::server, "keepaway3d");
    response.set(web::field::cache_control, "no-cache");  // a rebuilt page shows at once
    response.set("X-Content-Type-Options", "nosniff");
    response.keep_alive(keep_);
    const auto kept = std::make_shared<web::response<Body>>(std::move(response));
    stream_.expires_after(core_->options.limits.answer);
    web::async_write(stream_, *kept,
                     [self = shared_from_this(), kept](error_code error, std::size_t) {
                         if (error || self->core_->over) return;
                         self->keep_ ? self->read() : self->part();
                     });
}

/// Closes so that the answer arrives: bytes left unread would make the kernel reset the connection
/// and the peer lose what we said.
void Visitor::part() {
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    stream_.expires_after(kDrainTime);
    drain();
}

void Visitor::drain() {
    stream_.async_read_some(asio::buffer(scratch_),
                            [self = shared_from_this()](error_code error, std::size_t size) {
                                self->drained_ += size;
                                if (!error && self->drained_ < kDrainBytes) self->drain();
                            });
}

/// Says why, without waiting for anybody, and closes.
void turn_away(tcp::socket socket) {
    static constexpr std::string_view kAnswer =
        "HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\nContent-Length: 21\r\n\r\n"
        "too many connections\n";
    error_code ignored;
    socket.non_blocking(true, ignored);
    socket.send(asio::buffer(kAnswer), 0, ignored);
    socket.shutdown(tcp::socket::shutdown_send, ignored);
}

tcp::acceptor listen(asio::io_context& io, const std::string& address, std::uint16_t port) {
    const auto fail = [&](const std::string& why) {
        throw net::NetError("cannot listen on " + address + ":" + std::to_string(port) + ": " +
                            why);
    };
    error_code error;
    const auto ip = asio::ip::make_address(address, error);
    if (error) fail("not an IP address");
    const tcp::endpoint endpoint(ip, port);
    tcp::acceptor acceptor(io);
    acceptor.open(endpoint.protocol(), error);
    // The next episode's server takes the same port while old connections linger.
    if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error) fail(error.message());
    return acceptor;
}

}  // namespace

struct Server::Impl {
    Impl(net::Loop& loop, Options options, OnSocket on_socket)
        : acceptor(listen(loop.impl().io, options.address, options.port)),
          port(acceptor.local_endpoint().port()),
          pause(loop.impl().io),
          core(std::make_shared<Core>()) {
        core->options = std::move(options);
        core->on_socket = std::move(on_socket);
        accept();
    }

    ~Impl() {
        core->over = true;
        for (Peer* peer : core->peers) peer->cut();
    }

    void accept() {
        acceptor.async_accept([this, core = core](error_code error, tcp::socket socket) {
            if (core->over) return;  // then `this` is gone
            if (error) return accept_later(error);
            if (core->peers.size() < core->options.limits.connections) {
                std::make_shared<Visitor>(core, std::move(socket))->read();
            } else {
                turn_away(std::move(socket));
            }
            accept();
        });
    }

    /// Out of file descriptors, mostly: trying again at once would spin.
    void accept_later(error_code error) {
        spdlog::warn("http: cannot take a connection: {}", error.message());
        pause.expires_after(kAcceptPause);
        pause.async_wait([this, core = core](error_code) {
            if (!core->over) accept();
        });
    }

    tcp::acceptor acceptor;
    std::uint16_t port;
    asio::steady_timer pause;
    std::shared_ptr<Core> core;
};

Server::Server(net::Loop& loop, Options options, OnSocket on_socket)
    : impl_(std::make_unique<Impl>(loop, std::move(options), std::move(on_socket))) {}
Server::~Server() = default;
std::uint16_t Server::port() const {
    return impl_->port;
}
std::size_t Server::connections() const {
    return impl_->core->peers.size();
}

}  // namespace k3d::http

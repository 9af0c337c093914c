// SPDX-License-Identifier: BSD-3-Clause
// Who watches, and who has been told what.
#include "server/viewer/viewer.h"

#include <filesystem>
#include <stdexcept>

#include "common/http/server.h"
#include "common/log/log.h"
#include "server/viewer/beliefs.h"
#include "server/viewer/scene_json.h"

namespace k3d::server::viewer {

namespace fs = std::filesystem;

namespace {

// Faster than any screen; at the fast pace, more would only slow the simulation.
constexpr std::chrono::milliseconds kLeastInterval{10};
constexpr std::chrono::milliseconds kBeliefInterval{50};

std::string checked(const std::string& web_folder) {
    std::error_code ignored;
    if (fs::is_regular_file(fs::path(web_folder) / "index.html", ignored)) return web_folder;
    throw std::runtime_error("no page in " + web_folder +
                             " (no index.html): install npm, then configure and build again");
}

struct Page {
    std::unique_ptr<http::Socket> socket;
    int told = 0;  ///< revision of the scene it knows; 0 = none yet
};

}  // namespace

struct Viewer::Impl {
    Impl(net::Loop& loop, const std::string& address, std::uint16_t port,
         const std::string& web_folder, const std::string& beliefs_folder)
        : beliefs(beliefs_folder),
          server(loop, {.address = address, .port = port, .folder = checked(web_folder)},
                 [this](std::unique_ptr<http::Socket> socket) {
                     spdlog::debug("viewer: a page opened");
                     pages.push_back({std::move(socket)});
                 }) {}

    /// A socket counts as one of the server's connections until it is destroyed.
    void forget_closed() {
        std::erase_if(pages, [](const Page& page) { return page.socket->closed(); });
    }

    void publish(const SceneView& scene) {
        forget_closed();
        if (pages.empty()) return;
        const auto now = net::Clock::now();
        if (now - last < kLeastInterval) return;
        last = now;

        SceneKey next = key_of(scene);
        if (revision == 0 || next != key) {
            key = std::move(next);
            ++revision;
        }
        tell_beliefs(now);
        std::string whole, moment;  // each made once, and only if some page needs it
        for (Page& page : pages) {
            if (!page.socket->ready()) continue;
            const bool is_new = page.told != revision;
            std::string& text = is_new ? whole : moment;
            if (text.empty()) text = is_new ? scene_json(scene) : moment_json(scene);
            if (page.socket->send(http::Socket::Kind::Text, text)) page.told = revision;
        }
    }

    /// In place of a scene for those who have one. A page that misses some sees the next: agents
    /// write five a second.
    void tell_beliefs(net::Clock::time_point now) {
        if (now - beliefs_read < kBeliefInterval) return;
        beliefs_read = now;
        const std::string text = beliefs.news();
        if (text.empty()) return;
        for (Page& page : pages) {
            if (page.told == revision && page.socket->ready()) {
                page.socket->send(http::Socket::Kind::Text, text);
            }
        }
    }

    Beliefs beliefs;
    net::Clock::time_point beliefs_read{};
    std::vector<Page> pages;
    SceneKey key;
    int revision = 0;
    net::Clock::time_point last{};
    http::Server server;
};

Viewer::Viewer(net::Loop& loop, const std::string& address, std::uint16_t port,
               const std::string& web_folder, const std::string& beliefs_folder)
    : impl_(std::make_unique<Impl>(loop, address, port, web_folder, beliefs_folder)) {}

Viewer::~Viewer() = default;

std::uint16_t Viewer::port() const {
    return impl_->server.port();
}

bool Viewer::watched() {
    impl_->forget_closed();
    return !impl_->pages.empty();
}

void Viewer::publish(const SceneView& scene) {
    impl_->publish(scene);
}

std::string web_folder_beside_program() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return (program.parent_path().parent_path() / "web").string();
}

}  // namespace k3d::server::viewer

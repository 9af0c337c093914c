// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/run_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "common/http/server.h"
#include "common/net/net.h"
#include "optimizer/fitness/fitness.h"
#include "optimizer/report/curves.h"

namespace k3d::optimizer::report {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN; a gap in a curve is null.
Json numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(std::isfinite(value) ? Json(value) : Json());
    return list;
}

Json fitness_json(const Curves& curves) {
    std::vector<double> generation, best, median, mean, low, high, champion;
    for (const GenerationFigures& g : curves.fitness) {
        const double se = g.all.se.value_or(0.0);
        generation.push_back(g.generation);
        best.push_back(g.best);
        median.push_back(g.median);
        mean.push_back(*g.all.mean);
        low.push_back(*g.all.mean - se);
        high.push_back(*g.all.mean + se);
        double validated = std::nan("");
        for (const ValidatedFigures& v : curves.champion) {
            if (v.generation == g.generation) validated = v.mean;
        }
        champion.push_back(validated);
    }
    return {{"generation", numbers(generation)}, {"best", numbers(best)},
            {"median", numbers(median)},         {"mean", numbers(mean)},
            {"mean_low", numbers(low)},          {"mean_high", numbers(high)},
            {"champion", numbers(champion)}};
}

Json curves_json(const Curves& curves) {
    Json out = fitness_json(curves);
    std::size_t logged = 0;
    out["logged"] = Json::object();
    for (const auto& [name, values] : curves.logged) {
        out["logged"][name] = numbers(values);
        logged = std::max(logged, values.size());
    }
    out["species"] = Json::array();
    for (const auto& [id, sizes] : curves.species) {
        out["species"].push_back({{"id", id}, {"sizes", numbers(sizes)}});
        logged = std::max(logged, sizes.size());
    }
    out["logged_generation"] = Json::array();
    for (std::size_t i = 0; i < logged; ++i) out["logged_generation"].push_back(i);
    out["parameters"] = Json::array();
    for (const Trace& t : curves.parameters) {
        // Candidates of an open generation have no values yet.
        out["parameters"].push_back({{"name", t.name},
                                     {"best", numbers(t.best)},
                                     {"low", numbers(t.low)},
                                     {"high", numbers(t.high)}});
    }
    return out;
}

Json champion_json(const algorithm::Champion& champion, const std::vector<std::string>& names) {
    Json values = Json::array();
    if (const auto* numbers_of = std::get_if<std::vector<double>>(&champion.payload)) {
        for (std::size_t i = 0; i < names.size() && i < numbers_of->size(); ++i) {
            values.push_back({names[i], (*numbers_of)[i]});
        }
    } else {
        const auto& net = std::get<network::Definition>(champion.payload);
        values.push_back({"hidden nodes", net.nodes.size() - net.outputs.size()});
        values.push_back({"links", net.links.size()});
    }
    return {{"candidate", champion.candidate}, {"mean", champion.score.mean},
            {"se", champion.score.se},         {"n", champion.score.n},
            {"validated", champion.validated}, {"values", values}};
}

struct Peer {
    std::unique_ptr<http::Socket> socket;
    int course = 0;  ///< revisions it has been told
    int status = 0;
};

std::string checked(const std::string& folder) {
    std::error_code ignored;
    if (fs::is_regular_file(fs::path(folder) / "index.html", ignored)) return folder;
    throw std::runtime_error("no page in " + folder +
                             " (no index.html): install npm, then configure and build again");
}

}  // namespace

std::string course_json(const RunFacts& run) {
    const spec::Experiment& e = run.experiment;
    const auto names = value_names(e);
    const auto facts = run.ledger.facts();
    const Json course{
        {"name", e.name},
        {"description", e.description},
        {"algorithm", e.algorithm.name},
        {"task", e.task.name},
        {"measure", fitness::measure(e.task)},
        {"version", facts.at("code_version")},
        {"ended", run.ended ? Json(*run.ended) : Json()},
        {"champion", run.champion ? champion_json(*run.champion, names) : Json()},
        {"curves", curves_json(curves_of(run.ledger, names))}};
    return Json{{"course", course}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string status_json(const RunView& view, const std::string& backend,
                        const std::string& rates) {
    const Json status{{"test", view.test},         {"generation", view.generation},
                      {"known", view.known},       {"episodes", view.episodes},
                      {"backend", backend},        {"rates", rates}};
    return Json{{"status", status}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string run_page_folder() {
    return (fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "run-page").string();
}

struct RunPage::Impl {
    net::Loop loop;
    std::vector<Peer> peers;
    std::string course, status;
    int course_revision = 0;
    int status_revision = 0;
    http::Server server;

    Impl(const std::string& address, std::uint16_t port, const std::string& folder)
        : server(loop, {.address = address, .port = port, .folder = checked(folder)},
                 [this](std::unique_ptr<http::Socket> socket) {
                     peers.push_back({std::move(socket)});
                 }) {}

    /// A socket holds one message: the course first, then the latest status.
    void tell(Peer& peer) const {
        const auto news = [&peer](int& told, int revision, const std::string& text) {
            if (told == revision || !peer.socket->ready()) return;
            if (peer.socket->send(http::Socket::Kind::Text, text)) told = revision;
        };
        news(peer.course, course_revision, course);
        news(peer.status, status_revision, status);
    }
};

RunPage::RunPage(const std::string& address, std::uint16_t port, const std::string& folder)
    : impl_(std::make_unique<Impl>(address, port, folder)) {}

RunPage::~RunPage() = default;

std::uint16_t RunPage::port() const {
    return impl_->server.port();
}

void RunPage::publish_course(std::string json) {
    impl_->course = std::move(json);
    ++impl_->course_revision;
}

void RunPage::publish_status(std::string json) {
    impl_->status = std::move(json);
    ++impl_->status_revision;
}

void RunPage::poll() {
    impl_->loop.poll();
    std::erase_if(impl_->peers, [](const Peer& peer) { return peer.socket->closed(); });
    for (Peer& peer : impl_->peers) impl_->tell(peer);
    impl_->loop.poll();
}

}  // namespace k3d::optimizer::report

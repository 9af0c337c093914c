// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/backend/job_pool.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "common/log/log.h"
#include "optimizer/backend/log_folder.h"
#include "optimizer/episode/job_match.h"

namespace k3d::optimizer::backend {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds kLongestWait{500};
constexpr std::uintmax_t kLeastSpace = 4 * 1024 * 1024;

/// Of a daemon that was killed during the same try there may be files: a result among them would be
/// taken for one of ours.
std::string make_empty(const std::string& path) {
    std::error_code fault;
    fs::remove_all(path, fault);
    if (fault) throw std::runtime_error(fmt::format("log folder {}: {}", path, fault.message()));
    return make_log_folder(path);
}

std::string this_worker() {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    return fmt::format("{}:{}", host.data(), ::getpid());
}

std::uintmax_t telemetry_bytes(const std::string& folder) {
    std::uintmax_t bytes = 0;
    std::error_code fault;
    for (const auto& entry : fs::recursive_directory_iterator(folder, fault)) {
        if (!entry.path().string().ends_with(".telemetry.jsonl")) continue;
        const auto size = entry.file_size(fault);
        if (!fault) bytes += size;
    }
    return bytes;
}

/// What is wrong with it; empty while there is room for the files of episodes.
std::string full_disk(const std::string& folder) {
    std::error_code fault;
    const fs::space_info space = fs::space(folder, fault);
    if (fault || space.available >= kLeastSpace) return "";
    return fmt::format("{}: only {} KiB are left on this disk", folder, space.available / 1024);
}

}  // namespace

JobPool::JobPool(int slots, const std::string& log_folder)
    : slots_(static_cast<std::size_t>(slots)),
      folder_(log_folder.empty() ? make_temporary_log_folder("k3d-jobs-")
                                 : make_log_folder(log_folder)),
      temporary_(log_folder.empty()),
      worker_(this_worker()) {}

JobPool::~JobPool() {
    for (auto& running : running_) {
        std::visit([](auto& episode) { episode.reset(); }, running->episode);
        end_logs(running->folder, false);  // given up, not failed
    }
    std::error_code ignored;
    if (temporary_) fs::remove(folder_, ignored);
}

void JobPool::start(const episode::Job& job) {
    K3D_ASSERT(room() > 0);
    auto running = std::make_unique<Running>();
    running->job = job;
    std::string name = job.run + "-" + job.key.text();
    std::replace(name.begin(), name.end(), '/', '-');
    running->folder = make_empty(fmt::format("{}/{}-try-{}", folder_, name, job.attempt));
    if (spec::drill_of(job.task.name).empty()) {
        running->match = episode::match_of(job, running->folder);
        const episode::Task task{0, job.seed, job.attempt};
        running->episode =
            std::make_unique<episode::Episode>(running->match, task, running->folder, -1);
    } else {
        running->episode = std::make_unique<drill::DrillProcess>(job, running->folder);
    }
    running_.push_back(std::move(running));
}

std::vector<episode::Outcome> JobPool::poll() {
    std::vector<episode::Outcome> ended;
    for (auto& [run, outcome] : poll_with_runs()) ended.push_back(std::move(outcome));
    return ended;
}

std::vector<std::pair<std::string, episode::Outcome>> JobPool::poll_with_runs() {
    std::vector<std::pair<std::string, episode::Outcome>> ended;
    for (auto at = running_.begin(); at != running_.end();) {
        auto ending = std::visit([](auto& episode) { return episode->poll(); }, (*at)->episode);
        if (!ending) {
            ++at;
            continue;
        }
        const std::unique_ptr<Running> over = std::move(*at);
        at = running_.erase(at);
        end_logs(over->folder, !ending->has_value());
        if (!*ending) {
            // An episode that found no room for its files, or no process, has not failed: nothing
            // can be played here now.
            if (fault_.empty()) {
                fault_ = ending->error().of_machine ? ending->error().reason : full_disk(folder_);
            }
            if (!fault_.empty()) continue;
            ending->error().reason += "; logs in " + over->folder;
        }
        ended.emplace_back(over->job.run, outcome(*over, std::move(*ending)));
    }
    // What has a result is worth keeping, so it goes out before the error does.
    if (!fault_.empty() && ended.empty()) throw std::runtime_error(fault_);
    return ended;
}

episode::Clock::time_point JobPool::next_look() const {
    episode::Clock::time_point next = episode::Clock::now() + kLongestWait;
    for (const auto& running : running_) {
        next = std::min(next, std::visit([](const auto& e) { return e->next_look(); },
                                         running->episode));
    }
    return next;
}

episode::Clock::time_point JobPool::Running::started() const {
    return std::visit([](const auto& e) { return e->started(); }, episode);
}

std::vector<JobPool::Progress> JobPool::progress() const {
    std::vector<Progress> all;
    for (const auto& running : running_) {
        const episode::Job& job = running->job;
        all.push_back({job.run, job.key, job.attempt, telemetry_bytes(running->folder)});
    }
    return all;
}

episode::Outcome JobPool::outcome(const Running& running, episode::Ending ending) const {
    const auto since = episode::Clock::now() - running.started();
    const double wall_s = std::chrono::duration<double>(since).count();
    return {running.job.key, running.job.seed, running.job.attempt,
            episode::fingerprint(running.job), std::move(ending), wall_s, worker_};
}

void JobPool::end_logs(const std::string& folder, bool failed) {
    std::error_code ignored;
    if (!failed) {
        fs::remove_all(folder, ignored);
        return;
    }
    kept_.push_back(folder);
    if (kept_.size() <= kKeptLogs) return;
    fs::remove_all(kept_.front(), ignored);
    kept_.pop_front();
}

}  // namespace k3d::optimizer::backend

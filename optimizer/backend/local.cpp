// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/backend/local.h"

#include <algorithm>

#include "common/log/log.h"

namespace k3d::optimizer::backend {

namespace {
constexpr std::chrono::milliseconds kLongestWait{500};
}

LocalPool::LocalPool(const spec::MatchSpec& spec)
    : spec_(spec), logs_(spec.log_folder), slots_(static_cast<std::size_t>(spec.jobs)) {}

LocalPool::~LocalPool() {
    for (auto& slot : slots_) {
        if (!slot) continue;
        const std::string folder = slot->folder();
        slot.reset();
        logs_.end(folder, false);  // given up, not failed
    }
}

bool LocalPool::has_room() const {
    return running() < slots_.size();
}

std::size_t LocalPool::running() const {
    return static_cast<std::size_t>(
        std::count_if(slots_.begin(), slots_.end(), [](const auto& slot) { return bool(slot); }));
}

void LocalPool::start(const episode::Task& task) {
    const auto slot = std::find(slots_.begin(), slots_.end(), nullptr);
    K3D_ASSERT(slot != slots_.end());
    const bool first = slot == slots_.begin();
    const int http_port = first ? page_port_.value_or(spec_.http_port) : -1;
    const std::string folder = logs_.begin(task);
    try {
        *slot = std::make_unique<episode::Episode>(spec_, task, folder, http_port);
    } catch (...) {
        logs_.end(folder, false);
        throw;
    }
}

std::vector<Finished> LocalPool::poll() {
    std::vector<Finished> finished;
    for (auto& slot : slots_) {
        if (!slot) continue;
        auto ending = slot->poll();
        if (!page_port_) page_port_ = slot->page_port();
        if (!ending) continue;
        const std::chrono::duration<double> wall = episode::Clock::now() - slot->started();
        logs_.end(slot->folder(), !ending->has_value());
        finished.push_back({slot->task(), std::move(*ending), wall.count(), slot->folder()});
        slot.reset();
    }
    return finished;
}

episode::Clock::time_point LocalPool::next_look() const {
    episode::Clock::time_point next = episode::Clock::now() + kLongestWait;
    for (const auto& slot : slots_) {
        if (slot) next = std::min(next, slot->next_look());
    }
    return next;
}

}  // namespace k3d::optimizer::backend

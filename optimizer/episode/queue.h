// SPDX-License-Identifier: BSD-3-Clause
// The tries of a run that are still to be made: episodes in order, failed ones first.
#pragma once

#include <deque>

#include "optimizer/episode/task.h"

namespace k3d::optimizer::episode {

class Queue {
  public:
    /// Episode k of `count`, counted from 0, has seed `seed + k`.
    Queue(std::uint64_t seed, int count) : seed_(seed), count_(count) {}

    bool empty() const { return again_.empty() && next_ == count_; }

    Task take() {
        if (again_.empty()) {
            const int index = next_++;
            return {index, seed_ + static_cast<std::uint64_t>(index), 1};
        }
        const Task task = again_.front();
        again_.pop_front();
        return task;
    }

    /// For one more try.
    void put_back(const Task& task) { again_.push_back({task.index, task.seed, task.attempt + 1}); }

  private:
    std::uint64_t seed_;
    int count_;
    int next_ = 0;
    std::deque<Task> again_;
};

}  // namespace k3d::optimizer::episode

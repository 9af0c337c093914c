// SPDX-License-Identifier: BSD-3-Clause
// Jobs on a machine that can play no more: what has been played is told all the same.
#include "optimizer/backend/job_pool.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "optimizer/backend/local_backend.h"
#include "tests/optimizer/fake_programs.h"

// Found before that of the C library, so that a test can fill the disk.
static bool disk_is_full = false;
extern "C" int statvfs(const char* path, struct statvfs* disk) noexcept {
    using Own = int (*)(const char*, struct statvfs*);
    static const auto own = reinterpret_cast<Own>(::dlsym(RTLD_NEXT, "statvfs"));
    const int fault = own(path, disk);
    if (fault == 0 && disk_is_full) disk->f_bavail = 0;
    return fault;
}

namespace k3d::optimizer::backend {
namespace {

class Jobs : public FakePrograms {
  protected:
    ~Jobs() override { disk_is_full = false; }

    episode::Job job(std::uint64_t seed) const {
        episode::Job job;
        job.run = "a";
        job.key = {episode::Phase::Test, 0, seed, 0};
        job.seed = seed;
        job.task.keepers = spec_.keepers;
        job.task.takers = spec_.takers;
        job.task.server_program = spec_.server_program;
        job.task.agent_program = spec_.agent_program;
        return job;
    }

    static bool await(const std::function<bool()>& reached) {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!reached()) {
            if (std::chrono::steady_clock::now() > deadline) return false;
            ::usleep(5000);
        }
        return true;
    }

    /// Servers that have not ended yet.
    std::ptrdiff_t servers() const {
        const std::filesystem::directory_iterator files(base_);
        return std::count_if(begin(files), end(files), [](const auto& file) {
            return file.path().filename().string().starts_with("port-");
        });
    }

    /// All scripts have ended, whether or not their owner has looked.
    bool all_over() const {
        const auto started = pids();
        return std::all_of(started.begin(), started.end(), [](pid_t pid) {
            const std::string stat = content("/proc/" + std::to_string(pid) + "/stat");
            return stat.empty() || stat.find(") Z") != std::string::npos;
        });
    }

    /// Once all is over, the first job's result is told, and then why the second one has none.
    void expect_result_then_fault(JobPool& pool, const std::string& fault) const {
        ASSERT_TRUE(await([this] { return all_over(); }));
        const auto ended = pool.poll();
        ASSERT_EQ(ended.size(), 1U);
        EXPECT_EQ(ended[0].seed, 1U);
        EXPECT_TRUE(ended[0].ending.has_value());
        try {
            pool.poll();
            FAIL() << "what this machine cannot play is no failure of the episode";
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(error.what(), fault);
        }
    }
};

TEST_F(Jobs, AFullDiskIsNoFailureAndLosesNoResult) {
    const std::string gate = "until [ -e $base/gate ]; do sleep 0.02; done";
    server_plays("[ $seed = 1 ] || { " + gate + "; exit 1; }; result >> $results");
    agents_play("[ $role = taker ] || kick; until_end; " + gate);
    JobPool pool(2, base_ + "/logs");
    pool.start(job(1));
    pool.start(job(2));
    // The first has its result and waits for its agents only; then both end at once.
    ASSERT_TRUE(await([&] {
        EXPECT_TRUE(pool.poll().empty());
        return pids().size() == 2 * 4 && servers() == 1;
    }));
    EXPECT_TRUE(pool.poll().empty());
    disk_is_full = true;
    std::ofstream(base_ + "/gate").flush();
    expect_result_then_fault(pool, base_ + "/logs: only 0 KiB are left on this disk");
}

TEST_F(Jobs, AProgramThatCannotBeStartedIsNoFailureAndLosesNoResult) {
    const std::string gate = "until [ -e $base/gate ]; do sleep 0.02; done; ";
    server_plays(": > $base/ready-$seed; " + gate + "result >> $results");
    JobPool pool(2, base_ + "/logs");
    pool.start(job(1));
    ASSERT_TRUE(await([&] {
        EXPECT_TRUE(pool.poll().empty());
        return pids().size() == 4;
    }));
    episode::Job other = job(2);
    other.task.taker_command = "/nowhere/taker";
    pool.start(other);
    // Nobody looks until the first is over and the second one's server waits for its agents.
    ASSERT_TRUE(await([this] { return std::filesystem::exists(base_ + "/ready-2"); }));
    std::ofstream(base_ + "/gate").flush();
    expect_result_then_fault(pool, "cannot start /nowhere/taker: No such file or directory");
}

TEST_F(Jobs, AProgramThatStartsAndFailsIsTheJobsMatter) {
    server_plays("sleep 600");
    agents_play("echo I know no such flag; exit 2");
    JobPool pool(1, base_ + "/logs");
    pool.start(job(1));
    std::vector<episode::Outcome> ended;
    ASSERT_TRUE(await([&] {
        ended = pool.poll();
        return !ended.empty();
    }));
    const episode::Failure& failure = ended[0].ending.error();
    EXPECT_THAT(failure.reason, testing::HasSubstr(": exit code 2: I know no such flag"));
    EXPECT_EQ(failure.hopeless, 2);
}

TEST_F(Jobs, AStartThatFailsLosesNoResult) {
    LocalBackend backend(1, base_ + "/logs");
    backend.submit(job(1));
    backend.submit(job(2));
    backend.poll();
    ASSERT_TRUE(await([this] { return !pids().empty(); }));
    std::filesystem::rename(base_ + "/server", base_ + "/gone");
    std::vector<episode::Outcome> ended;
    ASSERT_TRUE(await([&] {
        ended = backend.poll();
        return !ended.empty();
    }));
    EXPECT_EQ(ended[0].seed, 1U);
    EXPECT_THROW(backend.poll(), process::ProcessError);
}

}  // namespace
}  // namespace k3d::optimizer::backend

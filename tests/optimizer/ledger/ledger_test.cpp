// SPDX-License-Identifier: BSD-3-Clause
// The ledger: one row per episode whatever comes, and no file that makes it crash.
#include "optimizer/ledger/ledger.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "optimizer/ledger/lock.h"

// SQLite finds these before those of the C library: how often it has waited for the disk.
static std::atomic<int> disk_waits{0};
extern "C" int fsync(int file) {
    ++disk_waits;
    return static_cast<int>(::syscall(SYS_fsync, file));
}
extern "C" int fdatasync(int file) {
    ++disk_waits;
    return static_cast<int>(::syscall(SYS_fdatasync, file));
}

namespace k3d::optimizer::ledger {
namespace {

using episode::Key;
using episode::Phase;
using testing::HasSubstr;

class LedgerFile : public testing::Test {
  protected:
    LedgerFile() : folder_(testing::TempDir() + "k3d_ledger_" + std::to_string(::getpid())) {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~LedgerFile() override { std::filesystem::remove_all(folder_); }

    std::string file() const { return folder_ + "/ledger.sqlite"; }
    Ledger create() const { return Ledger::create(file(), {{"name", "a"}, {"id", "a-1"}}); }

    std::string fault_of_open() const {
        try {
            const Ledger ledger = Ledger::open(file(), Ledger::Access::Write);
            ledger.rows();
            ledger.facts();
            ledger.last_round();
            ledger.log();
            ledger.failed_tries();
            ledger.candidates();
        } catch (const LedgerError& error) {
            return error.what();
        }
        return "no fault";
    }

    std::string folder_;
};

Row row(int generation, std::uint64_t candidate, int episode, double fitness) {
    Row r;
    r.key = {Phase::Train, generation, candidate, episode};
    r.seed = 77;
    r.fingerprint = "f";
    r.status = "finished";
    r.reason = "ball_out";
    r.fitness = fitness;
    r.simulated_s = 10.0;
    r.result = "{\"x\":" + std::to_string(fitness) + "}";
    r.worker = "here:1";
    return r;
}

TEST_F(LedgerFile, KeepsOneRowPerEpisodeInTheOrderOfKeys) {
    Ledger ledger = create();
    EXPECT_TRUE(ledger.add({row(1, 4, 0, 2.0), row(0, 9, 1, 3.0)}).empty());
    Row copy = row(0, 9, 1, 3.0);
    copy.worker = "there:2";
    copy.wall_s = 5.0;
    EXPECT_TRUE(ledger.add({copy, row(0, 2, 0, 1.0)}).empty());
    const auto rows = ledger.rows();
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].key, (Key{Phase::Train, 0, 2, 0}));
    EXPECT_EQ(rows[1].key, (Key{Phase::Train, 0, 9, 1}));
    EXPECT_EQ(rows[1].worker, "here:1");
    EXPECT_EQ(rows[2].key, (Key{Phase::Train, 1, 4, 0}));
    EXPECT_EQ(ledger.find({Phase::Train, 1, 4, 0})->fitness, 2.0);
    EXPECT_FALSE(ledger.find({Phase::Test, 1, 4, 0}));
    EXPECT_EQ(ledger.totals().episodes, 3U);
    EXPECT_EQ(ledger.simulated_before(1), 20.0);
}

TEST_F(LedgerFile, AnotherResultOfTheSameEpisodeIsToldAndTheFirstStays) {
    Ledger ledger = create();
    ledger.add({row(0, 1, 0, 1.0)});
    const auto contradicted = ledger.add({row(0, 1, 0, 2.0)});
    ASSERT_EQ(contradicted.size(), 1U);
    EXPECT_EQ(contradicted[0].fitness, 2.0);
    EXPECT_EQ(ledger.rows()[0].fitness, 1.0);
}

TEST_F(LedgerFile, EverythingIsThereWhenItIsOpenedAgain) {
    {
        Ledger ledger = create();
        Row failed = row(0, 1, 0, 0.0);
        failed.status = "failed";
        const Key key = failed.key;
        ledger.add({failed}, {{key, 1, "server: killed", "w"}, {key, 2, "again", "w"}});
        ledger.save_round({1, "{\"s\":1}", {{{"generation", 0}, {"best", 2.5}}}}, {{1, 0, "[1.0]"}});
        ledger.save_round({2, "{\"s\":2}", {{{"generation", 1}, {"best", 3.5}}}}, {{1, 0, "[1.0]"}});
        ledger.set_fact("finished", "now");
    }
    const Ledger ledger = Ledger::open(file(), Ledger::Access::Read);
    EXPECT_EQ(ledger.facts().at("finished"), "now");
    EXPECT_EQ(ledger.last_round()->number, 2);
    EXPECT_EQ(ledger.last_round()->state, "{\"s\":2}");
    EXPECT_EQ(ledger.log().size(), 2U);
    EXPECT_EQ(ledger.candidates().size(), 1U);
    EXPECT_EQ(ledger.count_failed({Phase::Train, 0, 1, 0}), 2);
    EXPECT_EQ(ledger.failed_tries()[0].reason, "server: killed");
    EXPECT_EQ(ledger.totals().failed, 1U);
}

TEST_F(LedgerFile, TellsResultsOfTheTestFromThoseOfTheSearch) {
    Ledger ledger = create();
    Row failed = row(0, 1, 0, 0.0);
    failed.status = "failed";
    ledger.add({failed});
    EXPECT_FALSE(ledger.has_result(false));
    ledger.add({row(0, 1, 1, 1.0)});
    EXPECT_TRUE(ledger.has_result(false));
    EXPECT_FALSE(ledger.has_result(true));
    Row baseline = row(0, 0, 0, 1.0);
    baseline.key.phase = Phase::Baseline;
    ledger.add({baseline});
    EXPECT_TRUE(ledger.has_result(true));
}

TEST_F(LedgerFile, WaitsForTheDiskInEveryCall) {
    Ledger ledger = create();
    for (int i = 0; i < 3; ++i) {
        const int before = disk_waits;
        ledger.add({row(0, 1, i, 1.0)});
        EXPECT_GT(disk_waits, before) << "row " << i;
    }
    const int before = disk_waits;
    ledger.save_round({1, "{}", {}}, {});
    EXPECT_GT(disk_waits, before);
}

TEST_F(LedgerFile, WhatIsNoLedgerIsNamed) {
    EXPECT_EQ(fault_of_open(), file() + ": there is no such file");
    std::ofstream(file()) << "this is a text, and a long enough one to be looked at as a database "
                             "header by anybody who reads a hundred bytes of it at the beginning.";
    EXPECT_EQ(fault_of_open(), file() + ": file is not a database");
    std::filesystem::remove(file());
    std::ofstream(file()).flush();
    EXPECT_EQ(fault_of_open(), file() + ": this is no ledger of k3d-optimizer");
}

TEST_F(LedgerFile, IsNotMadeOverAnother) {
    create();
    EXPECT_THROW(create(), LedgerError);
}

TEST_F(LedgerFile, AFullDiskIsAnErrorAndLosesNothing) {
    Ledger ledger = create();
    ledger.add({row(0, 1, 0, 1.0)});
    std::string said;
    // What a full disk does: the file cannot grow.
    struct rlimit before{}, small{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    small = before;
    small.rlim_cur = std::filesystem::file_size(file()) + 64 * 1024;
    ::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &small);
    try {
        for (int i = 0; i < 10000; ++i) {
            Row big = row(1, 1, i, 1.0);
            big.result = std::string(4096, 'x');
            ledger.add({big});
        }
    } catch (const LedgerError& error) {
        said = error.what();
    }
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_THAT(said, HasSubstr(file() + ": "));
    const auto rows = Ledger::open(file(), Ledger::Access::Write).rows();
    EXPECT_GE(rows.size(), 1U);
    EXPECT_EQ(rows[0].fitness, 1.0);
}

TEST_F(LedgerFile, OneDaemonHasARun) {
    const Lock lock(folder_);
    try {
        const Lock second(folder_);
        FAIL() << "two locks";
    } catch (const LedgerError& error) {
        EXPECT_EQ(error.what(), folder_ + ": another k3d-optimizer is at work here, process " +
                                    std::to_string(::getpid()));
    }
}

TEST_F(LedgerFile, AnyDamageIsNamedOrHarmless) {
    {
        Ledger ledger = create();
        std::vector<Row> rows;
        for (int i = 0; i < 200; ++i) rows.push_back(row(i / 20, 1, i, i));
        ledger.add(rows);
        ledger.save_round({1, "{}", {{{"generation", 0}}}}, {{1, 0, "[1.0]"}});
    }
    std::ostringstream text;
    text << std::ifstream(file(), std::ios::binary).rdbuf();
    const std::string whole = text.str();
    rc::check("flipped bytes and lost ends", [&] {
        std::string damaged = whole;
        const auto count = *rc::gen::inRange(1, 20);
        for (int i = 0; i < count; ++i) {
            // Half of them in the header and the tables' definitions, where they hurt.
            const auto end = *rc::gen::element<std::size_t>(4096, damaged.size());
            const auto at = *rc::gen::inRange<std::size_t>(0, end);
            damaged[at] = static_cast<char>(*rc::gen::inRange(0, 256));
        }
        if (*rc::gen::inRange(0, 4) == 0) {
            damaged.resize(*rc::gen::inRange<std::size_t>(0, damaged.size()));
        }
        std::filesystem::remove(file() + "-wal");
        std::filesystem::remove(file() + "-shm");
        std::ofstream(file(), std::ios::binary) << damaged;
        const std::string said = fault_of_open();
        RC_ASSERT(said == "no fault" || said.rfind(file(), 0) == 0);
    });
}

TEST_F(LedgerFile, RateOfRows) {
    Ledger ledger = create();
    const auto begin = std::chrono::steady_clock::now();
    constexpr int kRows = 100;
    Row one = row(0, 1, 0, 1.0);
    one.result = std::string(900, 'x');  // as long as the line of five players
    for (int i = 0; i < kRows; ++i) {
        one.key.episode = i;
        ledger.add({one});
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    std::cout << "rows a second, a transaction each: " << kRows / took.count() << '\n';
    EXPECT_EQ(ledger.totals().episodes, static_cast<std::uint64_t>(kRows));
}

}  // namespace
}  // namespace k3d::optimizer::ledger

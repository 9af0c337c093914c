// SPDX-License-Identifier: BSD-3-Clause
// What stays in nats-server's queues, and for whom: no outcome is lost between queue and ledger.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include "integration/nats_process.h"
#include "integration/run_rig.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;

class Queue : public RunRig {
  protected:
    Queue() : nats_(folder_ + "/nats") {}

    process::Child start_worker(std::vector<std::string> flags) const {
        flags.insert(flags.begin(), {"worker", "--nats", nats_.url()});
        return start(flags, "worker.log");
    }
    process::Child start_daemon(std::vector<std::string> words) const {
        words.insert(words.end(), {"--nats", nats_.url(), "--lease-s", "1"});
        return start(words, "daemon.log");
    }
    void change_ledger(const std::string& sql) const {
        SQLite::Database ledger(path("hit/ledger.sqlite"), SQLite::OPEN_READWRITE, 10'000);
        ledger.exec(sql);
    }

    NatsProcess nats_;
};

TEST_F(Queue, KeepsOutcomesThatTheLedgerHasNotTaken) {
    std::string text = quick_experiment();
    text.replace(text.find("max_generations = 4"), 19, "max_generations = 1");
    write("exp.toml", text);
    process::Child daemon = start_daemon({"run", path("exp.toml"), "--run", path("hit")});
    ASSERT_TRUE(await(daemon, [&] { return std::filesystem::exists(path("hit/ledger.sqlite")); }))
        << content("daemon.log");
    // As on a disk that is full when the last of the first round's 6 x 4 episodes comes in.
    change_ledger("CREATE TRIGGER full BEFORE INSERT ON episodes "
                  "WHEN (SELECT count(*) FROM episodes) >= 23 "
                  "BEGIN SELECT RAISE(ABORT, 'no room'); END");
    process::Child worker = start_worker({"--jobs", "4"});
    const auto exit = daemon.wait(kRunPatience);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 1);
    EXPECT_THAT(content("daemon.log"), HasSubstr("ledger.sqlite: no room"));
    change_ledger("DROP TRIGGER full");
    const auto end = start_daemon({"resume", path("hit")}).wait(kRunPatience);
    ASSERT_TRUE(end) << "the last outcome is gone\n" << content("daemon.log");
    EXPECT_EQ(end->code, 0) << content("daemon.log");
    EXPECT_EQ(run({"run", path("exp.toml"), "--run", path("calm"), "--jobs", "4"}, "calm.log"), 0);
    EXPECT_EQ(canonical("hit"), canonical("calm"));
}

}  // namespace
}  // namespace k3d::testing

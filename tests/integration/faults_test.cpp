// SPDX-License-Identifier: BSD-3-Clause
// Runs on workers by way of nats-server, undisturbed and under twenty faults: the bytes are those of
// a calm run with one job. Faults strike at times that the machine decides; what must come out does
// not depend on them.
#include <gmock/gmock.h>
#include <nats/nats.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <thread>
#include <utility>
#include <vector>

#include "common/random/stream.h"
#include "integration/nats_process.h"
#include "integration/run_rig.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;
using std::chrono::milliseconds;

/// Gives every outcome to the daemon a second time.
class Doubler {
  public:
    explicit Doubler(const std::string& url) {
        natsOptions_Create(&options_);
        natsOptions_SetURL(options_, url.c_str());
        natsOptions_SetTimeout(options_, 30'000);
        natsOptions_SetMaxReconnect(options_, -1);
        natsOptions_SetReconnectWait(options_, 100);
        EXPECT_EQ(natsConnection_Connect(&connection_, options_), NATS_OK);
        EXPECT_EQ(natsConnection_Subscribe(&subscription_, connection_, "k3d.outcome.>", again, this),
                  NATS_OK);
    }
    ~Doubler() {
        natsSubscription_Destroy(subscription_);
        natsConnection_Destroy(connection_);
        natsOptions_Destroy(options_);
    }
    int count() const { return count_; }

  private:
    /// Our own copies come back too: every second sight of a text is one of them.
    static void again(natsConnection* connection, natsSubscription*, natsMsg* message, void* self) {
        auto& me = *static_cast<Doubler*>(self);
        const std::string text(natsMsg_GetData(message),
                               static_cast<std::size_t>(natsMsg_GetDataLength(message)));
        if (++me.seen_[text] % 2 == 1) {
            ++me.count_;
            natsConnection_Publish(connection, natsMsg_GetSubject(message), text.data(),
                                   static_cast<int>(text.size()));
        }
        natsMsg_Destroy(message);
    }

    natsOptions* options_ = nullptr;
    natsConnection* connection_ = nullptr;
    natsSubscription* subscription_ = nullptr;
    std::map<std::string, int> seen_;
    std::atomic<int> count_{0};
};

class Faults : public RunRig {
  protected:
    static constexpr int kWorkers = 3;
    static constexpr int kKinds = 5;  ///< of faults

    Faults() : nats_(folder_ + "/nats") {}

    static std::string log_of(int index) { return "worker-" + std::to_string(index) + ".log"; }

    void start_worker(int index) {
        workers_[index] = std::make_unique<process::Child>(
            start({"worker", "--nats", nats_.url(), "--jobs", "2"}, log_of(index)));
    }

    void start_daemon(const std::string& verb) {
        std::vector<std::string> words{verb};
        if (verb == "run") words.insert(words.end(), {path("exp.toml"), "--run"});
        words.insert(words.end(), {path("hit"), "--nats", nats_.url(), "--lease-s", lease_s_});
        daemon_ = std::make_unique<process::Child>(start(words, "daemon.log"));
    }

    std::string calm_bytes() {
        EXPECT_EQ(run({"run", path("exp.toml"), "--run", path("calm"), "--jobs", "4"}, "calm.log"), 0)
            << content("calm.log");
        return canonical("calm");
    }

    /// Waits for the daemon's end; it must be in order.
    void expect_end() {
        const auto exit = daemon_->wait(kRunPatience);
        ASSERT_TRUE(exit) << "the run has no end\n" << content("daemon.log");
        EXPECT_EQ(exit->code, 0) << content("daemon.log");
    }

    bool kill_an_episodes_server(RandomStream& random) {
        std::vector<pid_t> servers;
        std::error_code gone;
        for (const auto& entry : std::filesystem::directory_iterator(path("quick"), gone)) {
            servers.push_back(std::stoi(entry.path().filename()));
        }
        if (servers.empty()) return false;
        const pid_t pid = servers[static_cast<std::size_t>(random.below(int(servers.size())))];
        ::unlink((path("quick") + "/" + std::to_string(pid)).c_str());
        return ::kill(pid, SIGKILL) == 0;
    }

    /// Every kind as often as the others, in an order of chance.
    static std::vector<int> shuffled_kinds(int count, RandomStream& random) {
        std::vector<int> kinds;
        for (int i = 0; i < count; ++i) kinds.push_back(i % kKinds);
        for (int i = count - 1; i > 0; --i) std::swap(kinds[i], kinds[random.below(i + 1)]);
        return kinds;
    }

    /// One fault; false if there was nothing to strike.
    bool strike(int kind, RandomStream& random) {
        const int victim = random.below(kWorkers);
        switch (kind) {
            case 0:
                workers_[victim]->kill();
                start_worker(victim);
                return true;
            case 1:
                daemon_->kill();
                start_daemon("resume");
                return true;
            case 2:
                return kill_an_episodes_server(random);
            case 3:
                nats_.kill();
                std::this_thread::sleep_for(milliseconds(random.below(400)));
                nats_.start_again();
                return true;
            default:
                // Beyond its lease: others get its episodes, and it finishes them all the same.
                ::kill(workers_[victim]->pid(), SIGSTOP);
                std::this_thread::sleep_for(milliseconds(1500));
                ::kill(workers_[victim]->pid(), SIGCONT);
                return true;
        }
    }

    NatsProcess nats_;
    std::string lease_s_ = "1";
    std::map<int, std::unique_ptr<process::Child>> workers_;
    std::unique_ptr<process::Child> daemon_;
};

TEST_F(Faults, WorkersGiveTheBytesOfOneMachine) {
    for (int i = 0; i < kWorkers; ++i) start_worker(i);
    for (int i = 0; i < kWorkers; ++i) {
        EXPECT_TRUE(await(*workers_[i], [&] { return tells(log_of(i), "at work for"); }))
            << content(log_of(i));
    }
    slow_episodes();
    start_daemon("run");
    const auto everybody_has_rows = [this] {
        const std::string rows = rows_so_far("hit");
        return std::ranges::all_of(workers_, [&](const auto& worker) {
            return rows.find(":" + std::to_string(worker.second->pid()) + "\n") !=
                   std::string::npos;
        });
    };
    EXPECT_TRUE(await(*daemon_, everybody_has_rows)) << shown("hit", "--csv");
    quick_episodes();
    expect_end();
    EXPECT_EQ(canonical("hit"), calm_bytes());
}

TEST_F(Faults, TwentyFaultsLeaveNoTrace) {
    std::string text = quick_experiment();
    // K3D_FAULTS=200 makes a longer bench of it.
    const char* wanted_text = std::getenv("K3D_FAULTS");
    const int wanted = wanted_text == nullptr ? 20 : std::atoi(wanted_text);
    text.replace(text.find("max_generations = 4"), 19,
                 "max_generations = " + std::to_string(std::max(4, wanted * 8 / 20)));
    write("exp.toml", text);
    const Doubler doubler(nats_.url());
    for (int i = 0; i < kWorkers; ++i) start_worker(i);
    slow_episodes();
    start_daemon("run");
    RandomStream random(7, "faults", "kinds");
    const std::vector<int> kinds = shuffled_kinds(wanted, random);
    std::size_t faults = 0;
    while (faults < kinds.size()) {
        const auto ended = daemon_->wait(milliseconds(150 + random.below(300)));
        ASSERT_FALSE(ended) << "ended after " << faults << " faults, " << ended->text() << '\n'
                            << content("daemon.log");
        if (!std::filesystem::exists(path("hit/ledger.sqlite"))) continue;
        if (strike(kinds[faults], random)) ++faults;
    }
    quick_episodes();
    expect_end();
    EXPECT_GT(doubler.count(), 100);
    EXPECT_EQ(canonical("hit"), calm_bytes());
    EXPECT_THAT(content("daemon.log"), ::testing::Not(HasSubstr("two ways")));
}

TEST_F(Faults, TheDaemonWaitsForAServerThatIsAway) {
    nats_.kill();
    start_daemon("run");
    start_worker(0);
    const std::string waits = "waiting for nats-server: nats://127.0.0.1:";
    EXPECT_TRUE(await(*daemon_, [&] { return tells("daemon.log", waits); })) << content("daemon.log");
    EXPECT_TRUE(await(*workers_[0], [&] { return tells(log_of(0), waits); })) << content(log_of(0));
    EXPECT_FALSE(daemon_->wait(milliseconds(1500)));
    nats_.start_again();
    expect_end();
}

TEST_F(Faults, AServerThatLosesItsFilesLosesNoEpisode) {
    for (int i = 0; i < kWorkers; ++i) start_worker(i);
    start_daemon("run");
    for (long losses = 1; losses <= 5; ++losses) {
        // Workers hold episodes, and the numbers of their messages are given again.
        ASSERT_TRUE(await(*daemon_, [&] {
            const std::string rows = rows_so_far("hit");
            return std::count(rows.begin(), rows.end(), '\n') > 15 * losses;
        })) << content("daemon.log");
        nats_.kill();
        nats_.start_without_files();
    }
    expect_end();
    EXPECT_EQ(canonical("hit"), calm_bytes());
    EXPECT_EQ(failed_tries("hit"), "");
    EXPECT_THAT(content("daemon.log"), HasSubstr("nats-server is back"));
}

TEST_F(Faults, AnswersToALostStreamReachNoMessageOfTheNewOne) {
    start_worker(0);
    start_daemon("run");
    const auto rows = [this] {
        const std::string text = rows_so_far("hit");
        return std::count(text.begin(), text.end(), '\n');
    };
    ASSERT_TRUE(await(*daemon_, [&] { return rows() > 8; })) << content("daemon.log");
    ::kill(workers_[0]->pid(), SIGSTOP);
    daemon_->kill();
    nats_.kill();
    nats_.start_without_files();
    start_daemon("resume");
    // The new stream has other jobs under the numbers of those that the worker holds.
    ASSERT_TRUE(await(*daemon_, [this] { return tells("daemon.log", " at the workers"); }));
    EXPECT_FALSE(daemon_->wait(milliseconds(1000)));
    ::kill(workers_[0]->pid(), SIGCONT);
    expect_end();
    EXPECT_EQ(canonical("hit"), calm_bytes());
}

TEST_F(Faults, TheDaemonTellsWhatAServerThatIsBackLacks) {
    start_worker(0);
    start_daemon("run");
    ASSERT_TRUE(await(*daemon_, [this] { return plays(); })) << content("daemon.log");
    nats_.kill();
    nats_.start_without_streams();
    const std::string lacks = "stream K3D_JOBS: No responders available for request";
    EXPECT_TRUE(await(*daemon_, [&] { return tells("daemon.log", lacks); }))
        << content("daemon.log");
    EXPECT_TRUE(await(*workers_[0], [&] { return tells("worker-0.log", lacks); }))
        << content("worker-0.log");
    nats_.kill();
    nats_.start_again();
    expect_end();
    EXPECT_EQ(failed_tries("hit"), "");
}

TEST_F(Faults, AWorkerThatIsToldToStopGivesItsWorkBack) {
    start_worker(0);
    start_daemon("run");
    ASSERT_TRUE(await(*daemon_, [this] { return plays(); })) << content("daemon.log");
    workers_[0]->terminate();
    const auto exit = workers_[0]->wait(std::chrono::seconds(20));
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 0) << content(log_of(0));
    start_worker(1);
    expect_end();
}

TEST_F(Faults, AWorkerWithoutAProgramEndsAndLeavesNoTrace) {
    std::filesystem::create_directories(path("bin"));
    std::filesystem::create_symlink(K3D_BIN_DIR "/quick_episode", path("bin/quick_taker"));
    std::string text = quick_experiment();
    text.insert(text.find("keepers = "),
                "taker_command = \"quick_taker --role taker --port {port} --unum {unum}\"\n");
    write("exp.toml", text);
    // Nobody would wait so long for a lease to run out: its episodes must be given back.
    lease_s_ = "3000";
    start_worker(0);
    start_daemon("run");
    const auto exit = workers_[0]->wait(kRunPatience);
    ASSERT_TRUE(exit) << content("worker-0.log");
    EXPECT_EQ(exit->code, 1);
    const std::string said =
        "\nk3d-optimizer: cannot start quick_taker: No such file or directory\n";
    EXPECT_THAT(content("worker-0.log"), ::testing::EndsWith(said));
    const std::string others = std::getenv("PATH");
    ::setenv("PATH", (path("bin") + ":" + others).c_str(), 1);
    start_worker(1);
    expect_end();
    EXPECT_EQ(failed_tries("hit"), "");
    EXPECT_EQ(canonical("hit"), calm_bytes());
    ::setenv("PATH", others.c_str(), 1);
}

}  // namespace
}  // namespace k3d::testing

// SPDX-License-Identifier: BSD-3-Clause
// What stays in nats-server's queues, and for whom: no outcome is lost between queue and ledger.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <nats/nats.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "integration/nats_process.h"
#include "integration/run_rig.h"

namespace k3d::testing {
namespace {

using ::testing::HasSubstr;

/// One that publishes and listens as anybody may.
class Stranger {
  public:
    explicit Stranger(const std::string& url) {
        natsOptions_Create(&options_);
        natsOptions_SetURL(options_, url.c_str());
        natsOptions_SetTimeout(options_, kPatienceMs);
        EXPECT_EQ(natsConnection_Connect(&connection_, options_), NATS_OK);
        jsOptions answers;
        jsOptions_Init(&answers);
        answers.Wait = kPatienceMs;
        EXPECT_EQ(natsConnection_JetStream(&stream_, connection_, &answers), NATS_OK);
    }
    ~Stranger() {
        for (natsSubscription* one : subscriptions_) natsSubscription_Destroy(one);
        jsCtx_Destroy(stream_);
        natsConnection_Destroy(connection_);
        natsOptions_Destroy(options_);
    }
    Stranger(const Stranger&) = delete;
    Stranger& operator=(const Stranger&) = delete;

    natsSubscription* listen(const std::string& subject) {
        subscriptions_.emplace_back();
        EXPECT_EQ(natsConnection_SubscribeSync(&subscriptions_.back(), connection_, subject.c_str()),
                  NATS_OK);
        EXPECT_EQ(natsConnection_FlushTimeout(connection_, kPatienceMs), NATS_OK);
        return subscriptions_.back();
    }
    /// Subject and text of the next message; none after so long a silence.
    static std::optional<std::pair<std::string, std::string>> hear(
        natsSubscription* from, std::chrono::milliseconds patience) {
        natsMsg* message = nullptr;
        if (natsSubscription_NextMsg(&message, from, patience.count()) != NATS_OK) return {};
        std::pair<std::string, std::string> heard{
            natsMsg_GetSubject(message),
            {natsMsg_GetData(message), static_cast<std::size_t>(natsMsg_GetDataLength(message))}};
        natsMsg_Destroy(message);
        return heard;
    }
    void publish(const std::string& subject, const std::string& text) {
        EXPECT_EQ(js_Publish(nullptr, stream_, subject.c_str(), text.data(),
                             static_cast<int>(text.size()), nullptr, nullptr),
                  NATS_OK);
    }
    void purge(const std::string& stream) {
        EXPECT_EQ(js_PurgeStream(stream_, stream.c_str(), nullptr, nullptr), NATS_OK);
    }

  private:
    static constexpr std::int64_t kPatienceMs = 30'000;

    natsOptions* options_ = nullptr;
    natsConnection* connection_ = nullptr;
    jsCtx* stream_ = nullptr;
    std::vector<natsSubscription*> subscriptions_;
};

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

TEST_F(Queue, TwoAttemptsOfAnEpisodeAtOneWorkerAreTwo) {
    Stranger stranger(nats_.url());
    natsSubscription* jobs = stranger.listen("k3d.job.>");
    natsSubscription* outcomes = stranger.listen("k3d.outcome.>");
    process::Child daemon = start_daemon({"run", path("exp.toml"), "--run", path("hit")});
    const auto job = Stranger::hear(jobs, kRunPatience);
    ASSERT_TRUE(job) << content("daemon.log");
    daemon.kill();
    stranger.purge("K3D_JOBS");
    // What a worker gets whose lease of the first attempt ran out, and it failed at another one.
    std::string second = job->second;
    const std::string attempt = "\"attempt\":";
    ASSERT_THAT(second, HasSubstr(attempt + "1"));
    second.replace(second.find(attempt + "1"), attempt.size() + 1, attempt + "2");
    stranger.publish(job->first, job->second);
    stranger.publish(job->first, second);
    process::Child worker = start_worker({"--jobs", "2"});
    std::set<std::string> missing{attempt + "1", attempt + "2"};
    while (!missing.empty()) {
        const auto outcome = Stranger::hear(outcomes, kRunPatience);
        ASSERT_TRUE(outcome) << "no outcome with " << *missing.begin() << '\n'
                             << content("worker.log");
        std::erase_if(missing, [&](const std::string& one) {
            return outcome->second.find(one) != std::string::npos;
        });
    }
    worker.kill();
    EXPECT_TRUE(start_worker({"--idle-s", "0.1"}).wait(kRunPatience)) << "nothing is left to do";
}

}  // namespace
}  // namespace k3d::testing

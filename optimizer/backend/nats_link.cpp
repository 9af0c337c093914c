// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/backend/nats_link.h"

#include <fmt/format.h>
#include <nats/nats.h>
#include <xxhash.h>

#include <functional>
#include <map>

#include "common/log/log.h"
#include "common/version/version.h"

namespace k3d::optimizer::backend {

namespace {

constexpr const char* kJobs = "K3D_JOBS";
constexpr const char* kOutcomes = "K3D_OUTCOMES";
constexpr std::int64_t kSecond = 1'000'000'000;  // ns
constexpr std::int64_t kDuplicateWindow = 2 * 3600 * kSecond;
constexpr std::int64_t kMaxAge = 14 * 24 * 3600 * kSecond;  // of what nobody fetches any more
constexpr std::int64_t kWaitMs = 3000;
constexpr std::int64_t kOutcomeLeaseS = 10;
constexpr std::int64_t kUnsetLeaseS = 30;
constexpr const char* kAway = "nats-server is away";

std::string version_hash() {
    const std::string_view version = code_version();
    return fmt::format("{:016x}", XXH3_64bits(version.data(), version.size()));
}

std::string workers_name() {
    return "workers-" + version_hash();
}

void check(natsStatus status, const std::string& what) {
    if (status != NATS_OK) throw NatsError(what + ": " + natsStatus_GetText(status));
}

}  // namespace

struct NatsSource::Impl {
    NatsLink::Impl* link;
    natsSubscription* subscription = nullptr;
    explicit Impl(NatsLink::Impl* of) : link(of) {}
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() { natsSubscription_Destroy(subscription); }
};

struct NatsLink::Impl {
    std::string url;
    natsOptions* options = nullptr;
    natsConnection* connection = nullptr;
    natsStatistics* statistics = nullptr;
    jsCtx* stream = nullptr;
    std::vector<std::function<void()>> consumers;  ///< that this link has asked for: makes each
    std::map<std::string, std::int64_t> created;   ///< when, of each stream, by the server's clock
    int streams_lost = 0;
    int looked_at = -1;    ///< reconnections until the last look at the streams; -1: look again
    std::string told;      ///< what is in the way, as the log has it
    bool refused = false;  ///< by the stream, what was published last

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        jsCtx_Destroy(stream);
        if (connection != nullptr) natsConnection_Close(connection);
        natsConnection_Destroy(connection);
        natsStatistics_Destroy(statistics);
        natsOptions_Destroy(options);
    }

    void connect(const std::string& name) {
        check(natsOptions_Create(&options), url);
        check(natsStatistics_Create(&statistics), url);
        check(natsOptions_SetURL(options, url.c_str()), url);
        natsOptions_SetName(options, name.c_str());
        natsOptions_SetMaxReconnect(options, -1);
        natsOptions_SetReconnectWait(options, 250);
        natsOptions_SetFailRequestsOnDisconnect(options, true);
        check(natsConnection_Connect(&connection, options), url);
        jsOptions defaults;
        jsOptions_Init(&defaults);
        defaults.Wait = kWaitMs;
        check(natsConnection_JetStream(&stream, connection, &defaults), url);
    }

    bool connected() const {
        return natsConnection_Status(connection) == NATS_CONN_STATUS_CONNECTED;
    }

    /// How many times the connection was lost and found again. Counted before it is connected().
    int reconnections() const {
        std::uint64_t count = 0;
        natsConnection_GetStats(connection, statistics);
        natsStatistics_GetCounts(statistics, nullptr, nullptr, nullptr, nullptr, &count);
        return static_cast<int>(count);
    }

    /// The streams are those of that time, as far as anybody can know.
    bool still_has_streams_of(int time) const {
        return connected() && looked_at == reconnections() && streams_lost == time;
    }

    void tell(const std::string& trouble) {
        if (trouble == told) return;
        told = trouble;
        if (trouble.empty()) {
            spdlog::info("nats-server is back");
        } else {
            spdlog::warn("{}; waiting for it", trouble);
        }
    }

    bool ready() {
        if (!connected()) {
            tell(kAway);
            return false;
        }
        if (const int now = reconnections(); looked_at != now) {
            try {
                make_streams();
                for (const auto& make : consumers) make();
            } catch (const NatsError& error) {
                tell(error.what());
                return false;
            }
            looked_at = now;
        }
        if (!refused) tell("");
        return true;
    }

    void make_streams() {
        add_stream(kJobs, "k3d.job.>");
        add_stream(kOutcomes, "k3d.outcome.>");
    }

    /// That is there already stays as it is.
    void add_stream(const char* name, const char* subject) {
        jsStreamConfig config;
        jsStreamConfig_Init(&config);
        config.Name = name;
        config.Subjects = &subject;
        config.SubjectsLen = 1;
        config.Retention = js_WorkQueuePolicy;
        config.Storage = js_FileStorage;
        config.Duplicates = kDuplicateWindow;
        config.MaxAge = kMaxAge;
        jsErrCode code{};
        jsStreamInfo* info = nullptr;
        const natsStatus status = js_AddStream(&info, stream, &config, nullptr, &code);
        if (status != NATS_OK) {
            throw NatsError(fmt::format("{}: stream {}: {} ({}); is JetStream on? nats-server -js",
                                        url, name, natsStatus_GetText(status),
                                        static_cast<int>(code)));
        }
        const auto [known, first] = created.emplace(name, info->Created);
        if (!first && known->second != info->Created) ++streams_lost;
        known->second = info->Created;
        jsStreamInfo_Destroy(info);
    }

    void add_consumer(const char* of, const std::string& name, const std::string& subject,
                      std::int64_t lease) {
        jsConsumerConfig config;
        jsConsumerConfig_Init(&config);
        config.Durable = name.c_str();
        config.FilterSubject = subject.c_str();
        config.AckPolicy = js_AckExplicit;
        config.AckWait = lease;
        config.MaxAckPending = 100'000;
        check(js_AddConsumer(nullptr, stream, of, &config, nullptr, nullptr), url + ": " + name);
    }

    /// Now, and whenever the server may have lost it.
    void keep(const std::function<void()>& make) {
        make();
        consumers.push_back(make);
    }

    NatsSource source(const char* of, const std::string& name, const std::string& subject) {
        auto impl = std::make_unique<NatsSource::Impl>(this);
        jsSubOptions options_of;
        jsSubOptions_Init(&options_of);
        options_of.Stream = of;
        options_of.Consumer = name.c_str();
        check(js_PullSubscribe(&impl->subscription, stream, subject.c_str(), name.c_str(), nullptr,
                               &options_of, nullptr),
              url + ": " + name);
        return NatsSource(std::move(impl));
    }

    bool has_consumer(const char* of, const std::string& name) {
        jsConsumerInfo* info = nullptr;
        const natsStatus status =
            js_GetConsumerInfo(&info, stream, of, name.c_str(), nullptr, nullptr);
        jsConsumerInfo_Destroy(info);
        if (status != NATS_OK && status != NATS_NOT_FOUND) check(status, url + ": " + name);
        return status == NATS_OK;
    }
};

struct NatsMessage::Impl {
    const NatsLink::Impl* link;
    int time;  ///< streams lost before it came
    natsMsg* message;
    std::uint64_t deliveries = 1;
    Impl(const NatsLink::Impl* of, natsMsg* taken)
        : link(of), time(of->streams_lost), message(taken) {
        jsMsgMetaData* meta = nullptr;
        if (natsMsg_GetMetaData(&meta, message) != NATS_OK) return;
        deliveries = meta->NumDelivered;
        jsMsgMetaData_Destroy(meta);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() { natsMsg_Destroy(message); }

    bool can_be_answered() const { return link->still_has_streams_of(time); }
};

NatsMessage::NatsMessage(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
NatsMessage::NatsMessage(NatsMessage&&) noexcept = default;
NatsMessage& NatsMessage::operator=(NatsMessage&&) noexcept = default;
NatsMessage::~NatsMessage() = default;

std::string_view NatsMessage::text() const {
    return {natsMsg_GetData(impl_->message),
            static_cast<std::size_t>(natsMsg_GetDataLength(impl_->message))};
}
std::uint64_t NatsMessage::deliveries() const {
    return impl_->deliveries;
}
bool NatsMessage::done() {
    return impl_->can_be_answered() && natsMsg_AckSync(impl_->message, nullptr, nullptr) == NATS_OK;
}
void NatsMessage::again() {
    if (impl_->can_be_answered()) natsMsg_Nak(impl_->message, nullptr);
}
void NatsMessage::alive() {
    if (impl_->can_be_answered()) natsMsg_InProgress(impl_->message, nullptr);
}

NatsSource::NatsSource(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
NatsSource::NatsSource(NatsSource&&) noexcept = default;
NatsSource& NatsSource::operator=(NatsSource&&) noexcept = default;
NatsSource::~NatsSource() = default;

std::vector<NatsMessage> NatsSource::pull(int count, std::chrono::milliseconds patience) {
    natsMsgList list{};
    std::vector<NatsMessage> messages;
    const natsStatus status =
        natsSubscription_Fetch(&list, impl_->subscription, count, patience.count(), nullptr);
    if (status != NATS_OK) {
        // An empty queue is nothing to look at; one that is not there is.
        if (status != NATS_TIMEOUT) impl_->link->looked_at = -1;
        return messages;
    }
    for (int i = 0; i < list.Count; ++i) {
        messages.emplace_back(std::make_unique<NatsMessage::Impl>(impl_->link, list.Msgs[i]));
        list.Msgs[i] = nullptr;  // ours now
    }
    natsMsgList_Destroy(&list);
    return messages;
}

NatsLink::NatsLink(const std::string& url, const std::string& name)
    : impl_(std::make_unique<Impl>()) {
    impl_->url = url;
    impl_->connect(name);
    impl_->make_streams();
    impl_->looked_at = 0;
}

NatsLink::~NatsLink() = default;

bool NatsLink::ready() {
    return impl_->ready();
}

int NatsLink::losses() const {
    return impl_->reconnections() + impl_->streams_lost;
}

bool NatsLink::publish(const std::string& subject, const std::string& id,
                       const std::string& text) {
    if (!ready()) return false;
    jsPubOptions options;
    jsPubOptions_Init(&options);
    options.MsgId = id.c_str();
    const natsStatus status = js_Publish(nullptr, impl_->stream, subject.c_str(), text.data(),
                                         static_cast<int>(text.size()), &options, nullptr);
    impl_->refused = status != NATS_OK;
    if (impl_->refused) {
        impl_->looked_at = -1;
        impl_->tell(impl_->connected() ? fmt::format("nats-server does not take {}: {}", subject,
                                                     natsStatus_GetText(status))
                                       : kAway);
    }
    return !impl_->refused;
}

NatsSource NatsLink::jobs() {
    const std::string subject = job_subject("*");
    // Whoever comes first makes it; a daemon sets the lease it wants.
    impl_->keep([impl = impl_.get(), subject] {
        if (impl->has_consumer(kJobs, workers_name())) return;
        impl->add_consumer(kJobs, workers_name(), subject, kUnsetLeaseS * kSecond);
    });
    return impl_->source(kJobs, workers_name(), subject);
}

NatsSource NatsLink::outcomes(const std::string& run) {
    const std::string name = "daemon-" + run;
    impl_->keep([impl = impl_.get(), name, run] {
        impl->add_consumer(kOutcomes, name, outcome_subject(run), kOutcomeLeaseS * kSecond);
    });
    return impl_->source(kOutcomes, name, outcome_subject(run));
}

void NatsLink::set_lease(std::chrono::milliseconds lease) {
    impl_->keep([impl = impl_.get(), lease] {
        impl->add_consumer(kJobs, workers_name(), job_subject("*"), lease.count() * 1'000'000);
    });
}

void NatsLink::forget(const std::string& run) {
    for (const auto& [stream, subject] :
         {std::pair{kJobs, job_subject(run)}, std::pair{kOutcomes, outcome_subject(run)}}) {
        jsOptions options;
        jsOptions_Init(&options);
        options.Stream.Purge.Subject = subject.c_str();
        js_PurgeStream(impl_->stream, stream, &options, nullptr);
    }
    js_DeleteConsumer(impl_->stream, kOutcomes, ("daemon-" + run).c_str(), nullptr, nullptr);
}

std::string NatsLink::job_subject(const std::string& run) {
    return "k3d.job." + version_hash() + "." + run;
}

std::string NatsLink::outcome_subject(const std::string& run) {
    return "k3d.outcome." + version_hash() + "." + run;
}

}  // namespace k3d::optimizer::backend

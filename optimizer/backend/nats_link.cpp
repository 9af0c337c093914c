// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/backend/nats_link.h"

#include <fmt/format.h>
#include <nats/nats.h>
#include <xxhash.h>

#include <atomic>

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

struct NatsMessage::Impl {
    natsMsg* message = nullptr;
    std::uint64_t deliveries = 1;
    explicit Impl(natsMsg* taken) : message(taken) {
        jsMsgMetaData* meta = nullptr;
        if (natsMsg_GetMetaData(&meta, message) != NATS_OK) return;
        deliveries = meta->NumDelivered;
        jsMsgMetaData_Destroy(meta);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() { natsMsg_Destroy(message); }
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
    return natsMsg_AckSync(impl_->message, nullptr, nullptr) == NATS_OK;
}
void NatsMessage::again() {
    natsMsg_Nak(impl_->message, nullptr);
}
void NatsMessage::alive() {
    natsMsg_InProgress(impl_->message, nullptr);
}

struct NatsSource::Impl {
    natsSubscription* subscription = nullptr;
    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() { natsSubscription_Destroy(subscription); }
};

NatsSource::NatsSource(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
NatsSource::NatsSource(NatsSource&&) noexcept = default;
NatsSource& NatsSource::operator=(NatsSource&&) noexcept = default;
NatsSource::~NatsSource() = default;

std::vector<NatsMessage> NatsSource::pull(int count, std::chrono::milliseconds patience) {
    natsMsgList list{};
    std::vector<NatsMessage> messages;
    if (natsSubscription_Fetch(&list, impl_->subscription, count, patience.count(), nullptr) !=
        NATS_OK) {
        return messages;
    }
    for (int i = 0; i < list.Count; ++i) {
        messages.emplace_back(std::make_unique<NatsMessage::Impl>(list.Msgs[i]));
        list.Msgs[i] = nullptr;  // ours now
    }
    natsMsgList_Destroy(&list);
    return messages;
}

struct NatsLink::Impl {
    std::string url;
    natsOptions* options = nullptr;
    natsConnection* connection = nullptr;
    jsCtx* stream = nullptr;
    std::atomic<int> reconnections{0};

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        jsCtx_Destroy(stream);
        if (connection != nullptr) natsConnection_Close(connection);
        natsConnection_Destroy(connection);
        natsOptions_Destroy(options);
    }

    static void found_again(natsConnection*, void* self) {
        ++static_cast<Impl*>(self)->reconnections;
    }

    void connect(const std::string& name) {
        check(natsOptions_Create(&options), url);
        check(natsOptions_SetURL(options, url.c_str()), url);
        natsOptions_SetName(options, name.c_str());
        natsOptions_SetMaxReconnect(options, -1);
        natsOptions_SetReconnectWait(options, 250);
        natsOptions_SetFailRequestsOnDisconnect(options, true);
        natsOptions_SetReconnectedCB(options, found_again, this);
        check(natsConnection_Connect(&connection, options), url);
        jsOptions defaults;
        jsOptions_Init(&defaults);
        defaults.Wait = kWaitMs;
        check(natsConnection_JetStream(&stream, connection, &defaults), url);
    }

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
        const natsStatus status = js_AddStream(nullptr, stream, &config, nullptr, &code);
        if (status != NATS_OK) {
            throw NatsError(fmt::format("{}: stream {}: {} ({}); is JetStream on? nats-server -js",
                                        url, name, natsStatus_GetText(status),
                                        static_cast<int>(code)));
        }
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

    NatsSource source(const char* of, const std::string& name, const std::string& subject) {
        auto impl = std::make_unique<NatsSource::Impl>();
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
        const natsStatus status = js_GetConsumerInfo(&info, stream, of, name.c_str(), nullptr, nullptr);
        jsConsumerInfo_Destroy(info);
        if (status != NATS_OK && status != NATS_NOT_FOUND) check(status, url + ": " + name);
        return status == NATS_OK;
    }
};

NatsLink::NatsLink(const std::string& url, const std::string& name)
    : impl_(std::make_unique<Impl>()) {
    impl_->url = url;
    impl_->connect(name);
    impl_->add_stream(kJobs, "k3d.job.>");
    impl_->add_stream(kOutcomes, "k3d.outcome.>");
}

NatsLink::~NatsLink() = default;

bool NatsLink::connected() const {
    return natsConnection_Status(impl_->connection) == NATS_CONN_STATUS_CONNECTED;
}

int NatsLink::reconnections() const {
    return impl_->reconnections;
}

bool NatsLink::publish(const std::string& subject, const std::string& id,
                       const std::string& text) {
    if (!connected()) return false;
    jsPubOptions options;
    jsPubOptions_Init(&options);
    options.MsgId = id.c_str();
    return js_Publish(nullptr, impl_->stream, subject.c_str(), text.data(),
                      static_cast<int>(text.size()), &options, nullptr) == NATS_OK;
}

NatsSource NatsLink::jobs() {
    const std::string subject = job_subject("*");
    // Whoever comes first makes it; a daemon sets the lease it wants.
    if (!impl_->has_consumer(kJobs, workers_name())) set_lease(std::chrono::seconds(30));
    return impl_->source(kJobs, workers_name(), subject);
}

NatsSource NatsLink::outcomes(const std::string& run) {
    impl_->add_consumer(kOutcomes, "daemon-" + run, outcome_subject(run), kOutcomeLeaseS * kSecond);
    return impl_->source(kOutcomes, "daemon-" + run, outcome_subject(run));
}

void NatsLink::set_lease(std::chrono::milliseconds lease) {
    impl_->add_consumer(kJobs, workers_name(), job_subject("*"), lease.count() * 1'000'000);
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

// SPDX-License-Identifier: BSD-3-Clause
// A connection to nats-server and the two JetStream streams that daemons and workers share. The only
// header beside its source that knows libnats, and it shows nothing of it.
//
//     K3D_JOBS      k3d.job.VERSION.RUN       a work queue: a job stays until a worker is done with it
//     K3D_OUTCOMES  k3d.outcome.VERSION.RUN   a work queue: an outcome stays until its daemon has it
//
// VERSION is a hash of the code version: a worker never sees the jobs of another version. Both
// streams are files of the server, and outlive it.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace k3d::optimizer::backend {

/// One delivered message; not answered, it comes again after its lease.
class NatsMessage {
  public:
    struct Impl;
    explicit NatsMessage(std::unique_ptr<Impl> impl);
    NatsMessage(NatsMessage&&) noexcept;
    NatsMessage& operator=(NatsMessage&&) noexcept;
    ~NatsMessage();

    std::string_view text() const;
    std::uint64_t deliveries() const;  ///< this one included
    bool done();   ///< for good; true once the server has confirmed it
    void again();  ///< deliver it to somebody else, at once
    void alive();  ///< still at it: the lease begins anew

  private:
    std::unique_ptr<Impl> impl_;
};

/// A queue to pull messages from.
class NatsSource {
  public:
    struct Impl;
    explicit NatsSource(std::unique_ptr<Impl> impl);
    NatsSource(NatsSource&&) noexcept;
    NatsSource& operator=(NatsSource&&) noexcept;
    ~NatsSource();

    /// Up to `count` messages; waits for the first one at most `patience`. None while the server is
    /// away.
    std::vector<NatsMessage> pull(int count, std::chrono::milliseconds patience);

  private:
    std::unique_ptr<Impl> impl_;
};

class NatsLink {
  public:
    struct Impl;
    /// `url` as libnats takes it, "nats://user:secret@host:4222". `name` is told to the server.
    /// Throws NatsError, e.g. "nats://127.0.0.1:4222: No server available for connection".
    NatsLink(const std::string& url, const std::string& name);
    ~NatsLink();
    NatsLink(const NatsLink&) = delete;
    NatsLink& operator=(const NatsLink&) = delete;

    bool connected() const;
    /// How many times the connection was lost and found again.
    int reconnections() const;
    /// True once the server has stored it, or had it already: messages of the same id within the
    /// last hours are one. False while the server is away; try again.
    bool publish(const std::string& subject, const std::string& id, const std::string& text);

    /// The jobs of this code version, shared by all workers.
    NatsSource jobs();
    /// The outcomes of one run.
    NatsSource outcomes(const std::string& run);
    /// A job that no worker has said anything about for so long is given to another one.
    void set_lease(std::chrono::milliseconds lease);
    /// A run is over: forgets what there is left of it.
    void forget(const std::string& run);

    static std::string job_subject(const std::string& run);
    static std::string outcome_subject(const std::string& run);

  private:
    std::unique_ptr<Impl> impl_;
};

class NatsError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace k3d::optimizer::backend

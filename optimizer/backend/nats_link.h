// SPDX-License-Identifier: BSD-3-Clause
// A connection to nats-server and the two JetStream streams that daemons and workers share. The only
// header beside its source that knows libnats, and it shows nothing of it.
//
//     K3D_JOBS      k3d.job.VERSION.RUN       a work queue: a job stays until a worker is done with it
//     K3D_OUTCOMES  k3d.outcome.VERSION.RUN   a work queue: an outcome stays until its daemon has it
//
// VERSION is a hash of the code version: a worker never sees the jobs of another version. Both
// streams are files of the server, and outlive it; if they are lost, whoever is connected makes them
// again.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace k3d::optimizer::backend {

/// One delivered message; not answered, it comes again after its lease. If the server has lost the
/// stream that it came from, no answer goes out: in the new stream it would be about another one.
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

    /// Up to `count` messages; waits for the first one at most `patience`. None, perhaps at once,
    /// while the link is not ready().
    std::vector<NatsMessage> pull(int count, std::chrono::milliseconds patience);

  private:
    std::unique_ptr<Impl> impl_;
};

/// Sources and messages of a link must not outlive it.
class NatsLink {
  public:
    struct Impl;
    /// `url` as libnats takes it, "nats://user:secret@host:4222". `name` is told to the server.
    /// Throws NatsError, e.g. "nats://127.0.0.1:4222: No server available for connection".
    NatsLink(const std::string& url, const std::string& name);
    ~NatsLink();
    NatsLink(const NatsLink&) = delete;
    NatsLink& operator=(const NatsLink&) = delete;

    /// The server is there, and so are streams and consumers. A server that comes back may have
    /// lost its files, so they are made again if need be; that may take seconds. What is in the way
    /// is told in the log, and that it is over.
    bool ready();
    /// Grows whenever the queues may have lost what was in them.
    int losses() const;
    /// True once the server has stored it, or had it already: messages of the same id within the
    /// last hours are one. False, and told in the log, if it has not; try again.
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

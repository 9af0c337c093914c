// SPDX-License-Identifier: BSD-3-Clause
#include "common/process/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>

#include "common/clock/deadline.h"
#include "common/process/start.h"

namespace k3d::process {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::string_view kReady = "ready";
constexpr std::size_t kLogTail = 2000;  // bytes of the log quoted in an error

std::string tail_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    if (!in) return {};
    const auto size = static_cast<std::size_t>(in.tellg());
    in.seekg(static_cast<std::streamoff>(size > kLogTail ? size - kLogTail : 0));
    std::string text{std::istreambuf_iterator<char>(in), {}};
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

std::map<std::string, std::string> pairs_of(std::string_view line) {
    std::map<std::string, std::string> pairs;
    std::istringstream words{std::string(line)};
    for (std::string word; words >> word;) {
        const auto equals = word.find('=');
        if (equals != std::string::npos) pairs[word.substr(0, equals)] = word.substr(equals + 1);
    }
    return pairs;
}

bool is_ready_line(std::string_view line) {
    return line.starts_with(kReady) && (line.size() == kReady.size() || line[kReady.size()] == ' ');
}

}  // namespace

std::string Exit::text() const {
    return signalled ? "killed by signal " + std::to_string(code - 128)
                     : "exit code " + std::to_string(code);
}

std::optional<int> port_in(const std::map<std::string, std::string>& ready,
                           const std::string& name) {
    const auto found = ready.find(name);
    if (found == ready.end()) return std::nullopt;
    const std::string& text = found->second;
    int port = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), port);
    const bool good = fault == std::errc() && end == text.data() + text.size();
    return good && port >= 1 && port <= 65535 ? std::optional(port) : std::nullopt;
}

struct Child::Impl {
    explicit Impl(const Spawn& spawn)
        : program(spawn.arguments.empty() ? "" : spawn.arguments[0]),
          log_file(spawn.log_file),
          started(start(spawn)) {}

    ~Impl() { kill(); }

    /// Moves what the child printed on, so that it never blocks on a full pipe.
    void drain() {
        std::array<char, 4096> bytes;
        while (started.out) {
            const ssize_t count = ::read(started.out.get(), bytes.data(), bytes.size());
            if (count > 0) {
                take_output({bytes.data(), static_cast<std::size_t>(count)});
            } else if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
                started.out.reset();
            } else if (errno == EAGAIN) {
                return;
            }
        }
    }

    /// Output up to the ready line is kept for wait_ready(); all of it goes to the log.
    void take_output(std::string_view bytes) {
        const int sink = started.log ? started.log.get() : STDERR_FILENO;
        for (std::string_view rest = bytes; !rest.empty();) {
            const ssize_t written = ::write(sink, rest.data(), rest.size());
            if (written < 0 && errno != EINTR) break;  // a full disk must not end the episode
            if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
        }
        if (ready) return;
        line.append(bytes);
        for (std::size_t end; !ready && (end = line.find('\n')) != std::string::npos;) {
            if (is_ready_line(std::string_view(line).substr(0, end))) ready = line.substr(0, end);
            line.erase(0, end + 1);
        }
    }

    std::optional<Exit> poll() {
        drain();
        if (!exit) reap(WNOHANG);
        return exit;
    }

    /// Sleeps until the child prints or ends, at most until the deadline.
    void sleep(Clock::time_point deadline) {
        std::array<pollfd, 2> entries;
        nfds_t count = 0;
        if (started.out) entries[count++] = {started.out.get(), POLLIN, 0};
        if (started.pidfd) entries[count++] = {started.pidfd.get(), POLLIN, 0};
        // Kernels without pidfd: look every few milliseconds.
        const int limit = started.pidfd ? 3'600'000 : 5;
        ::poll(entries.data(), count, std::min(limit, remaining_ms(deadline)));
    }

    std::optional<Exit> wait(milliseconds patience) {
        const auto deadline = Clock::now() + patience;
        while (!poll() && Clock::now() < deadline) sleep(deadline);
        return exit;
    }

    std::map<std::string, std::string> wait_ready(milliseconds patience) {
        if (!ready && !started.captured) {
            throw ProcessError(program + ": its standard output is not captured");
        }
        const auto deadline = Clock::now() + patience;
        for (;;) {
            const bool ended = poll().has_value();
            if (ready) return pairs_of(*ready);
            if (ended) fail("ended before it was ready, " + exit->text());
            if (Clock::now() >= deadline) {
                fail("not ready after " + std::to_string(patience.count()) + " ms");
            }
            sleep(deadline);
        }
    }

    [[noreturn]] void fail(const std::string& what) const {
        std::string text = program + ": " + what;
        const std::string tail = log_file.empty() ? "" : tail_of(log_file);
        if (!tail.empty()) text += "; its log " + log_file + " ends with\n" + tail;
        throw ProcessError(text);
    }

    void signal_group(int signal) const {
        if (!exit) ::kill(-started.pid, signal);
    }

    void kill() {
        if (exit) return;
        signal_group(SIGKILL);
        reap(0);
        drain();
    }

    /// Notes the exit. The rest of the group is killed first, while the zombie still holds its
    /// number: later the number could be somebody else's.
    void reap(int flags) {
        siginfo_t info{};
        int result;
        do {
            result =
                ::waitid(P_PID, static_cast<id_t>(started.pid), &info, WEXITED | WNOWAIT | flags);
        } while (result != 0 && errno == EINTR);
        if (result != 0) {
            exit = Exit{127, false};  // reaped by somebody else: there is no code to know
            return;
        }
        if (info.si_pid == 0) return;  // still running
        ::kill(-started.pid, SIGKILL);
        int status = 0;
        while (::waitpid(started.pid, &status, 0) < 0 && errno == EINTR) {
        }
        exit = WIFSIGNALED(status) ? Exit{128 + WTERMSIG(status), true}
                                   : Exit{WEXITSTATUS(status), false};
        drain();
    }

    std::string program;
    std::string log_file;
    Started started;
    std::string line;  // of captured output, not yet ended
    std::optional<std::string> ready;
    std::optional<Exit> exit;
};

Child::Child(const Spawn& spawn) : impl_(std::make_unique<Impl>(spawn)) {}
Child::~Child() = default;
Child::Child(Child&&) noexcept = default;
Child& Child::operator=(Child&&) noexcept = default;

pid_t Child::pid() const {
    return impl_->started.pid;
}

std::map<std::string, std::string> Child::wait_ready(milliseconds patience) {
    return impl_->wait_ready(patience);
}
std::optional<std::map<std::string, std::string>> Child::poll_ready() {
    impl_->drain();
    if (!impl_->ready) return std::nullopt;
    return pairs_of(*impl_->ready);
}
std::optional<Exit> Child::poll() {
    return impl_->poll();
}
std::optional<Exit> Child::wait(milliseconds patience) {
    return impl_->wait(patience);
}
void Child::terminate() {
    impl_->signal_group(SIGTERM);
}
void Child::kill() {
    impl_->kill();
}

}  // namespace k3d::process

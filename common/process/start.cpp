// SPDX-License-Identifier: BSD-3-Clause
#include "common/process/start.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace k3d::process {

namespace {

[[noreturn]] void fail(const Spawn& spawn, const std::string& what, int number) {
    throw StartError("cannot start " + spawn.arguments[0] + ": " + what + std::strerror(number));
}

struct Pipe {
    Fd read, write;
};

Pipe make_pipe(const Spawn& spawn) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) fail(spawn, "pipe: ", errno);
    return {Fd(ends[0]), Fd(ends[1])};
}

/// Sockets and files of the owner must not live on in the child.
void close_others_at_exec() {
    if (::syscall(SYS_close_range, 3U, ~0U, CLOSE_RANGE_CLOEXEC) == 0) return;
    const long limit = std::min(::sysconf(_SC_OPEN_MAX), 65536L);
    for (int fd = 3; fd < limit; ++fd) {
        const int flags = ::fcntl(fd, F_GETFD);
        if (flags >= 0) ::fcntl(fd, F_SETFD, flags | FD_CLOEXEC);
    }
}

/// In the child. Only calls that are safe after fork(); returns only if exec fails.
void become(char* const* arguments, pid_t owner, int input, int output, int errors, bool batch) {
    ::setpgid(0, 0);
    const sched_param no_priority{};
    if (batch) ::sched_setscheduler(0, SCHED_BATCH, &no_priority);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != owner) ::_exit(127);  // the owner died before the line above
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::signal(SIGPIPE, SIG_DFL);
    ::dup2(input, STDIN_FILENO);
    if (output >= 0) ::dup2(output, STDOUT_FILENO);
    if (errors >= 0) ::dup2(errors, STDERR_FILENO);
    close_others_at_exec();
    ::execvp(arguments[0], arguments);
}

}  // namespace

Started start(const Spawn& spawn) {
    if (spawn.arguments.empty()) throw StartError("cannot start a program without a name");
    std::vector<char*> arguments;
    for (const std::string& argument : spawn.arguments) {
        arguments.push_back(const_cast<char*>(argument.c_str()));
    }
    arguments.push_back(nullptr);

    Started started;
    started.captured = spawn.capture_stdout;
    if (!spawn.log_file.empty()) {
        started.log = Fd(::open(spawn.log_file.c_str(),
                                O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644));
        if (!started.log) fail(spawn, "log file " + spawn.log_file + ": ", errno);
    }
    const Fd input(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    if (!input) fail(spawn, "/dev/null: ", errno);
    Pipe output;
    if (spawn.capture_stdout) output = make_pipe(spawn);
    Pipe report = make_pipe(spawn);  // the child writes errno here if exec fails

    const pid_t owner = ::getpid();
    started.pid = ::fork();
    if (started.pid < 0) fail(spawn, "fork: ", errno);
    if (started.pid == 0) {
        const int log = started.log.get();
        become(arguments.data(), owner, input.get(),
               spawn.capture_stdout ? output.write.get() : log, log, spawn.batch);
        const int number = errno;
        [[maybe_unused]] const auto written = ::write(report.write.get(), &number, sizeof number);
        ::_exit(127);
    }
    ::setpgid(started.pid, started.pid);  // here too: whoever comes first

    report.write.reset();
    int number = 0;
    ssize_t count;
    do {
        count = ::read(report.read.get(), &number, sizeof number);  // ends when exec closes it
    } while (count < 0 && errno == EINTR);
    if (count == static_cast<ssize_t>(sizeof number)) {
        ::waitpid(started.pid, nullptr, 0);
        fail(spawn, "", number);
    }
    started.pidfd = Fd(static_cast<int>(::syscall(SYS_pidfd_open, started.pid, 0)));
    if (spawn.capture_stdout) {
        started.out = std::move(output.read);
        ::fcntl(started.out.get(), F_SETFL, O_NONBLOCK);
    }
    return started;
}

}  // namespace k3d::process

// SPDX-License-Identifier: BSD-3-Clause
// Children: ready lines, ends, groups, and that none outlives its owner.
#include "common/process/child.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace k3d::process {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

Spawn shell(const std::string& script) {
    return {{"/bin/sh", "-c", script}, "", true};
}

std::string temp_file(const std::string& name) {
    return testing::TempDir() + "k3d_child_" + std::to_string(::getpid()) + "_" + name;
}

std::string content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// True once no process of this number is left, zombies not counted; false after the deadline.
bool gone(pid_t pid) {
    const auto deadline = std::chrono::steady_clock::now() + 10s;
    while (std::chrono::steady_clock::now() < deadline) {
        const std::string stat = content("/proc/" + std::to_string(pid) + "/stat");
        if (stat.empty() || stat.find(") Z ") != std::string::npos) return true;
        ::usleep(2000);
    }
    return false;
}

template <class Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const ProcessError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Child, ReadyLineGivesItsPairs) {
    Child child(shell("echo starting; echo ready agent=40123 monitor=40124; read line"));
    const auto pairs = child.wait_ready(10s);
    EXPECT_EQ(pairs,
              (std::map<std::string, std::string>{{"agent", "40123"}, {"monitor", "40124"}}));
}

TEST(Child, APortOfTheReadyLineIsAWholeNumberOfItsRange) {
    const std::map<std::string, std::string> ready{
        {"good", "3100"},  {"most", "65535"}, {"more", "65536"}, {"none", "0"},
        {"tail", "3100x"}, {"empty", ""},     {"less", "-1"}};
    EXPECT_EQ(port_in(ready, "good"), 3100);
    EXPECT_EQ(port_in(ready, "most"), 65535);
    for (const char* bad : {"more", "none", "tail", "empty", "less", "untold"}) {
        EXPECT_FALSE(port_in(ready, bad)) << bad;
    }
}

TEST(Child, StandardInputIsEmpty) {
    Child child(shell("read line; exit 4"));
    const auto exit = child.wait(10s);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->text(), "exit code 4");
}

TEST(Child, EndBeforeReadyIsAnErrorWithTheLog) {
    Spawn spawn = shell("echo port 3100 is busy >&2; exit 2");
    spawn.log_file = temp_file("busy.log");
    Child child(spawn);
    const std::string error = error_of([&] { child.wait_ready(10s); });
    EXPECT_THAT(error, HasSubstr("/bin/sh: ended before it was ready, exit code 2"));
    EXPECT_THAT(error, HasSubstr("port 3100 is busy"));
    std::remove(spawn.log_file.c_str());
}

TEST(Child, ReadinessCanBePolled) {
    Child child(shell("read line; echo starting; echo ready agent=40123; exit 1"));
    ASSERT_TRUE(child.wait(10s));
    const auto pairs = child.poll_ready();
    ASSERT_TRUE(pairs);
    EXPECT_EQ(pairs->at("agent"), "40123");
    Child mute(shell("echo already; exit 0"));
    ASSERT_TRUE(mute.wait(10s));
    EXPECT_FALSE(mute.poll_ready());
}

TEST(Child, ReadyHasADeadline) {
    Child child(shell("exec sleep 60"));
    EXPECT_EQ(error_of([&] { child.wait_ready(30ms); }), "/bin/sh: not ready after 30 ms");
    EXPECT_FALSE(child.poll());
}

TEST(Child, OutputAfterReadyNeverBlocksItAndReachesTheLog) {
    Spawn spawn = shell(
        "echo ready; i=0; while [ $i -lt 3000 ]; do "
        "echo 0123456789012345678901234567890123456789; i=$((i+1)); done; echo last");
    spawn.log_file = temp_file("chatty.log");
    Child child(spawn);
    child.wait_ready(10s);
    const auto exit = child.wait(30s);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 0);
    EXPECT_THAT(content(spawn.log_file), testing::EndsWith("last\n"));
    std::remove(spawn.log_file.c_str());
}

TEST(Child, MissingProgramIsNamed) {
    EXPECT_EQ(error_of([] {
                  Child child({{"/no/such/program"}, "", false});
              }),
              "cannot start /no/such/program: No such file or directory");
}

TEST(Child, LogFileThatCannotBeWrittenIsNamed) {
    EXPECT_EQ(error_of([] {
                  Child child({{"/bin/true"}, "/no/such/folder/x.log", false});
              }),
              "cannot start /bin/true: log file /no/such/folder/x.log: No such file or directory");
}

TEST(Child, WaitGivesUpWhileItRuns) {
    Child child(shell("exec sleep 60"));
    EXPECT_FALSE(child.wait(20ms));
    child.terminate();
    const auto exit = child.wait(10s);
    ASSERT_TRUE(exit);
    EXPECT_TRUE(exit->signalled);
    EXPECT_EQ(exit->code, 128 + SIGTERM);
    EXPECT_EQ(exit->text(), "killed by signal 15");
}

TEST(Child, LeadsAGroupOfItsOwnThatDiesWithIt) {
    Child child(shell("sleep 60 & echo ready grandchild=$!; wait"));
    const pid_t grandchild = std::stoi(child.wait_ready(10s).at("grandchild"));
    EXPECT_EQ(::getpgid(child.pid()), child.pid());
    EXPECT_EQ(::getpgid(grandchild), child.pid());
    child.kill();
    EXPECT_TRUE(gone(grandchild));
}

TEST(Child, GroupIsClearedWhenTheLeaderEndsAlone) {
    Child child(shell("sleep 60 & echo ready grandchild=$!"));
    const pid_t grandchild = std::stoi(child.wait_ready(10s).at("grandchild"));
    ASSERT_TRUE(child.wait(10s));
    EXPECT_TRUE(gone(grandchild));
}

TEST(Child, DestructorKills) {
    pid_t pid = 0;
    {
        Child child(shell("exec sleep 60"));
        pid = child.pid();
    }
    EXPECT_TRUE(gone(pid));
}

TEST(Child, DiesWithAnOwnerThatIsKilled) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t owner = ::fork();
    ASSERT_GE(owner, 0);
    if (owner == 0) {
        Child child(shell("exec sleep 60"));
        const pid_t pid = child.pid();
        if (::write(ends[1], &pid, sizeof pid) != sizeof pid) ::_exit(1);
        for (;;) ::pause();
    }
    pid_t child = 0;
    ASSERT_EQ(::read(ends[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
    ::kill(owner, SIGKILL);
    ::waitpid(owner, nullptr, 0);
    EXPECT_TRUE(gone(child));
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST(Child, InheritsNoFilesOfTheOwner) {
    const int file = ::open("/dev/null", O_RDONLY);  // no O_CLOEXEC, like the sockets of Asio
    ASSERT_GE(file, 0);
    Child child(shell("[ -e /proc/self/fd/" + std::to_string(file) + " ] && exit 1; exit 0"));
    const auto exit = child.wait(10s);
    ::close(file);
    ASSERT_TRUE(exit);
    EXPECT_EQ(exit->code, 0);
}

}  // namespace
}  // namespace k3d::process

// SPDX-License-Identifier: Apache-2.0
// What a process that runs somebody else's scripts can do no more. Each attempt is made in a child.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "robot/core/log/LogReader.h"
#include "robot/core/log/LogWriter.h"
#include "robot/core/types/Command.h"
#include "tests/session/OwnFolder.h"
#include "tools/session/Confinement.h"
#include "tools/session/SessionCommands.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kNotConfined = 255;
constexpr int kNoLandlock = 254;
constexpr std::uint64_t kMemory = std::uint64_t{1} << 30;

// 0 where the attempt succeeded, else why not.
int errorOf(bool succeeded) { return succeeded ? 0 : errno; }
int openError(const std::string& path, int flags) {
  return errorOf(open(path.c_str(), flags, 0600) >= 0);
}

// The first descriptor that is not given out any more; -1 when that is not for want of them.
int firstRefused(const std::string& file) {
  int last = -1;
  for (int next = 0; next >= 0; next = open(file.c_str(), O_RDONLY)) last = std::max(last, next);
  return errno == EMFILE ? last + 1 : -1;
}

class Confined : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = "/tmp/kelpie-confined-XXXXXX";
    folder_ = ::mkdtemp(name.data());
    fs::create_directories(folder_ + "/team/deeper");
    for (const char* file : {"/secret", "/team/main.py", "/team/deeper/other.py"})
      std::ofstream(folder_ + file) << "text";
    limits_.readable = {folder_ + "/team"};
    limits_.memory = kMemory;
    limits_.seconds = 2;
  }
  void TearDown() override { fs::remove_all(folder_); }

  // What the attempt answers in a child that is confined to the team's folder; or its signal, as
  // 128 + that.
  int in(const std::function<int()>& attempt, bool needsLandlock = false) const {
    const pid_t child = fork();
    if (child == 0) {
      const auto confined = confine(limits_);
      if (!confined) _exit(kNotConfined);
      if (needsLandlock && !*confined) _exit(kNoLandlock);
      _exit(attempt());
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  void expectFileRefused(const std::function<int()>& attempt) const {
    const int said = in(attempt, true);
    if (said == kNoLandlock) GTEST_SKIP() << "this kernel has no Landlock";
    EXPECT_EQ(said, EACCES);
  }
  int firstRefusedIn() const {
    return in([&] { return firstRefused(folder_ + "/team/main.py"); });
  }

  std::string folder_;
  Confinement limits_;
};

TEST_F(Confined, ReadsItsOwnFolder) {
  EXPECT_EQ(in([&] { return openError(folder_ + "/team/main.py", O_RDONLY); }), 0);
  EXPECT_EQ(in([&] { return openError(folder_ + "/team/deeper/other.py", O_RDONLY); }), 0);
  EXPECT_EQ(in([&] { return fs::is_empty(folder_ + "/team") ? 1 : 0; }), 0);
}

TEST_F(Confined, HasThreadsAndSomeMemory) {
  EXPECT_EQ(in([] {
              int done = 1;
              std::thread([&done] { done = 0; }).join();
              return done;
            }),
            0);
  EXPECT_EQ(in([] { return errorOf(std::malloc(kMemory / 8) != nullptr); }), 0);
}

TEST_F(Confined, HasPipesToItself) {
  EXPECT_EQ(in([] {
              int ends[2];
              return errorOf(pipe2(ends, O_CLOEXEC) == 0);
            }),
            0);
}

TEST_F(Confined, ReadsNoOtherFile) {
  expectFileRefused([] { return openError("/etc/passwd", O_RDONLY); });
}

TEST_F(Confined, ReadsNoOtherFileByAWayUp) {
  expectFileRefused([&] { return openError(folder_ + "/team/../secret", O_RDONLY); });
}

TEST_F(Confined, ReadsNoOtherFileByALinkInItsFolder) {
  fs::create_symlink(folder_ + "/secret", folder_ + "/team/link.py");
  expectFileRefused([&] { return openError(folder_ + "/team/link.py", O_RDONLY); });
}

TEST_F(Confined, WritesNotEvenItsOwnFiles) {
  EXPECT_EQ(in([&] { return openError(folder_ + "/team/main.py", O_WRONLY); }), EPERM);
  EXPECT_EQ(in([&] { return openError(folder_ + "/team/main.py", O_RDWR | O_TRUNC); }), EPERM);
}

TEST_F(Confined, MakesAndRemovesNoFile) {
  EXPECT_EQ(in([&] { return openError(folder_ + "/team/new.py", O_RDONLY | O_CREAT); }), EPERM);
  EXPECT_EQ(in([&] { return errorOf(unlink((folder_ + "/secret").c_str()) == 0); }), EPERM);
  EXPECT_EQ(in([&] { return errorOf(mkdir((folder_ + "/team/new").c_str(), 0700) == 0); }), EPERM);
  EXPECT_TRUE(fs::exists(folder_ + "/secret"));
}

TEST_F(Confined, StartsNoProcess) {
  EXPECT_EQ(in([] {
              const pid_t child = fork();
              if (child == 0) _exit(0);
              return errorOf(child > 0);
            }),
            EPERM);
}

TEST_F(Confined, BecomesNoOtherProgram) {
  EXPECT_EQ(in([] { return errorOf(execl("/bin/true", "true", nullptr) == 0); }), EPERM);
}

TEST_F(Confined, OpensNoSocket) {
  for (const int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK})
    EXPECT_EQ(in([=] { return errorOf(socket(family, SOCK_STREAM, 0) >= 0); }), EPERM) << family;
}

TEST_F(Confined, SignalsNobody) {
  EXPECT_EQ(in([] { return errorOf(kill(getppid(), 0) == 0); }), EPERM);
}

TEST_F(Confined, HasNobodySignalledByADescriptor) {
  EXPECT_EQ(in([] {
              int ends[2];
              if (pipe2(ends, O_CLOEXEC) != 0) return -1;
              return errorOf(fcntl(ends[0], F_SETOWN, getppid()) == 0);
            }),
            EPERM);
  EXPECT_EQ(in([] {
              int ends[2];
              if (pipe2(ends, O_CLOEXEC) != 0) return -1;
              return errorOf(fcntl(ends[0], F_SETFL, O_ASYNC) == 0);
            }),
            EPERM);
}

// Far below what a shell gives, so that no other limit passes for it.
TEST_F(Confined, OpensNotMoreDescriptorsThanItsLimit) {
  rlimit shell{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &shell), 0);
  ASSERT_GT(shell.rlim_cur, limits_.descriptors);
  EXPECT_EQ(firstRefusedIn(), 64);
  limits_.descriptors = 20;
  EXPECT_EQ(firstRefusedIn(), 20);
}

TEST_F(Confined, KeepsALowerLimitOfItsUser) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit lower{20, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &lower), 0);
  const int said = firstRefusedIn();
  EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_EQ(said, 20);
}

TEST_F(Confined, WritesNoFileBeyondItsLimit) {
  limits_.fileSize = 1000;
  const int log = open((folder_ + "/log").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const std::string text(600, 'x');
  EXPECT_EQ(in([&] {
              if (write(log, text.data(), text.size()) != 600) return -1;
              if (write(log, text.data(), text.size()) != 400) return -1;
              return errorOf(write(log, "x", 1) == 1);
            }),
            EFBIG);
  EXPECT_EQ(fs::file_size(folder_ + "/log"), 1000U);
  close(log);
}

TEST_F(Confined, IsToldThatItsLogGrewTooLongAndWhatFittedIsRead) {
  limits_.fileSize = 10000;
  const std::string path = folder_ + "/log";
  auto log = LogWriter::open(path, LogOptions{});
  ASSERT_TRUE(log);
  EXPECT_EQ(in([&] {
              for (int i = 0; i < 1000 && log->status(); ++i)
                log->write("/walk", TimeUs{i}, WalkRequest{});
              const Status closed = log->close();
              if (closed) return 0;
              return closed.error().find(std::strerror(EFBIG)) == std::string::npos ? -1 : EFBIG;
            }),
            EFBIG);
  auto reader = LogReader::open(path);
  ASSERT_TRUE(reader);
  LogMessage message;
  int messages = 0;
  while (reader->next(message)) ++messages;
  EXPECT_GT(messages, 20);
}

TEST_F(Confined, LengthensNoFileThatItWasGiven) {
  const int log = open((folder_ + "/log").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  EXPECT_EQ(in([log] { return errorOf(write(log, "text", 4) == 4); }), 0);
  EXPECT_EQ(in([log] { return errorOf(ftruncate(log, 1LL << 40) == 0); }), EPERM);
  close(log);
}

TEST_F(Confined, WatchesNobody) {
  EXPECT_EQ(in([] { return errorOf(ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0); }), EPERM);
}

TEST_F(Confined, FillsNoMemory) {
  EXPECT_EQ(in([] {
              for (std::uint64_t i = 0; i < 2 * kMemory; i += kMemory / 16)
                if (std::malloc(kMemory / 16) == nullptr) return errno;
              return 0;
            }),
            ENOMEM);
}

TEST_F(Confined, ComputesNotForEver) {
  const int said = in([] {
    for (volatile int i = 0;; i = i + 1) {
    }
    return 0;
  });
  EXPECT_EQ(said, 128 + SIGKILL);
}

TEST_F(Confined, LiftsNoLimit) {
  EXPECT_EQ(in([] {
              const rlimit more{RLIM_INFINITY, RLIM_INFINITY};
              return errorOf(setrlimit(RLIMIT_AS, &more) == 0);
            }),
            EPERM);
}

TEST(Confinement, ATeamFromElsewhereIsConfinedUnlessItIsTrusted) {
  SessionOptions options;
  EXPECT_TRUE(isConfined(options, "/tmp/foxes"));
  EXPECT_TRUE(isConfined(options, ownFolder() + "-other/main.py"));
  EXPECT_FALSE(isConfined(options, ""));
  EXPECT_FALSE(isConfined(options, ownFolder() + "/pycode"));
  options.trust = true;
  EXPECT_FALSE(isConfined(options, "/tmp/foxes"));
}

TEST(Confinement, ATeamInsideTheTreeByAWayOutOfItIsFromElsewhere) {
  EXPECT_TRUE(isConfined({}, ownFolder() + "/teams/../../foxes"));
}

}  // namespace
}  // namespace kelpie::cli

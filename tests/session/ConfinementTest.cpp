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

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

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

class Confined : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = "/tmp/kelpie-confined-XXXXXX";
    folder_ = ::mkdtemp(name.data());
    fs::create_directories(folder_ + "/team/deeper");
    for (const char* file : {"/secret", "/team/main.py", "/team/deeper/other.py"})
      std::ofstream(folder_ + file) << "text";
  }
  void TearDown() override { fs::remove_all(folder_); }

  // What the attempt answers in a child that is confined to the team's folder; or its signal, as
  // 128 + that.
  int in(const std::function<int()>& attempt, bool needsLandlock = false) const {
    const pid_t child = fork();
    if (child == 0) {
      Confinement limits;
      limits.readable = {folder_ + "/team"};
      limits.memory = kMemory;
      limits.seconds = 2;
      const auto confined = confine(limits);
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

  std::string folder_;
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

TEST_F(Confined, OpensNotEverMoreDescriptors) {
  EXPECT_EQ(in([] {
              int ends[2];
              while (pipe2(ends, O_CLOEXEC) == 0) {
              }
              return errno;
            }),
            EMFILE);
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

// Kelpie's own behaviours and teams, beside the programs.
std::string ownFolder() {
  return fs::canonical(fs::canonical("/proc/self/exe").parent_path() / "../share/kelpie").string();
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

// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Process.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace kelpie::cli {
namespace {

constexpr const char* kTunables = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4";

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interruptSeen = 0;
void rememberInterrupt(int) { interruptSeen = 1; }

// Runs in the child between fork and exec: only async-signal-safe calls. Who is woken by a message
// waits for the core and does not push its sender off: a fast match of eight robots is 4 % faster.
[[noreturn]] void becomeProgram(char* const* argv, int input, int output, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  signal(SIGINT, SIG_IGN);
  signal(SIGHUP, SIG_IGN);
  signal(SIGTERM, SIG_DFL);
  signal(SIGPIPE, SIG_DFL);
  if (getppid() != parent) _exit(127);
  const sched_param batch = {};
  (void)sched_setscheduler(0, SCHED_BATCH, &batch);
  if (input >= 0) dup2(input, STDIN_FILENO);
  if (output >= 0) {
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
  }
  execv(argv[0], argv);
  _exit(127);
}

// Of a program of somebody else's: whatever it starts belongs to it, it reads nothing, and it
// writes no results. As above.
void setApart() {
  setpgid(0, 0);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
}

// Both ends are closed but for what is taken out.
struct Pipe {
  int ends[2] = {-1, -1};  // to read from, and to write to

  Pipe() = default;
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    for (const int end : ends)
      if (end >= 0) close(end);
  }
  bool open() { return pipe2(ends, O_CLOEXEC) == 0; }
};

// What the kernel tells of a process after its name, which may hold spaces: the state's letter is
// word 0. Nothing when there is none.
constexpr std::size_t kUserTicks = 11;  // on processors, and in the kernel's name the word after it
std::vector<std::string> wordsOfStat(pid_t pid, bool ended) {
  if (ended) return {};
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  std::getline(file, line);
  std::istringstream rest(line.substr(std::min(line.rfind(')') + 1, line.size())));
  return {std::istream_iterator<std::string>(rest), {}};
}

}  // namespace

Expected<Process> Process::start(const std::vector<std::string>& argv, bool readOutput,
                                 bool hears) {
  return start(argv, Ways{readOutput, hears, false});
}

Expected<Process> Process::startGroup(const std::vector<std::string>& argv) {
  return start(argv, Ways{false, false, true});
}

Expected<Process> Process::start(const std::vector<std::string>& argv, const Ways& ways) {
  if (access(argv[0].c_str(), X_OK) != 0)
    return Error{argv[0] + ": no such program; build it with tools/build host"};
  Pipe output, input;
  if ((ways.readOutput && !output.open()) || (ways.hears && !input.open()))
    return Error{std::string("pipe: ") + std::strerror(errno)};
  std::vector<char*> words;
  words.reserve(argv.size() + 1);
  for (const auto& word : argv) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0 && ways.group) setApart();
  if (pid == 0) becomeProgram(words.data(), input.ends[0], output.ends[1], parent);
  if (pid < 0) return Error{std::string("fork: ") + std::strerror(errno)};
  if (ways.hears) fcntl(input.ends[1], F_SETFL, O_NONBLOCK);
  return Process(pid, std::exchange(output.ends[0], -1), std::exchange(input.ends[1], -1),
                 ways.group);
}

Process::Process(Process&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      output_(std::exchange(other.output_, -1)),
      input_(std::exchange(other.input_, -1)),
      group_(other.group_),
      ended_(other.ended_),
      code_(other.code_),
      pending_(std::move(other.pending_)) {}

Process::~Process() {
  if (pid_ > 0 && !ended_) {
    kill();
    wait();
  }
  if (output_ >= 0) close(output_);
  if (input_ >= 0) close(input_);
}

// A line is written whole or not at all, as long as it is shorter than a pipe's page.
bool Process::say(const std::string& line) {
  const std::string whole = line + "\n";
  return input_ >= 0 &&
         write(input_, whole.data(), whole.size()) == static_cast<ssize_t>(whole.size());
}

bool Process::readLine(std::string& line, int milliseconds) {
  for (;;) {
    const auto end = pending_.find('\n');
    if (end != std::string::npos) {
      line = pending_.substr(0, end);
      pending_.erase(0, end + 1);
      return true;
    }
    pollfd wanted{output_, POLLIN, 0};
    if (output_ < 0 || poll(&wanted, 1, milliseconds) <= 0) return false;
    char buffer[4096];
    const ssize_t got = read(output_, buffer, sizeof buffer);
    if (got <= 0) {
      close(std::exchange(output_, -1));
      return false;
    }
    pending_.append(buffer, static_cast<std::size_t>(got));
  }
}

// Those that the leader of a group has left behind go first, while its number is still its own.
bool Process::endsGroup(int options) const {
  siginfo_t info = {};
  if (!group_) return true;
  if (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOWAIT | options) != 0 ||
      info.si_pid != pid_)
    return false;
  ::kill(-pid_, SIGKILL);
  return true;
}

void Process::reap(int status) {
  ended_ = true;
  code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool Process::ended() {
  int status = 0;
  if (!ended_ && endsGroup(WNOHANG) && waitpid(pid_, &status, WNOHANG) == pid_) reap(status);
  return ended_;
}

int Process::wait() {
  int status = 0;
  while (!ended_ && !endsGroup(0) && errno == EINTR) {
  }
  while (!ended_ && waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  if (!ended_) reap(status);
  return code_;
}

double Process::computed() const {
  double ticks = 0.0;
  const auto words = wordsOfStat(pid_, ended_);
  for (std::size_t i = kUserTicks; i <= kUserTicks + 1 && i < words.size(); ++i)
    ticks += std::strtod(words[i].c_str(), nullptr);
  return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

bool Process::stopped() const {
  const auto words = wordsOfStat(pid_, ended_);
  return !words.empty() && words[0] == "T";
}

void Process::terminate() {
  if (!ended_) ::kill(pid_, SIGTERM);
}

void Process::kill() {
  // A child that was started just now may not lead its group yet.
  if (!ended_ && group_) ::kill(-pid_, SIGKILL);
  if (!ended_) ::kill(pid_, SIGKILL);
}

void catchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = rememberInterrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
}

bool interrupted() { return interruptSeen != 0; }

std::string programFolder() {
  char path[4096];
  const ssize_t size = readlink("/proc/self/exe", path, sizeof path - 1);
  if (size <= 0) return ".";
  const std::string whole(path, static_cast<std::size_t>(size));
  return whole.substr(0, whole.rfind('/'));
}

std::string becomeProgram(std::vector<std::string> words) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(argv[0], argv.data());
  return words[0] + ": " + std::strerror(errno);
}

void useTargetMaths(char** argv) {
  const char* now = std::getenv("GLIBC_TUNABLES");
  if (now != nullptr && std::strcmp(now, kTunables) == 0) return;
  setenv("GLIBC_TUNABLES", kTunables, 1);
  execv("/proc/self/exe", argv);  // on failure go on: only the last bit of Python's math differs
}

}  // namespace kelpie::cli

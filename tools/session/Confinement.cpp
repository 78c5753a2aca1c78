// SPDX-License-Identifier: Apache-2.0
#include "tools/session/Confinement.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <linux/sched.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <initializer_list>
#include <memory>

namespace kelpie::cli {
namespace {

Error failed(const char* what, int error) {
  return Error{std::string(what) + ": " + std::strerror(error)};
}

// A descriptor that is closed at the end.
struct Descriptor {
  int number = -1;
  explicit Descriptor(long opened) : number(static_cast<int>(opened)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

// All that Landlock's first version knows: writing, making, removing and running files too.
constexpr std::uint64_t kAllFileRights = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1U) - 1;
constexpr std::uint64_t kReadFile = LANDLOCK_ACCESS_FS_READ_FILE;
constexpr std::uint64_t kReadFolder = kReadFile | LANDLOCK_ACCESS_FS_READ_DIR;

bool mayRead(const std::string& path, int rules) {
  const Descriptor place(open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat known {};
  if (place.number < 0 || fstat(place.number, &known) != 0) return false;
  landlock_path_beneath_attr below{};
  below.allowed_access = S_ISDIR(known.st_mode) ? kReadFolder : kReadFile;
  below.parent_fd = place.number;
  return syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &below, 0) == 0;
}

Expected<bool> keepFromFiles(const std::vector<std::string>& readable) {
  landlock_ruleset_attr handled{};
  handled.handled_access_fs = kAllFileRights;
  const Descriptor rules(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
  if (rules.number < 0) return false;
  for (const std::string& path : readable)
    if (!mayRead(path, rules.number)) return failed(path.c_str(), errno);
  if (syscall(SYS_landlock_restrict_self, rules.number, 0) != 0) return failed("landlock", errno);
  return true;
}

// A lower limit of the user's own stays: more than a hard one cannot be had, and the match goes on.
Status limit(__rlimit_resource_t what, std::uint64_t most) {
  rlimit both{};
  if (getrlimit(what, &both) != 0) return failed("getrlimit", errno);
  both.rlim_max = both.rlim_cur = std::min<rlim_t>(most, both.rlim_cur);
  if (setrlimit(what, &both) != 0) return failed("setrlimit", errno);
  return Done{};
}

// A write past the longest file is to fail, so that the log's end is told: its signal would kill.
Status limitAll(const Confinement& limits) {
  if (std::signal(SIGXFSZ, SIG_IGN) == SIG_ERR) return failed("signal", errno);
  for (const auto& [what, most] :
       {std::pair{RLIMIT_AS, limits.memory}, std::pair{RLIMIT_FSIZE, limits.fileSize},
        std::pair{RLIMIT_NOFILE, limits.descriptors}, std::pair{RLIMIT_CPU, limits.seconds},
        std::pair{RLIMIT_CORE, std::uint64_t{0}}}) {
    const Status set = limit(what, most);
    if (!set) return set;
  }
  return Done{};
}

// What a frame loop, its log, sockets that are open, Python and a watching thread need.
constexpr const char* kAllowed[] = {"read",
                                    "write",
                                    "readv",
                                    "writev",
                                    "pread64",
                                    "lseek",
                                    "close",
                                    "fstat",
                                    "stat",
                                    "lstat",
                                    "newfstatat",
                                    "statx",
                                    "getdents64",
                                    "access",
                                    "faccessat",
                                    "faccessat2",
                                    "readlink",
                                    "readlinkat",
                                    "getcwd",
                                    "poll",
                                    "ppoll",
                                    "select",
                                    "pselect6",
                                    "epoll_wait",
                                    "epoll_pwait",
                                    "sendto",
                                    "recvfrom",
                                    "sendmsg",
                                    "recvmsg",
                                    "shutdown",
                                    "getsockopt",
                                    "getsockname",
                                    "getpeername",
                                    "pipe2",
                                    "futex",
                                    "mmap",
                                    "mprotect",
                                    "munmap",
                                    "mremap",
                                    "madvise",
                                    "brk",
                                    "rt_sigaction",
                                    "rt_sigprocmask",
                                    "rt_sigreturn",
                                    "sigaltstack",
                                    "restart_syscall",
                                    "clock_gettime",
                                    "clock_getres",
                                    "clock_nanosleep",
                                    "nanosleep",
                                    "gettimeofday",
                                    "time",
                                    "times",
                                    "getrusage",
                                    "getrandom",
                                    "getpid",
                                    "gettid",
                                    "getppid",
                                    "getuid",
                                    "geteuid",
                                    "getgid",
                                    "getegid",
                                    "uname",
                                    "sysinfo",
                                    "sched_yield",
                                    "sched_getaffinity",
                                    "set_robust_list",
                                    "rseq",
                                    "membarrier",
                                    "arch_prctl",
                                    "timer_create",
                                    "timer_settime",
                                    "timer_delete",
                                    "setitimer",
                                    "getitimer",
                                    "exit",
                                    "exit_group"};

using Filter = std::unique_ptr<void, decltype(&seccomp_release)>;

// The first error of all rules is kept.
struct Rules {
  Filter filter{seccomp_init(SCMP_ACT_ERRNO(EPERM)), &seccomp_release};
  int error = filter ? 0 : -ENOMEM;

  void keep(int result) {
    if (error == 0) error = result;
  }
  void allow(const char* name) {
    const int number = seccomp_syscall_resolve_name(name);
    if (number != __NR_SCMP_ERROR)
      keep(seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, number, 0, nullptr));
  }
  void allowWhere(int number, std::initializer_list<scmp_arg_cmp> conditions) {
    keep(seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, number,
                                static_cast<unsigned>(conditions.size()), conditions.begin()));
  }
};

scmp_arg_cmp equals(unsigned argument, scmp_datum_t value) {
  return {argument, SCMP_CMP_EQ, value, 0};
}
scmp_arg_cmp hasBits(unsigned argument, scmp_datum_t mask, scmp_datum_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

// Only with such arguments: files to read, threads but no processes, signals to nobody else, its
// own limits to be told of, descriptors whose owner gets no signal (O_ASYNC).
void allowInPart(Rules& rules) {
  constexpr scmp_datum_t kWrites = O_ACCMODE | O_CREAT | O_TRUNC;
  constexpr scmp_datum_t kThread = CLONE_VM | CLONE_THREAD;
  rules.allowWhere(SCMP_SYS(open), {hasBits(1, kWrites, O_RDONLY)});
  rules.allowWhere(SCMP_SYS(openat), {hasBits(2, kWrites, O_RDONLY)});
  rules.allowWhere(SCMP_SYS(clone), {hasBits(0, kThread, kThread)});
  rules.allowWhere(SCMP_SYS(tgkill), {equals(0, static_cast<scmp_datum_t>(getpid()))});
  rules.allowWhere(SCMP_SYS(prlimit64), {equals(0, 0), equals(2, 0)});
  for (const int command : {F_GETFD, F_SETFD, F_GETFL, F_DUPFD_CLOEXEC})
    rules.allowWhere(SCMP_SYS(fcntl), {equals(1, static_cast<scmp_datum_t>(command))});
  rules.allowWhere(SCMP_SYS(fcntl), {equals(1, F_SETFL), hasBits(2, O_ASYNC, 0)});
}

Status keepFromCalls() {
  Rules rules;
  if (rules.filter) {
    for (const char* name : kAllowed) rules.allow(name);
    allowInPart(rules);
    // Its flags are out of a filter's sight; without it the C library takes clone.
    rules.keep(seccomp_rule_add_array(rules.filter.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3),
                                      0, nullptr));
    if (rules.error == 0) rules.keep(seccomp_load(rules.filter.get()));
  }
  if (rules.error != 0) return failed("seccomp", -rules.error);
  return Done{};
}

}  // namespace

Expected<bool> confine(const Confinement& limits) {
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return failed("prctl", errno);
  const Expected<bool> files = keepFromFiles(limits.readable);
  if (!files) return files;
  // Only now: Landlock's rules need two descriptors, and without one would pass for not there.
  const Status limited = limitAll(limits);
  if (!limited) return Error{limited.error()};
  const Status calls = keepFromCalls();
  if (!calls) return Error{calls.error()};
  return files;
}

Expected<std::string> confineScripts(const std::vector<std::string>& scripts) {
  Confinement limits;
  limits.readable = scripts;
  if (access(KELPIE_PYTHON_STDLIB, R_OK) == 0) limits.readable.emplace_back(KELPIE_PYTHON_STDLIB);
  const Expected<bool> files = confine(limits);
  if (!files) return Error{"cannot be confined: " + files.error()};
  return *files ? std::string() : "files can be read by its scripts: this kernel has no Landlock";
}

}  // namespace kelpie::cli

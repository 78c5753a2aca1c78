// SPDX-License-Identifier: Apache-2.0
// A child process that never outlives its parent: killed when the object goes, and by the kernel
// when the parent is killed. What it prints can be read line by line.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::cli {

class Process {
 public:
  // A program of somebody else's, which may start others: kill() and the end of the object reach
  // them all. It hears nothing, and what it prints goes to standard error.
  static Expected<Process> startGroup(const std::vector<std::string>& argv);
  // argv[0] is the program's path. With `readOutput` all that it prints goes to readLine(), with
  // `hears` its standard input is what is given to say().
  static Expected<Process> start(const std::vector<std::string>& argv, bool readOutput,
                                 bool hears = false);
  Process(Process&& other) noexcept;
  Process& operator=(Process&&) = delete;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  // Next line of output; waits at most `milliseconds`. False: nothing yet, or ended().
  bool readLine(std::string& line, int milliseconds);
  // False: it cannot hear, or hears too slowly.
  bool say(const std::string& line);
  bool ended();             // has exited; its status is then known
  int wait();               // waits for the end; the exit code, or 128 + signal
  double computed() const;  // s that it has kept a processor busy; 0 when it is gone
  bool stopped() const;     // by a signal, until another lets it go on
  void terminate();         // asks it to stop
  void kill();              // stops it

 private:
  // How a child is started.
  struct Ways {
    bool readOutput = false, hears = false, group = false;
  };
  static Expected<Process> start(const std::vector<std::string>& argv, const Ways& ways);
  Process(pid_t pid, int output, int input, bool group)
      : pid_(pid), output_(output), input_(input), group_(group) {}
  bool endsGroup(int options) const;
  void reap(int status);

  pid_t pid_ = -1;
  int output_ = -1;
  int input_ = -1;
  bool group_ = false;  // the child leads a group of processes
  bool ended_ = false;
  int code_ = 0;
  std::string pending_;
};

// From now on an interrupt (Ctrl-C), a closed terminal or a request to end is only remembered, and
// a pipe that nobody reads is an error of the write; children that are started later do not hear
// of an interrupt.
void catchInterrupts();
bool interrupted();

// Folder of the running program, where its sister programs are.
std::string programFolder();

// Goes on as another program; words[0] is its path. Returns only when that cannot be: why.
std::string becomeProgram(std::vector<std::string> words);

// Starts the program again with a C library whose double functions (and so Python's math) give the
// same bits as the target's, unless that is already so: glibc's FMA variants differ in the last bit
// from its plain ones (spec cross.md section 7). Returns only when nothing had to be done.
void useTargetMaths(char** argv);

}  // namespace kelpie::cli

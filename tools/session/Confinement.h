// SPDX-License-Identifier: Apache-2.0
// Who runs somebody else's scripts gives up first what they do not need: files but those that it is
// told of, new sockets, programs, memory without end. Python's own guard refuses the same before
// (behaviour/interpreter); this holds where a script gets past it. What is open already stays open:
// the world's socket, and the log, which a script past the guard can lengthen up to `fileSize`.
// Linux alone: seccomp, and Landlock where the kernel has it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::cli {

struct Confinement {
  std::vector<std::string> readable;                 // files and folders that may still be read
  std::uint64_t memory = std::uint64_t{2} << 30;     // bytes of addresses
  std::uint64_t fileSize = std::uint64_t{16} << 30;  // bytes; ten minutes of images are 1.3 GB
  // Numbers below it are given out. An agent has 8 open, a match of percepts with all logs 16.
  std::uint64_t descriptors = 64;
  std::uint64_t seconds = 4 * 3600;  // of processor time; the longest match has an hour
};

// From here on, for good and for all threads that are still to come; call it before there are any.
// What is refused fails with EPERM or EACCES, memory with ENOMEM, one descriptor more with EMFILE,
// a file that grows too long with EFBIG (SIGXFSZ is ignored); out of time the process is killed. A
// lower limit that the user has set stays. The answer is false where the kernel has no Landlock:
// any file may be read then. An error says what cannot be set up.
Expected<bool> confine(const Confinement& limits);

// For who is about to run scripts, by folder or zip: what they and Python need can be read. A line
// for the user where the kernel cannot keep files from them; empty where it can.
Expected<std::string> confineScripts(const std::vector<std::string>& scripts);

}  // namespace kelpie::cli

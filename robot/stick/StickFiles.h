// SPDX-License-Identifier: Apache-2.0
// How a stick's files are read: one open at a time, from front to back. Paths are relative to the
// stick's root, with forward slashes ("OPEN-R/MW/CONF/OBJECT.CFG").
#pragma once

#include <cstddef>
#include <cstdint>

namespace kelpie::stick {

// What is asked for at once. A stick is slow to answer, so blocks are large; a robot that renews
// its lights between two of them should do so some times a second.
constexpr std::size_t kBlockBytes = 65536;

class StickFiles {
 public:
  StickFiles() = default;
  StickFiles(const StickFiles&) = delete;
  StickFiles& operator=(const StickFiles&) = delete;
  virtual ~StickFiles() = default;

  // Closes what was open. False: there is no such file.
  virtual bool open(const char* path) = 0;
  // The next `count` bytes of the open file: how many there were, fewer at its end only, -1 on an
  // error.
  virtual std::int32_t read(std::uint8_t* to, std::size_t count) = 0;
  virtual void close() = 0;
};

}  // namespace kelpie::stick

// SPDX-License-Identifier: Apache-2.0
// How a stick's files are read: one open at a time, from front to back. Paths are relative to the
// stick's root, with forward slashes ("OPEN-R/MW/CONF/OBJECT.CFG").
#pragma once

#include <cstddef>
#include <cstdint>

namespace kelpie::stick {

class StickFiles {
 public:
  StickFiles() = default;
  StickFiles(const StickFiles&) = delete;
  StickFiles& operator=(const StickFiles&) = delete;
  virtual ~StickFiles() = default;

  // Closes what was open. False: there is no such file.
  virtual bool open(const char* path) = 0;
  // At most `count` bytes of the open file: how many there were, 0 at its end, -1 on an error.
  virtual std::int32_t read(std::uint8_t* to, std::size_t count) = 0;
  virtual void close() = 0;
};

}  // namespace kelpie::stick

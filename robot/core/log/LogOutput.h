// SPDX-License-Identifier: Apache-2.0
// The file that a log is written to: whole records, one write each. The first error stays, and the
// file is then cut back to its last whole record.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie {

class LogOutput {
 public:
  LogOutput() = default;  // not open
  // Replaces a file that exists.
  static Expected<LogOutput> open(const std::string& path);
  LogOutput(LogOutput&& other) noexcept;
  LogOutput& operator=(LogOutput&& other) noexcept;
  ~LogOutput();

  bool isOpen() const { return file_ >= 0; }
  // Open, and nothing went wrong.
  bool good() const { return isOpen() && error_.empty(); }
  std::uint64_t bytes() const { return bytes_; }
  Status status() const;

  void write(const std::vector<std::uint8_t>& records);
  // Keeps the first: "path: byte 1234: what is wrong".
  void fail(const std::string& what);
  void close();

 private:
  std::string path_;
  int file_ = -1;
  std::uint64_t bytes_ = 0;
  std::string error_;
};

}  // namespace kelpie

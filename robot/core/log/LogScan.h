// SPDX-License-Identifier: Apache-2.0
// Finds where records of an MCAP file begin, for a log of which some bytes are damaged. A place is
// sound when heads of possible records follow one another from it: their kind is known, they are
// long enough for that kind, and each ends where the next begins. Fails (finds nothing) where fewer
// whole records follow than a chain needs and the file goes on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>

#include "robot/core/log/LogFormat.h"

namespace kelpie {

// Reads exactly `count` bytes; false beyond the end. The stream is good afterwards.
bool readAt(std::istream& file, std::uint64_t offset, std::uint8_t* to, std::size_t count);

// What to look for. A record inside a damaged chunk that is not compressed has no checksum of its
// own: with `outside` only those count that never stand in a chunk, with `chunks` only chunks and
// the indexes of their messages.
enum class ScanFor : std::uint8_t { chunks, outside, any };

// A record that ends the data is this long at most; longer ones are records of another kind whose
// kind is damaged.
constexpr std::size_t kLongestDataEnd = 256;

class LogScan {
 public:
  LogScan(std::istream& file, std::uint64_t size) : file_(file), size_(size) {}

  bool sound(std::uint64_t offset) const;
  // The first sound place at or behind `from` where a record begins.
  std::optional<std::uint64_t> next(std::uint64_t from, ScanFor scanFor) const;

 private:
  bool begins(std::uint64_t offset) const;

  std::istream& file_;
  std::uint64_t size_;
};

}  // namespace kelpie

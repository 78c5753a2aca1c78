// SPDX-License-Identifier: Apache-2.0
// Gathers messages, with the schemas and channels before them, into one chunk of an MCAP file, and
// keeps where each message lies in it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace kelpie {

class LogChunk {
 public:
  bool empty() const { return messages_.empty(); }
  // Nanoseconds between its first and its last message if one of this time joins them.
  std::uint64_t spanWith(std::uint64_t time) const;

  // Records that end with a message, which starts at byte `message` of them.
  void add(const std::vector<std::uint8_t>& records, std::size_t message, std::uint16_t channel,
           std::uint64_t time);
  // Keeps size and checksum of the records; from then on records() may be compressed.
  void seal();
  std::vector<std::uint8_t>& records() { return records_; }
  // Appends the chunk and its message indexes to `out`, which will stand at byte `offset` of the
  // file, and what the summary says of them to `index`.
  void write(const std::string& compression, std::uint64_t offset, std::vector<std::uint8_t>& out,
             std::vector<std::uint8_t>& index) const;
  void clear();

 private:
  using Entry = std::pair<std::uint64_t, std::uint64_t>;  // time, offset in the records

  std::vector<std::uint8_t> records_;
  std::map<std::uint16_t, std::vector<Entry>> messages_;  // by channel
  std::uint64_t first_ = 0;                               // times, ns
  std::uint64_t last_ = 0;
  std::uint64_t size_ = 0;
  std::uint32_t checksum_ = 0;
};

}  // namespace kelpie

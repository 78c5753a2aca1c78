// SPDX-License-Identifier: Apache-2.0
#include "robot/core/log/LogChunk.h"

#include <algorithm>

#include "robot/core/Checksum.h"
#include "robot/core/log/LogFormat.h"

namespace kelpie {

using mcap::Op;
using mcap::RecordWriter;

std::uint64_t LogChunk::spanWith(std::uint64_t time) const {
  return messages_.empty() ? 0 : std::max(last_, time) - std::min(first_, time);
}

void LogChunk::add(const std::vector<std::uint8_t>& records, std::size_t message,
                   std::uint16_t channel, std::uint64_t time) {
  first_ = messages_.empty() ? time : std::min(first_, time);
  last_ = messages_.empty() ? time : std::max(last_, time);
  messages_[channel].emplace_back(time, records_.size() + message);
  records_.insert(records_.end(), records.begin(), records.end());
}

void LogChunk::seal() {
  size_ = records_.size();
  checksum_ = crc32(records_.data(), records_.size());
}

void LogChunk::write(const std::string& compression, std::uint64_t offset,
                     std::vector<std::uint8_t>& out, std::vector<std::uint8_t>& index) const {
  const std::size_t start = out.size();
  RecordWriter record(out);
  record.begin(Op::chunk);
  for (const std::uint64_t value : {first_, last_, size_}) record.number(value);
  record.number(checksum_);
  record.string(compression);
  record.number(static_cast<std::uint64_t>(records_.size()));
  record.bytes(records_.data(), records_.size());
  record.end();
  const std::uint64_t length = out.size() - start;

  RecordWriter place(index);
  place.begin(Op::chunkIndex);
  for (const std::uint64_t value : {first_, last_, offset, length}) place.number(value);
  place.number(static_cast<std::uint32_t>(messages_.size() * 10));  // bytes of the map
  for (const auto& [channel, entries] : messages_) {
    place.number(channel);
    place.number(offset + out.size() - start);
    record.begin(Op::messageIndex);
    record.number(channel);
    record.number(static_cast<std::uint32_t>(entries.size() * 16));
    for (const auto& [time, at] : entries) {
      record.number(time);
      record.number(at);
    }
    record.end();
  }
  place.number(static_cast<std::uint64_t>(out.size() - start - length));
  place.string(compression);
  place.number(static_cast<std::uint64_t>(records_.size()));
  place.number(size_);
  place.end();
}

void LogChunk::clear() {
  records_.clear();
  messages_.clear();
}

}  // namespace kelpie

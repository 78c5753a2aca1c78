// SPDX-License-Identifier: Apache-2.0
#include "robot/core/log/LogSummary.h"

#include <algorithm>

#include "robot/core/Checksum.h"

namespace kelpie {
namespace {

using mcap::Op;
using mcap::RecordWriter;

std::vector<std::uint8_t> statisticsOf(const LogSummary& summary) {
  std::vector<std::uint8_t> out;
  RecordWriter record(out);
  record.begin(Op::statistics);
  record.number(summary.messageCount);
  record.number(summary.schemaCount);
  record.number(static_cast<std::uint32_t>(summary.messageCounts.size()));
  record.number(summary.attachmentCount);
  record.number(summary.metadataCount);
  record.number(summary.chunkCount);
  record.number(summary.firstTime);
  record.number(summary.lastTime);
  record.number(static_cast<std::uint32_t>(summary.messageCounts.size() * 10));  // bytes of the map
  std::uint16_t channel = 0;
  for (const std::uint32_t messages : summary.messageCounts) {
    record.number(++channel);
    record.number(std::uint64_t{messages});
  }
  record.end();
  return out;
}

// Appends records of one kind, and to `offsets` where they stand.
void addGroup(const std::vector<std::uint8_t>& records, std::uint64_t offset,
              std::vector<std::uint8_t>& out, std::vector<std::uint8_t>& offsets) {
  if (records.empty()) return;
  RecordWriter record(offsets);
  record.begin(Op::summaryOffset);
  record.number(records.front());  // its code
  record.number(offset + out.size());
  record.number(static_cast<std::uint64_t>(records.size()));
  record.end();
  out.insert(out.end(), records.begin(), records.end());
}

}  // namespace

void LogSummary::count(std::uint16_t channel, std::uint64_t time) {
  firstTime = messageCount == 0 ? time : std::min(firstTime, time);
  lastTime = std::max(lastTime, time);
  ++messageCounts[channel - 1U];
  ++messageCount;
}

std::vector<std::uint8_t> LogSummary::end(std::uint64_t offset) const {
  std::vector<std::uint8_t> out;
  RecordWriter record(out);
  record.begin(Op::dataEnd);
  record.number(std::uint32_t{0});  // no checksum of the whole file: chunks have their own
  record.end();
  const std::size_t start = out.size();
  std::vector<std::uint8_t> offsets;
  for (const auto& records :
       {schemas, channels, statisticsOf(*this), chunkIndexes, attachmentIndexes, metadataIndexes}) {
    addGroup(records, offset, out, offsets);
  }
  const std::size_t offsetsStart = out.size();
  record.bytes(offsets.data(), offsets.size());
  record.begin(Op::footer);
  record.number(static_cast<std::uint64_t>(offset + start));
  record.number(static_cast<std::uint64_t>(offset + offsetsStart));
  record.number(std::uint32_t{0});
  record.end();
  // The checksum covers the summary and the head of the footer, up to this number.
  const std::size_t covered = out.size() - sizeof(std::uint32_t);
  const std::uint32_t checksum = crc32(out.data() + start, covered - start);
  std::memcpy(out.data() + covered, &checksum, sizeof checksum);
  record.bytes(mcap::kMagic.data(), mcap::kMagic.size());
  return out;
}

}  // namespace kelpie

// SPDX-License-Identifier: Apache-2.0
// What a log says of itself at its end: schemas, channels, counts, and where chunks, attachments
// and metadata stand in the file.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/core/log/LogFormat.h"

namespace kelpie {

struct LogSummary {
  // Records by kind.
  std::vector<std::uint8_t> schemas;
  std::vector<std::uint8_t> channels;
  std::vector<std::uint8_t> chunkIndexes;
  std::vector<std::uint8_t> attachmentIndexes;
  std::vector<std::uint8_t> metadataIndexes;

  std::uint16_t schemaCount = 0;
  std::uint32_t chunkCount = 0;
  std::uint32_t attachmentCount = 0;
  std::uint32_t metadataCount = 0;
  std::vector<std::uint32_t> messageCounts;  // of channel 1, 2, ...
  std::uint64_t messageCount = 0;
  std::uint64_t firstTime = 0;  // ns
  std::uint64_t lastTime = 0;

  void count(std::uint16_t channel, std::uint64_t time);
  // The end of a file that is `offset` bytes long, from the end of its data to the magic.
  std::vector<std::uint8_t> end(std::uint64_t offset) const;
};

}  // namespace kelpie

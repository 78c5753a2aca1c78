// SPDX-License-Identifier: Apache-2.0
// Where the chunks of a whole log stand in its file, from the summary at its end.
#pragma once

#include <cstdint>
#include <istream>
#include <vector>

#include "robot/core/Time.h"
#include "robot/core/log/LogFormat.h"

namespace kelpie {

struct ChunkPlace {
  std::uint64_t offset = 0;
  TimeUs last;  // of its messages
};

struct LogIndex {
  std::vector<ChunkPlace> chunks;  // in the order of the file
  std::uint64_t end = 0;           // behind the last of them

  // Adds the chunk of a ChunkIndex record; false if it cannot be in the first `limit` bytes.
  bool add(mcap::ContentReader content, std::uint64_t limit);
  void sort();
  // Offset of the first chunk with a message of that time or later, or of the end of the log.
  std::uint64_t placeOf(TimeUs time) const;
};

// The records of the summary; none if the log has no end or the summary's checksum is wrong.
std::vector<std::uint8_t> readSummary(std::istream& file, std::uint64_t fileSize);

}  // namespace kelpie

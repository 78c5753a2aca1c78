// SPDX-License-Identifier: Apache-2.0
#include "robot/core/LogIndex.h"

#include <algorithm>

namespace kelpie {
namespace {

using mcap::ContentReader;

// `count` bytes of the file, or none.
std::vector<std::uint8_t> bytesAt(std::istream& file, std::uint64_t offset, std::uint64_t count) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(count));
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
  if (!file) bytes.clear();
  file.clear();
  return bytes;
}

}  // namespace

bool LogIndex::add(ContentReader content, std::uint64_t limit) {
  content.number<std::uint64_t>();  // first time
  const auto last = content.number<std::uint64_t>();
  const auto offset = content.number<std::uint64_t>();
  const auto length = content.number<std::uint64_t>();
  if (!content.good() || offset > limit || length > limit - offset) return false;
  chunks.push_back({offset, {static_cast<std::int64_t>(last / 1000)}});
  end = std::max(end, offset + length);
  return true;
}

void LogIndex::sort() {
  std::sort(chunks.begin(), chunks.end(),
            [](const ChunkPlace& a, const ChunkPlace& b) { return a.offset < b.offset; });
}

std::uint64_t LogIndex::placeOf(TimeUs time) const {
  const auto found = std::find_if(chunks.begin(), chunks.end(),
                                  [&](const ChunkPlace& chunk) { return time <= chunk.last; });
  return found == chunks.end() ? end : found->offset;
}

std::vector<std::uint8_t> readSummary(std::istream& file, std::uint64_t fileSize) {
  constexpr std::size_t kFooterRecord = mcap::kRecordHead + mcap::kFooter;
  constexpr std::size_t kTail = kFooterRecord + mcap::kMagic.size();
  if (fileSize < mcap::kMagic.size() + kTail) return {};
  const std::uint64_t footer = fileSize - kTail;
  const std::vector<std::uint8_t> tail = bytesAt(file, footer, kTail);
  if (tail.empty() ||
      !std::equal(mcap::kMagic.begin(), mcap::kMagic.end(), tail.begin() + kFooterRecord))
    return {};
  ContentReader content(tail.data(), kFooterRecord);
  const auto op = content.number<mcap::Op>();
  const auto length = content.number<std::uint64_t>();
  const auto start = content.number<std::uint64_t>();
  content.number<std::uint64_t>();  // summary offsets
  const auto checksum = content.number<std::uint32_t>();
  if (op != mcap::Op::footer || length != mcap::kFooter) return {};
  if (start < mcap::kMagic.size() || start >= footer) return {};
  std::vector<std::uint8_t> summary =
      bytesAt(file, start, footer - start + kFooterRecord - sizeof checksum);
  if (checksum != 0 && checksum != mcap::crc32(summary.data(), summary.size())) return {};
  if (!summary.empty()) summary.resize(static_cast<std::size_t>(footer - start));
  return summary;
}

}  // namespace kelpie

// SPDX-License-Identifier: Apache-2.0
#include "robot/core/log/LogIndex.h"

#include <algorithm>

#include "robot/core/Checksum.h"
#include "robot/core/log/LogScan.h"

namespace kelpie {
namespace {

using mcap::ContentReader;

constexpr std::size_t kFooterRecord = mcap::kRecordHead + mcap::kFooter;
constexpr std::size_t kTail = kFooterRecord + mcap::kMagic.size();

struct Footer {
  std::uint64_t summary = 0;  // where it starts
  std::uint32_t checksum = 0;
};

bool readFooter(std::istream& file, std::uint64_t offset, Footer& footer) {
  std::array<std::uint8_t, kTail> tail{};
  if (!readAt(file, offset, tail.data(), tail.size())) return false;
  if (!std::equal(mcap::kMagic.begin(), mcap::kMagic.end(), tail.begin() + kFooterRecord))
    return false;
  ContentReader content(tail.data(), kFooterRecord);
  const auto op = content.number<mcap::Op>();
  const auto length = content.number<std::uint64_t>();
  footer.summary = content.number<std::uint64_t>();
  content.number<std::uint64_t>();  // summary offsets
  footer.checksum = content.number<std::uint32_t>();
  return op == mcap::Op::footer && length == mcap::kFooter &&
         footer.summary >= mcap::kMagic.size() && footer.summary < offset;
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
  if (fileSize < mcap::kMagic.size() + kTail) return {};
  const std::uint64_t end = fileSize - kTail;
  Footer footer;
  if (!readFooter(file, end, footer)) return {};
  // The checksum covers the footer up to itself.
  std::vector<std::uint8_t> summary(static_cast<std::size_t>(end - footer.summary) + kFooterRecord -
                                    sizeof footer.checksum);
  if (!readAt(file, footer.summary, summary.data(), summary.size())) return {};
  if (footer.checksum != 0 && footer.checksum != crc32(summary.data(), summary.size())) return {};
  summary.resize(static_cast<std::size_t>(end - footer.summary));
  return summary;
}

}  // namespace kelpie

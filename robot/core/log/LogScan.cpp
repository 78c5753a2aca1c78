// SPDX-License-Identifier: Apache-2.0
#include "robot/core/log/LogScan.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace kelpie {
namespace {

using mcap::Op;

constexpr std::size_t kFirstWindow = 4096;  // bytes looked at in one read,
constexpr std::size_t kWindow = 1 << 20;    // and at most
constexpr int kChain = 3;                   // heads in a row; two may be chance among zeros
// A record that is said to be longer than this and runs over the end of the file is not believed.
constexpr std::uint64_t kMaxCut = 256U << 20;

// Bytes that the content of a record has at least (mcap.dev/spec, Records); 0: no such kind.
constexpr std::array<std::uint8_t, 16> kMin = {0,  8,  20, 14, 16, 22, 40, 6,
                                               64, 36, 48, 46, 8,  20, 17, 4};

struct Head {
  std::uint8_t op = 0;
  std::uint64_t length = 0;

  bool possible() const { return op < kMin.size() && kMin[op] > 0 && length >= kMin[op]; }
};

Head headAt(const std::uint8_t* from) {
  Head head;
  head.op = from[0];
  std::memcpy(&head.length, from + 1, sizeof head.length);
  return head;
}

// The indexes at the end of a log are never a place to go on from.
bool isLookedFor(std::uint8_t op, ScanFor scanFor) {
  switch (static_cast<Op>(op)) {
    case Op::chunk:
    case Op::messageIndex: return true;
    case Op::schema:
    case Op::channel:
    case Op::message: return scanFor == ScanFor::any;
    case Op::attachment:
    case Op::metadata:
    case Op::dataEnd: return scanFor != ScanFor::chunks;
    default: return false;
  }
}

// Whether a chunk or an index of messages that is so long can begin with these bytes: a length by
// chance may end where a record begins, one in some hundred does.
bool fits(const Head& head, mcap::ContentReader content) {
  if (head.op == static_cast<std::uint8_t>(Op::dataEnd)) return head.length <= kLongestDataEnd;
  if (head.op == static_cast<std::uint8_t>(Op::messageIndex)) {
    content.number<std::uint16_t>();  // channel
    const auto bytes = content.number<std::uint32_t>();
    return bytes % 16 == 0 && 6U + bytes <= head.length;
  }
  if (head.op != static_cast<std::uint8_t>(Op::chunk)) return true;
  const auto first = content.number<std::uint64_t>();
  const auto last = content.number<std::uint64_t>();
  content.take(8 + 4);  // size and checksum
  const std::string name = content.string();
  const auto bytes = content.number<std::uint64_t>();
  return content.good() && first <= last && (name.empty() || name == "zstd" || name == "lz4") &&
         bytes <= head.length && kMin[head.op] + name.size() + bytes <= head.length;
}

}  // namespace

bool readAt(std::istream& file, std::uint64_t offset, std::uint8_t* to, std::size_t count) {
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count));
  const bool whole = file.good();
  file.clear();
  return whole;
}

// The last record may be cut off: a file that lost power both ways.
bool LogScan::sound(std::uint64_t offset) const {
  std::array<std::uint8_t, mcap::kRecordHead> bytes{};
  for (int link = 0; link < kChain; ++link) {
    if (offset == size_) return true;
    if (!readAt(file_, offset, bytes.data(), mcap::kMagic.size())) return link > 0;
    if (std::equal(mcap::kMagic.begin(), mcap::kMagic.end(), bytes.begin()))
      return offset + mcap::kMagic.size() == size_;
    if (!readAt(file_, offset, bytes.data(), bytes.size())) return link > 0;
    const Head head = headAt(bytes.data());
    if (!head.possible()) return false;
    const std::uint64_t left = size_ - offset - bytes.size();
    if (head.length > left) return link > 0 && head.length < kMaxCut;
    offset += bytes.size() + head.length;
  }
  return true;
}

// A chunk says enough of itself, and what stands behind it may be damaged, too.
bool LogScan::begins(std::uint64_t offset) const {
  std::array<std::uint8_t, 64> bytes{};
  const auto count =
      static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), size_ - offset));
  if (!readAt(file_, offset, bytes.data(), count)) return false;
  const Head head = headAt(bytes.data());
  if (!fits(head, {bytes.data() + mcap::kRecordHead, count - mcap::kRecordHead})) return false;
  return head.op == static_cast<std::uint8_t>(Op::chunk) || sound(offset);
}

// The next record is near as a rule; so little is looked at first, and then more and more.
std::optional<std::uint64_t> LogScan::next(std::uint64_t from, ScanFor scanFor) const {
  std::vector<std::uint8_t> window;
  std::size_t span = kFirstWindow;
  for (; from + mcap::kRecordHead <= size_; from += span, span = std::min(2 * span, kWindow)) {
    window.resize(span + mcap::kRecordHead - 1);
    const auto count =
        static_cast<std::size_t>(std::min<std::uint64_t>(window.size(), size_ - from));
    if (!readAt(file_, from, window.data(), count)) return {};
    for (std::size_t i = 0; i + mcap::kRecordHead <= count; ++i) {
      const Head head = headAt(window.data() + i);
      const std::uint64_t left = size_ - from - i - mcap::kRecordHead;
      if (!head.possible() || head.length > left) continue;
      if (isLookedFor(head.op, scanFor) && begins(from + i)) return from + i;
    }
  }
  return {};
}

}  // namespace kelpie

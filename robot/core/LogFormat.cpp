// SPDX-License-Identifier: Apache-2.0
#include "robot/core/LogFormat.h"

namespace kelpie::mcap {
namespace {

// Reflected polynomial of zip and Ethernet, as the MCAP specification asks for.
constexpr std::array<std::uint32_t, 256> crcTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value & 1) != 0 ? (value >> 1) ^ 0xedb88320U : value >> 1;
    }
    table[i] = value;
  }
  return table;
}
constexpr std::array<std::uint32_t, 256> kCrcTable = crcTable();

}  // namespace

std::uint32_t crc32(const std::uint8_t* data, std::size_t size) {
  std::uint32_t crc = 0xffffffffU;
  for (std::size_t i = 0; i < size; ++i) crc = kCrcTable[(crc ^ data[i]) & 0xff] ^ (crc >> 8);
  return ~crc;
}

void RecordWriter::map(const LogMap& entries) {
  std::size_t size = 0;
  for (const auto& entry : entries) size += 8 + entry.first.size() + entry.second.size();
  number(static_cast<std::uint32_t>(size));
  for (const auto& entry : entries) {
    string(entry.first);
    string(entry.second);
  }
}

LogMap ContentReader::map() {
  LogMap entries;
  const std::size_t size = number<std::uint32_t>();
  if (size > left_) good_ = false;
  const std::size_t end = good_ ? left_ - size : 0;
  while (good_ && left_ > end) {
    std::string key = string();
    entries[std::move(key)] = string();
  }
  return entries;
}

}  // namespace kelpie::mcap

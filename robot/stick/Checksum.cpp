// SPDX-License-Identifier: Apache-2.0
#include "robot/stick/Checksum.h"

#include <array>

namespace kelpie::stick {
namespace {

using CrcTable = std::array<std::uint32_t, 256>;

constexpr CrcTable makeCrcTable() {
  CrcTable table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1U) ^ ((rest & 1U) * 0xEDB88320U);
    table[byte] = rest;
  }
  return table;
}

constexpr CrcTable kCrcTable = makeCrcTable();

}  // namespace

void Crc32::add(const std::uint8_t* bytes, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    state_ = (state_ >> 8U) ^ kCrcTable[(state_ ^ bytes[i]) & 0xFFU];
}

void Fnv1a::add(const std::uint8_t* bytes, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) add(bytes[i]);
}

}  // namespace kelpie::stick

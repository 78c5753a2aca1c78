// SPDX-License-Identifier: Apache-2.0
// What tells damaged bytes: CRC-32 (the polynomial of Ethernet, zip and MCAP, 0xEDB88320
// reflected), and the 64-bit hash FNV-1a, which also gives things a number. Both change with any
// single changed bit; two errors that one of them misses the other still sees. Neither is proof
// against intent: whoever writes the bytes can write both.
#pragma once

#include <cstddef>
#include <cstdint>

namespace kelpie {

class Crc32 {
 public:
  void add(const std::uint8_t* bytes, std::size_t count);
  std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xFFFFFFFFU;
};

std::uint32_t crc32(const std::uint8_t* bytes, std::size_t count);

class Fnv1a {
 public:
  void add(const void* bytes, std::size_t count);
  constexpr void add(std::uint8_t byte) { state_ = (state_ ^ byte) * 0x100000001b3ULL; }
  constexpr std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace kelpie

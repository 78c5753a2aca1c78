// SPDX-License-Identifier: Apache-2.0
// Basic types of OPEN-R with their documented widths (spec openr.md section 5). On the robot
// longword is unsigned long, which has 32 bits there; here it is a 32-bit type by name. `byte` is
// global, as in the original: never write `using namespace std` beside it.
#pragma once

#include <cstddef>
#include <cstdint>

using byte = std::uint8_t;
using sbyte = std::int8_t;
using word = std::uint16_t;
using sword = std::int16_t;
using longword = std::uint32_t;
using slongword = std::int32_t;

using Selector = longword;
using MemoryRegionID = longword;

constexpr Selector UNDEF = 0xffffffff;

// Names an object of the system.
class OID {
 public:
  constexpr OID() = default;
  explicit constexpr OID(longword number) : number_(number) {}

  void MakeInvalid() { number_ = UNDEF; }
  bool IsValid() const { return number_ != UNDEF; }
  bool operator==(const OID& other) const { return number_ == other.number_; }
  bool operator!=(const OID& other) const { return number_ != other.number_; }
  bool operator<(const OID& other) const { return number_ < other.number_; }

 private:
  longword number_ = UNDEF;
};
static_assert(sizeof(OID) == 4, "openr.md section 5");

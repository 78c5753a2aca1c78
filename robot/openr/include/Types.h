// SPDX-License-Identifier: Apache-2.0
// Basic types of OPEN-R with their documented widths (spec openr.md section 5). `byte` is global,
// as in the original: never write `using namespace std` beside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

// 32 bits wide. On the robot they are `unsigned long` and `long`; so they are here where that has
// 32 bits, so that a format or an overload that would fail there fails in a 32-bit build as well.
namespace kelpie::openr {
constexpr bool kLongIsRobots = sizeof(long) == 4;
}

using byte = std::uint8_t;
using sbyte = std::int8_t;
using word = std::uint16_t;
using sword = std::int16_t;
using longword = std::conditional_t<kelpie::openr::kLongIsRobots, unsigned long, std::uint32_t>;
using slongword = std::conditional_t<kelpie::openr::kLongIsRobots, long, std::int32_t>;
static_assert(sizeof(longword) == 4 && sizeof(slongword) == 4, "openr.md section 5");

using Selector = longword;
using MemoryRegionID = unsigned int;

constexpr Selector UNDEF = 0xffffffff;

// Names an object of the system by an address: 4 bytes on the robot (openr-measured.md 2).
class OID {
 public:
  OID() { MakeInvalid(); }
  explicit OID(void* address) : address_(address) {}

  void MakeInvalid() { address_ = reinterpret_cast<void*>(~std::uintptr_t{0}); }
  bool IsValid() const { return address_ != OID().address_; }
  void* GetAddress() const { return address_; }
  void SetAddress(void* address) { address_ = address; }

  bool operator==(const OID& other) const { return address_ == other.address_; }
  bool operator!=(const OID& other) const { return address_ != other.address_; }
  bool operator<(const OID& other) const { return address_ < other.address_; }

 private:
  void* address_;
};
static_assert(sizeof(OID) == sizeof(void*), "openr.md section 5");

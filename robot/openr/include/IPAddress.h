// SPDX-License-Identifier: Apache-2.0
// An address and a port of the internet (openr.md 5.7); 4 bytes, the first of which is the first
// that is written.
#pragma once

#include "antTypes.h"

class IPAddress {
 public:
  IPAddress() = default;
  explicit IPAddress(uint32 number) : number_(number) {}
  uint32 Address() const { return number_; }
  bool operator==(const IPAddress& other) const { return number_ == other.number_; }

 private:
  uint32 number_ = 0;
};
static_assert(sizeof(IPAddress) == 4, "openr.md 3.4");

using Port = std::uint16_t;

inline const IPAddress IP_ADDR_ANY{0};
inline const IPAddress IP_ADDR_BROADCAST{0xffffffff};
constexpr Port IP_PORT_ANY = 0;

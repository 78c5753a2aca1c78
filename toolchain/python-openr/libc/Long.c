// SPDX-License-Identifier: Apache-2.0
// Whole numbers of 64 bits as the compiler asks libgcc for them. Our own, since Debian's library
// has instructions that the robot lacks, and of the SDK's only the conversions to double were
// compared. By halves and single places: a shift by a number that is known needs no help.
#include <stdint.h>

int64_t __ashldi3(int64_t value, int places) {
  const uint32_t low = (uint32_t)value, high = (uint32_t)((uint64_t)value >> 32);
  if (places == 0) return value;
  const uint32_t above =
      places >= 32 ? low << (places - 32) : high << places | low >> (32 - places);
  return (int64_t)((uint64_t)above << 32 | (places >= 32 ? 0 : low << places));
}

// The quotient; a division by zero gives all ones, as the CPU's own may.
static uint64_t divide(uint64_t number, uint64_t by, uint64_t* rest) {
  uint64_t quotient = 0, left = 0;
  if (number >> 32 == 0 && by >> 32 == 0 && by != 0) {
    *rest = (uint32_t)number % (uint32_t)by;
    return (uint32_t)number / (uint32_t)by;
  }
  for (int i = 0; i < 64; ++i) {
    const uint64_t over = left >> 63;
    left = left << 1 | number >> 63;
    number <<= 1;
    quotient <<= 1;
    if (over == 0 && left < by) continue;
    left -= by;
    quotient |= 1;
  }
  *rest = left;
  return quotient;
}

static uint64_t sizeOf(int64_t value) { return value < 0 ? -(uint64_t)value : (uint64_t)value; }

uint64_t __udivdi3(uint64_t number, uint64_t by) {
  uint64_t rest;
  return divide(number, by, &rest);
}
uint64_t __umoddi3(uint64_t number, uint64_t by) {
  uint64_t rest;
  divide(number, by, &rest);
  return rest;
}
int64_t __divdi3(int64_t number, int64_t by) {
  uint64_t rest;
  const uint64_t quotient = divide(sizeOf(number), sizeOf(by), &rest);
  return (int64_t)((number < 0) != (by < 0) ? -quotient : quotient);
}
int64_t __moddi3(int64_t number, int64_t by) {
  uint64_t rest;
  divide(sizeOf(number), sizeOf(by), &rest);
  return (int64_t)(number < 0 ? -rest : rest);
}

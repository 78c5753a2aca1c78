// SPDX-License-Identifier: Apache-2.0
// floor, ceil and lround with the bits of glibc, by additions alone. The C library of the SDK has
// lround wrong for 2^20 <= |x| < 2^21 (1048576.0 becomes -2146435072), and gives floor(-0.0) and
// ceil(-0.5) without their sign (openr-measured.md 4). The names are other than the C library's so
// that the tests can compare both; Rounding.cpp gives them to the object.
#pragma once

#include <cstdint>

namespace kelpie::openr {

// From 2^52 on every double is whole; what is below it loses its fraction when this is added.
constexpr double kWhole = 4503599627370496.0;

// To the nearest whole number, ties to even, the sign kept; |x| < 2^52.
inline double nearest(double x) {
  const double whole = x < 0.0 ? (x - kWhole) + kWhole : (x + kWhole) - kWhole;
  return __builtin_copysign(whole, x);
}

inline bool isWhole(double x) { return !(__builtin_fabs(x) < kWhole); }  // or not a number

inline double floorOf(double x) {
  if (isWhole(x)) return x;
  const double near = nearest(x);
  return near > x ? near - 1.0 : near;
}

inline double ceilOf(double x) {
  if (isWhole(x)) return x;
  const double near = nearest(x);
  return __builtin_copysign(near < x ? near + 1.0 : near, x);
}

// Halves away from 0, as C's; |x| < 2^31.
inline std::int32_t lroundOf(double x) {
  const double size = __builtin_fabs(x);
  const double below = floorOf(size);
  const double rounded = size - below >= 0.5 ? below + 1.0 : below;  // the difference is exact
  return static_cast<std::int32_t>(x < 0.0 ? -rounded : rounded);
}

// Leading zeros of a word that is not 0; gcc calls __clzsi2 for it on MIPS II.
inline int leadingZeros(std::uint32_t word) {
  int zeros = 0;
  for (std::uint32_t bit = 0x80000000U; bit != 0 && (word & bit) == 0; bit >>= 1) ++zeros;
  return zeros;
}

}  // namespace kelpie::openr

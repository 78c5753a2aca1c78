// SPDX-License-Identifier: Apache-2.0
#include "robot/core/Maths.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace kelpie::maths {
namespace {

// pi/2 in three parts, so that k * part is exact for |k| < 2^17 (Cody and Waite's reduction).
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiMid = 6.07710050630396597660e-11;
constexpr double kHalfPiLow = 2.02226624879595063154e-21;
constexpr double kLn2High = 6.93147180369123816490e-01;
constexpr double kLn2Low = 1.90821492927058770002e-10;

// Taylor series on [-pi/4, pi/4]: the first term left out is below 1e-17.
double sinReduced(double x) {
  const double z = x * x;
  double p = -1.0 / 1307674368000.0;
  p = p * z + 1.0 / 6227020800.0;
  p = p * z - 1.0 / 39916800.0;
  p = p * z + 1.0 / 362880.0;
  p = p * z - 1.0 / 5040.0;
  p = p * z + 1.0 / 120.0;
  p = p * z - 1.0 / 6.0;
  return x + x * z * p;
}

double cosReduced(double x) {
  const double z = x * x;
  double p = 1.0 / 20922789888000.0;
  p = p * z - 1.0 / 87178291200.0;
  p = p * z + 1.0 / 479001600.0;
  p = p * z - 1.0 / 3628800.0;
  p = p * z + 1.0 / 40320.0;
  p = p * z - 1.0 / 720.0;
  p = p * z + 1.0 / 24.0;
  return 1.0 - 0.5 * z + z * z * p;
}

// atan on [0, tan(pi/16)]: the first term left out is below 2e-17.
double atanReduced(double x) {
  // Written out, so that no division is left for the run: a frame takes some hundred arcs.
  constexpr std::array<double, 9> kTerms{1.0 / 19, 1.0 / 17, 1.0 / 15, 1.0 / 13, 1.0 / 11,
                                         1.0 / 9,  1.0 / 7,  1.0 / 5,  1.0 / 3};
  const double z = x * x;
  double p = 1.0 / 21.0;
  for (const double term : kTerms) p = term - z * p;
  return x - x * z * p;
}

// The floor, without the library's call; of what fits 32 bits.
std::int32_t floorOf(double value) {
  const auto cut = static_cast<std::int32_t>(value);
  return cut - (value < cut ? 1 : 0);
}

// Quarter turns as a whole number, and that number's lowest two bits.
struct Quarters {
  double count;
  unsigned quadrant;
};

// A conversion to 64 bits is a call of a hundred instructions on a 32-bit machine; no angle of a
// robot needs it.
Quarters quartersOf(double radians) {
  constexpr double kFew = 1e9;
  const double quarters = radians * (2.0 / kPi) + 0.5;
  if (std::fabs(quarters) < kFew) {
    const std::int32_t count = floorOf(quarters);
    return {static_cast<double>(count), static_cast<unsigned>(count) & 3U};
  }
  const double count = std::floor(quarters);
  return {count, static_cast<unsigned>(static_cast<std::int64_t>(count) & 3)};
}

// The angle less that many quarter turns, in [-pi/4, pi/4].
double lessQuarters(double radians, double quarters) {
  return ((radians - quarters * kHalfPiHigh) - quarters * kHalfPiMid) - quarters * kHalfPiLow;
}

}  // namespace

SinCos sinCos(double radians) {
  const auto [k, quadrant] = quartersOf(radians);
  const double x = lessQuarters(radians, k);
  const double s = sinReduced(x);
  const double c = cosReduced(x);
  switch (quadrant) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

// One series where sinCos() takes two; the same bits.
double sin(double radians) {
  const auto [k, quadrant] = quartersOf(radians);
  const double x = lessQuarters(radians, k);
  const double value = (quadrant & 1U) == 0 ? sinReduced(x) : cosReduced(x);
  return quadrant < 2 ? value : -value;
}

double cos(double radians) {
  const auto [k, quadrant] = quartersOf(radians);
  const double x = lessQuarters(radians, k);
  const double value = (quadrant & 1U) == 0 ? cosReduced(x) : sinReduced(x);
  return quadrant == 0 || quadrant == 3 ? value : -value;
}

double tan(double radians) {
  const SinCos sc = sinCos(radians);
  return sc.sin / sc.cos;
}

double atan(double x) {
  constexpr double kTanPi16 = 0.19891236737965800691;
  constexpr double kTanPi8 = 0.41421356237309504880;
  constexpr double kTan3Pi16 = 0.66817863791929891999;
  const double a = x < 0 ? -x : x;
  const bool inverse = a > 1.0;
  double t = inverse ? 1.0 / a : a;
  double offset = 0.0;
  if (t > kTan3Pi16) {
    offset = kPi / 4;
    t = (t - 1.0) / (t + 1.0);
  } else if (t > kTanPi16) {
    offset = kPi / 8;
    t = (t - kTanPi8) / (1.0 + t * kTanPi8);
  }
  const double reduced = t < 0 ? -atanReduced(-t) : atanReduced(t);
  const double first = offset + reduced;
  const double result = inverse ? kPi / 2 - first : first;
  return x < 0 ? -result : result;
}

double atan2(double y, double x) {
  if (x > 0) return atan(y / x);
  if (x < 0) return y < 0 ? atan(y / x) - kPi : atan(y / x) + kPi;
  if (y > 0) return kPi / 2;
  return y < 0 ? -kPi / 2 : 0.0;
}

double asin(double x) {
  const double c = clamp(x, -1.0, 1.0);
  return atan2(c, std::sqrt((1.0 - c) * (1.0 + c)));
}

double acos(double x) {
  const double c = clamp(x, -1.0, 1.0);
  return atan2(std::sqrt((1.0 - c) * (1.0 + c)), c);
}

double exp(double x) {
  if (!(x > -700.0)) return 0.0;
  const double bounded = x > 700.0 ? 700.0 : x;
  const std::int32_t k = floorOf(bounded / 0.69314718055994530942 + 0.5);
  const double r = (bounded - k * kLn2High) - k * kLn2Low;
  // Products, not quotients, of which an exponential took thirteen.
  double p = 1.0;
  p = 1.0 + r * p * (1.0 / 14.0);
  p = 1.0 + r * p * (1.0 / 13.0);
  p = 1.0 + r * p * (1.0 / 12.0);
  p = 1.0 + r * p * (1.0 / 11.0);
  p = 1.0 + r * p * (1.0 / 10.0);
  p = 1.0 + r * p * (1.0 / 9.0);
  p = 1.0 + r * p * (1.0 / 8.0);
  p = 1.0 + r * p * (1.0 / 7.0);
  p = 1.0 + r * p * (1.0 / 6.0);
  p = 1.0 + r * p * (1.0 / 5.0);
  p = 1.0 + r * p * (1.0 / 4.0);
  p = 1.0 + r * p * (1.0 / 3.0);
  p = 1.0 + r * p * (1.0 / 2.0);
  p = 1.0 + r * p;
  const auto bits = static_cast<std::uint64_t>(k + 1023) << 52;
  double scale = 0.0;
  std::memcpy(&scale, &bits, sizeof scale);
  return p * scale;
}

double log(double x) {
  // Written out, so that no division is left for the run.
  constexpr std::array<double, 10> kTerms{1.0 / 21, 1.0 / 19, 1.0 / 17, 1.0 / 15, 1.0 / 13,
                                          1.0 / 11, 1.0 / 9,  1.0 / 7,  1.0 / 5,  1.0 / 3};
  if (!(x > 0.0)) return -745.0;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  double exponent = static_cast<std::int32_t>(bits >> 52) - 1023;
  bits = (bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL;
  double m = 1.0;
  std::memcpy(&m, &bits, sizeof m);
  if (m > 1.41421356237309504880) {
    m *= 0.5;
    exponent += 1.0;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double z = s * s;
  double p = 1.0 / 23.0;
  for (const double term : kTerms) p = term + z * p;
  return exponent * kLn2High + (2.0 * s + (2.0 * s * z * p + exponent * kLn2Low));
}

double hypot(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace kelpie::maths

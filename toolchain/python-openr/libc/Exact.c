// SPDX-License-Identifier: Apache-2.0
// The functions of the C library's maths and of libgcc that are exact, by the bits of a number:
// taking apart, putting together, whole numbers, and the square root, which the CPU rounds exactly.
// Those that round otherwise (sin, atan2 and so on) are glibc's: see `build`.
#include <math.h>
#include <stdint.h>

typedef union Bits {
  double value;
  uint64_t bits;
} Bits;

enum { kExponentBits = 0x7ff, kBias = 1023, kPlaces = 52 };

static int exponentOf(double x) { return (int)((Bits){x}.bits >> kPlaces) & kExponentBits; }

double frexp(double x, int* exponent) {
  *exponent = 0;
  if (x == 0.0 || exponentOf(x) == kExponentBits) return x;
  int shift = 0;
  if (exponentOf(x) == 0) x *= 0x1p54, shift = -54;  // a denormal
  *exponent = exponentOf(x) - (kBias - 1) + shift;
  Bits part = {x};
  part.bits = (part.bits & ~((uint64_t)kExponentBits << kPlaces)) | (uint64_t)(kBias - 1)
                                                                        << kPlaces;
  return part.value;
}

static double powerOfTwo(int exponent) {
  Bits power;
  power.bits = (uint64_t)(exponent + kBias) << kPlaces;
  return power.value;
}

// Steps of 2^1023 and of 2^-969, which leaves 53 places above the smallest denormal, so that only
// the last product rounds.
double ldexp(double x, int exponent) {
  if (exponent > 3000) exponent = 3000;
  if (exponent < -3000) exponent = -3000;
  for (; exponent > 1023; exponent -= 1023) x *= powerOfTwo(1023);
  for (; exponent < -1022; exponent += 969) x *= powerOfTwo(-969);
  return x * powerOfTwo(exponent);
}
double scalbn(double x, int exponent) { return ldexp(x, exponent); }

double copysign(double x, double y) {
  const uint64_t sign = (uint64_t)1 << 63;
  return (Bits){.bits = ((Bits){x}.bits & ~sign) | ((Bits){y}.bits & sign)}.value;
}

double modf(double x, double* whole) {
  Bits part = {x};
  const int places = kPlaces + kBias - exponentOf(x);  // bits behind the point
  if (x != x) return *whole = x;
  if (places <= 0) {
    *whole = x;
    return copysign(0.0, x);
  }
  part.bits &= places > kPlaces ? (uint64_t)1 << 63 : ~(((uint64_t)1 << places) - 1);
  *whole = part.value;
  return copysign(x - part.value, x);
}

double floor(double x) {
  double whole;
  return modf(x, &whole) < 0.0 ? whole - 1.0 : whole;
}

double ceil(double x) {
  double whole;
  return modf(x, &whole) > 0.0 ? whole + 1.0 : whole;
}

// Halves go away from zero.
double round(double x) {
  double whole;
  return fabs(modf(x, &whole)) >= 0.5 ? whole + copysign(1.0, x) : whole;
}

double fabs(double x) { return __builtin_fabs(x); }
double sqrt(double x) { return __builtin_sqrt(x); }  // the instruction: -fno-math-errno

void sincos(double x, double* sine, double* cosine) {
  *sine = sin(x);
  *cosine = cos(x);
}

// --- bits of whole numbers, which the SDK's libgcc lacks
int __popcountsi2(uint32_t word) {
  int count = 0;
  for (; word != 0; word &= word - 1) ++count;
  return count;
}

uint32_t __bswapsi2(uint32_t word) {
  return word << 24 | (word & 0xff00) << 8 | (word >> 8 & 0xff00) | word >> 24;
}

int __clzsi2(uint32_t word) {
  int zeros = 0;
  for (uint32_t bit = (uint32_t)1 << 31; bit != 0 && (word & bit) == 0; bit >>= 1) ++zeros;
  return zeros;
}

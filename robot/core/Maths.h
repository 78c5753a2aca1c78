// SPDX-License-Identifier: Apache-2.0
// Elementary functions that give the same bits on every machine: only + - * / and sqrt, which
// IEEE 754 rounds exactly. The C library's double sin, cos, atan2, exp and log differ in the last
// bit between x86-64 with FMA and mipsel (138 of 200 000 arguments for sin), which would break the
// bit-exact replay on the target. Accurate to about 2 ulp for the angles and ranges a robot meets;
// sin and cos lose accuracy beyond |x| = 1e5.
#pragma once

namespace kelpie::maths {

constexpr double kPi = 3.14159265358979323846;

struct SinCos {
  double sin;
  double cos;
};

SinCos sinCos(double radians);
double sin(double radians);
double cos(double radians);
double tan(double radians);
double atan(double x);
double atan2(double y, double x);
double asin(double x);  // argument clamped to [-1, 1]
double acos(double x);  // argument clamped to [-1, 1]
double exp(double x);   // 0 below -700, exp(700) above 700
double log(double x);   // x > 0; returns -745 for x <= 0
double hypot(double x, double y);

template <class T>
constexpr T clamp(T value, T low, T high) {
  return value < low ? low : (value > high ? high : value);
}

template <class T>
constexpr T square(T value) {
  return value * value;
}

}  // namespace kelpie::maths

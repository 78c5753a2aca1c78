// SPDX-License-Identifier: Apache-2.0
// A plane angle, always normalised to (-pi, pi]. Left and up are positive, as everywhere in Kelpie.
// No conversion from or to a number happens silently: say rad or deg.
#pragma once

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie {

class Angle {
 public:
  constexpr Angle() = default;
  static Angle rad(double radians) { return Angle(normalised(radians)); }
  static Angle deg(double degrees) { return rad(degrees * (maths::kPi / 180.0)); }

  double rad() const { return radians_; }
  double deg() const { return radians_ * (180.0 / maths::kPi); }
  double sin() const { return maths::sin(radians_); }
  double cos() const { return maths::cos(radians_); }
  maths::SinCos sinCos() const { return maths::sinCos(radians_); }  // at the price of one
  Angle abs() const { return Angle(std::fabs(radians_)); }

  Angle operator-() const { return rad(-radians_); }
  Angle operator+(Angle other) const { return rad(radians_ + other.radians_); }
  Angle operator-(Angle other) const { return rad(radians_ - other.radians_); }
  Angle operator*(double factor) const { return rad(radians_ * factor); }
  bool operator==(Angle other) const { return radians_ == other.radians_; }
  bool operator!=(Angle other) const { return radians_ != other.radians_; }
  bool operator<(Angle other) const { return radians_ < other.radians_; }
  bool operator>(Angle other) const { return radians_ > other.radians_; }

 private:
  explicit Angle(double radians) : radians_(radians) {}

  static double normalised(double r) {
    if (r > -maths::kPi && r <= maths::kPi) return r;
    const double turns = std::ceil((r - maths::kPi) / (2.0 * maths::kPi));
    const double wrapped = r - turns * (2.0 * maths::kPi);
    if (wrapped <= -maths::kPi) return wrapped + 2.0 * maths::kPi;
    return wrapped > maths::kPi ? wrapped - 2.0 * maths::kPi : wrapped;
  }

  double radians_ = 0.0;
};

inline namespace literals {
inline Angle operator""_deg(long double degrees) {
  return Angle::deg(static_cast<double>(degrees));
}
inline Angle operator""_deg(unsigned long long degrees) {
  return Angle::deg(static_cast<double>(degrees));
}
}  // namespace literals

}  // namespace kelpie

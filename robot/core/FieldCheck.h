// SPDX-License-Identifier: Apache-2.0
// Field by field: where two values first differ (bits, not tolerance, as replays must repeat), and
// whether a value is finite and in the ranges of its field list. Both name the place as
// "percepts.landmarks[2].distance".
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "robot/core/FieldTypes.h"

namespace kelpie {

namespace detail {

// Each step writes its part of the path in front of what is there, from the inside out.
void prependName(const char* name, std::string* path);
void prependIndex(std::size_t index, std::string* path);
std::string outsideText(double value, double min, double max, const std::string& unit);

template <class T>
std::string scalarText(const T& value) {
  if constexpr (std::is_same_v<T, Angle>) {
    return numberText(value.rad());
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    return std::to_string(value.us);
  } else if constexpr (std::is_enum_v<T>) {
    return std::to_string(static_cast<std::int64_t>(value));
  } else if constexpr (std::is_integral_v<T>) {
    return std::to_string(value);
  } else {
    return numberText(static_cast<double>(value));
  }
}

template <class T>
bool differs(const T& a, const T& b, std::string* path);

template <class S>
bool sequenceDiffers(const S& a, const S& b, std::string* path) {
  if constexpr (IsText<S>::value) {
    if (a.view() == b.view()) return false;
    *path = ": \"" + std::string(a.view()) + "\" != \"" + std::string(b.view()) + '"';
    return true;
  }
  if (a.size() != b.size()) {
    *path = ": " + std::to_string(a.size()) + " elements != " + std::to_string(b.size());
    return true;
  }
  if constexpr (std::is_arithmetic_v<typename S::value_type>) {
    const std::size_t bytes = a.size() * sizeof(typename S::value_type);
    if (bytes == 0 || std::memcmp(a.begin(), b.begin(), bytes) == 0) return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!differs(a[i], b[i], path)) continue;
    prependIndex(i, path);
    return true;
  }
  return false;
}

template <class T>
bool differs(const T& a, const T& b, std::string* path) {
  if constexpr (kIsSequence<T>) {
    return sequenceDiffers(a, b, path);
  } else if constexpr (HasFields<T>::value) {
    bool different = false;
    forEachField(a, [&](const auto& f, const auto& member) {
      if (different || !differs(member, b.*(f.member), path)) return;
      prependName(f.name, path);
      different = true;
    });
    return different;
  } else {
    if (std::memcmp(&a, &b, sizeof(T)) == 0) return false;
    *path = ": " + scalarText(a) + " != " + scalarText(b);
    return true;
  }
}

struct Range {
  const char* unit;
  double min;
  double max;
};

template <class T>
bool scalarInRange(const T& value, const Range& range, std::string* why) {
  double number = 0.0;
  std::string unit = range.unit;
  if constexpr (std::is_same_v<T, Angle>) {
    number = value.deg();
    unit = "deg";
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    number = static_cast<double>(value.us);
  } else {
    number = static_cast<double>(value);
  }
  // Degrees are rounded when made from radians: a limit itself may come out 3e-14 beyond it.
  constexpr double kSlack = std::is_same_v<T, Angle> ? 1e-9 : 0.0;
  if (std::isfinite(number) && number >= range.min - kSlack && number <= range.max + kSlack) {
    return true;
  }
  *why = outsideText(number, range.min, range.max, unit);
  return false;
}

template <class T>
bool inRange(const T& value, const Range& range, std::string* why);

template <class S>
bool sequenceInRange(const S& items, const Range& range, std::string* why) {
  // Bytes without a range (images) cannot be wrong.
  if (std::is_integral_v<typename S::value_type> && !std::isfinite(range.min) &&
      !std::isfinite(range.max)) {
    return true;
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (inRange(items[i], range, why)) continue;
    prependIndex(i, why);
    return false;
  }
  return true;
}

template <class T>
bool inRange(const T& value, const Range& range, std::string* why) {
  if constexpr (kIsSequence<T>) {
    return sequenceInRange(value, range, why);
  } else if constexpr (HasFields<T>::value) {
    bool good = true;
    forEachField(value, [&](const auto& f, const auto& member) {
      if (!good || inRange(member, Range{f.unit, f.min, f.max}, why)) return;
      prependName(f.name, why);
      good = false;
    });
    return good;
  } else {
    return scalarInRange(value, range, why);
  }
}

}  // namespace detail

// True when a and b differ in any bit of a field; path: "ball.distance: 100.5 != 100.6".
template <class T>
bool firstDifference(const T& a, const T& b, std::string* path) {
  std::string text;
  if (!detail::differs(a, b, &text)) return false;
  if (path != nullptr) *path = text;
  return true;
}

// True when every number is finite and in range; why: "ball.distance: -3 cm is outside 0..1000".
template <class T>
bool verify(const T& value, std::string* why) {
  std::string text;
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  if (detail::inRange(value, detail::Range{"", -kEnd, kEnd}, &text)) return true;
  if (why != nullptr) *why = text;
  return false;
}

}  // namespace kelpie

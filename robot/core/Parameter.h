// SPDX-License-Identifier: Apache-2.0
// One tunable as the parameter reader sees it: its full key ("vision.ball.maxDistance"), unit,
// range and the way to its member. Numbers pass as doubles in the unit that the member is kept in:
// angles in radians, TimeUs in microseconds.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/FieldTypes.h"

namespace kelpie {

struct Parameter {
  // list: of structs, which a parameter file cannot set
  enum class Kind { boolean, whole, real, angle, time, list };

  std::string key;
  std::string unit;
  Kind kind = Kind::real;
  double min = 0.0;  // of the field; degrees for an angle
  double max = 0.0;
  bool isSequence = false;
  std::size_t minCount = 1;
  std::size_t maxCount = 1;
  std::function<std::vector<double>()> get{};
  std::function<void(const std::vector<double>&)> set{};
  std::vector<double> defaults{};
  std::string source{};  // "file:line" that set it last, empty while nothing did
};

// A number as written, with its unit: "12deg", "-3.5 cm/s". The result is in the member's unit and
// in range. Errors start with the parameter's key.
Expected<double> numberWithUnit(const Parameter& parameter, const std::string& text);
// A number written without unit.
Expected<double> bareNumber(const Parameter& parameter, double number);
// "12deg", "[1, 2]cm": for people, in degrees and seconds.
std::string valueText(const Parameter& parameter, const std::vector<double>& values);

namespace detail {

template <class T>
constexpr Parameter::Kind parameterKind() {
  using Kind = Parameter::Kind;
  if constexpr (std::is_same_v<T, bool>) return Kind::boolean;
  if constexpr (std::is_same_v<T, Angle>) return Kind::angle;
  if constexpr (std::is_same_v<T, TimeUs>) return Kind::time;
  return std::is_floating_point_v<T> ? Kind::real : Kind::whole;
}

template <class T>
double toNumber(const T& value) {
  if constexpr (std::is_same_v<T, Angle>) {
    return value.rad();
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    return static_cast<double>(value.us);
  } else {
    return static_cast<double>(value);
  }
}

template <class T>
T fromNumber(double number) {
  if constexpr (std::is_same_v<T, Angle>) {
    return Angle::rad(number);
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    return TimeUs{static_cast<std::int64_t>(number)};
  } else if constexpr (std::is_same_v<T, bool>) {
    return number != 0.0;
  } else {
    return static_cast<T>(number);
  }
}

// What the member's type can hold narrows the field's range. Doubles hold whole numbers exactly up
// to 2^53.
template <class T>
void narrowRange(Parameter& parameter) {
  double low = -9007199254740992.0;
  double high = 9007199254740992.0;
  if constexpr (std::is_enum_v<T>) {
    return narrowRange<std::underlying_type_t<T>>(parameter);
  } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    if (static_cast<double>(std::numeric_limits<T>::min()) > low) {
      low = static_cast<double>(std::numeric_limits<T>::min());
    }
    if (static_cast<double>(std::numeric_limits<T>::max()) < high) {
      high = static_cast<double>(std::numeric_limits<T>::max());
    }
  } else if constexpr (!std::is_same_v<T, TimeUs>) {
    return;
  }
  if (low > parameter.min) parameter.min = low;
  if (high < parameter.max) parameter.max = high;
}

template <class M>
void bindScalar(Parameter& parameter, M& member) {
  parameter.kind = parameterKind<M>();
  narrowRange<M>(parameter);
  parameter.get = [&member] { return std::vector<double>{toNumber(member)}; };
  parameter.set = [&member](const std::vector<double>& v) { member = fromNumber<M>(v[0]); };
}

template <class M>
void bindSequence(Parameter& parameter, M& member) {
  using Item = typename M::value_type;
  parameter.isSequence = true;
  parameter.kind = parameterKind<Item>();
  narrowRange<Item>(parameter);
  parameter.maxCount = M{}.size();
  if constexpr (IsFixedVector<M>::value) parameter.maxCount = M::kCapacity;
  parameter.minCount = IsFixedVector<M>::value ? 0 : parameter.maxCount;
  parameter.get = [&member] {
    std::vector<double> values;
    values.reserve(member.size());
    for (const Item& item : member) values.push_back(toNumber(item));
    return values;
  };
  parameter.set = [&member](const std::vector<double>& values) {
    if constexpr (IsFixedVector<M>::value) member.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) member[i] = fromNumber<Item>(values[i]);
  };
}

}  // namespace detail
}  // namespace kelpie

// SPDX-License-Identifier: Apache-2.0
// Any struct with a field list as a JSON object. A member `distanceVariance` in cm2 is called
// `distance_variance_cm2`; angles are given in degrees (`heading_deg`), times in seconds; a struct
// whose `present` is false is null. Enums are numbers.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "behaviour/views/PythonNames.h"
#include "robot/core/fields/FieldTypes.h"

namespace kelpie::cli {

using Json = nlohmann::ordered_json;

// Specialised for the enums that have names for people: a table in the order of the enum.
template <class Enum>
inline constexpr std::array<const char*, 0> kEnumNames{};

// "_cm", "_cm_s", "_deg2"; empty without a unit, or where each element has its own.
inline std::string jsonSuffix(const std::string& unit) {
  const std::string degrees = behaviour::unitSuffix(unit.c_str());
  if (!degrees.empty() || unit.empty() || unit.find(' ') != std::string::npos) return degrees;
  std::string text = "_" + unit;
  for (char& c : text) c = c == '/' ? '_' : c;
  return text;
}

// The key of a member: snake_case with its unit.
template <class Member>
std::string jsonName(const char* name, const char* unit) {
  using Scalar = typename behaviour::ScalarOf<Member>::type;
  const std::string text = behaviour::snakeCase(name);
  if constexpr (std::is_same_v<Scalar, Angle>) return text + "_deg";
  if constexpr (std::is_same_v<Scalar, TimeUs>) return text + "_s";
  if constexpr (std::is_floating_point_v<Scalar>) return text + jsonSuffix(unit);
  return text;
}

// The shortest decimal number of which `back` makes the value again, or `shown` itself. Radians
// turned into degrees would have noise in their last digits: 40.00000000000001.
template <class Back>
double shortest(double shown, Back&& back) {
  for (const int digits : {6, 9, 12, 15, 16}) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, shown);
    const double shorter = std::strtod(text, nullptr);
    if (back(shorter)) return shorter;
  }
  return shown;
}

inline double degreesOf(Angle angle) {
  return shortest(angle.deg(), [angle](double degrees) { return Angle::deg(degrees) == angle; });
}

template <class T>
Json fieldJson(const T& value, const char* unit = "") {
  if constexpr (IsText<T>::value) {
    return std::string(value.view());
  } else if constexpr (kIsSequence<T>) {
    Json list = Json::array();
    for (const auto& item : value) list.push_back(fieldJson(item, unit));
    return list;
  } else if constexpr (HasFields<T>::value) {
    Json object = Json::object();
    bool present = true;
    forEachField(value, [&](const auto& f, const auto& member) {
      using Member = std::decay_t<decltype(member)>;
      const std::string name = f.name;
      if constexpr (std::is_same_v<Member, bool>) {
        if (name == "present") present = member;
      }
      if (name != "present") object[jsonName<Member>(f.name, f.unit)] = fieldJson(member, f.unit);
    });
    return present ? object : Json(nullptr);
  } else if constexpr (std::is_same_v<T, Angle>) {
    return degreesOf(value);
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    return value.seconds();
  } else if constexpr (std::is_enum_v<T>) {
    const auto number = static_cast<std::size_t>(value);
    const auto& names = kEnumNames<T>;
    return number < names.size() ? Json(names[number]) : Json(number);
  } else if constexpr (std::is_floating_point_v<T>) {
    const double factor = behaviour::shownFactor(unit);
    const auto back = [value, factor](double n) { return static_cast<T>(n / factor) == value; };
    return factor == 1.0 && std::is_same_v<T, double> ? value : shortest(value * factor, back);
  } else {
    return value;
  }
}

}  // namespace kelpie::cli

// SPDX-License-Identifier: Apache-2.0
// Any struct with a field list as a JSON object. A member `distanceVariance` in cm2 is called
// `distance_variance_cm2`; angles are given in degrees (`heading_deg`), times in seconds; a struct
// whose `present` is false is null. Enums are numbers unless `enumNames` has their names.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "behaviour/PythonNames.h"
#include "robot/core/FieldTypes.h"

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
    return value.deg();
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    return value.seconds();
  } else if constexpr (std::is_enum_v<T>) {
    const auto number = static_cast<std::size_t>(value);
    const auto& names = kEnumNames<T>;
    return number < names.size() ? Json(names[number]) : Json(number);
  } else if constexpr (std::is_floating_point_v<T>) {
    return value * behaviour::shownFactor(unit);
  } else {
    return value;
  }
}

}  // namespace kelpie::cli

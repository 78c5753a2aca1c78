// SPDX-License-Identifier: Apache-2.0
// What one trial found, as a struct with a field list (robot/core/fields/Fields.h): toJson() makes
// it the message of a child process and part of the figures, fromJson() reads the message back. A
// member is a number, bool, string, std::vector, std::array or a struct with a list of its own. A
// number that is not finite comes back as NaN, as JSON knows none.
#pragma once

#include <limits>
#include <type_traits>

#include "robot/core/fields/FieldTypes.h"
#include "robot/core/fields/Fields.h"
#include "tools/cli/Figures.h"

namespace kelpie::experiments {

template <class T>
cli::Json toJson(const T& value) {
  if constexpr (HasFields<T>::value) {
    cli::Json object = cli::Json::object();
    forEachField(value,
                 [&](const auto& f, const auto& member) { object[f.name] = toJson(member); });
    return object;
  } else if constexpr (std::is_arithmetic_v<T> || std::is_convertible_v<T, std::string>) {
    return value;
  } else {
    cli::Json list = cli::Json::array();
    for (const auto& item : value) list.push_back(toJson(item));
    return list;
  }
}

// A message that does not fit its struct is a mistake of the program: nlohmann's exception.
template <class T>
void fromJson(const cli::Json& json, T& value) {
  if constexpr (HasFields<T>::value) {
    forEachField(value, [&](const auto& f, auto& member) { fromJson(json.at(f.name), member); });
  } else if constexpr (std::is_floating_point_v<T>) {
    value = json.is_null() ? std::numeric_limits<T>::quiet_NaN() : json.get<T>();
  } else if constexpr (std::is_arithmetic_v<T> || std::is_convertible_v<T, std::string>) {
    value = json.get<T>();
  } else {
    if constexpr (!IsArray<T>::value) value.resize(json.size());
    std::size_t i = 0;
    for (auto& item : value) fromJson(json.at(i++), item);
  }
}

}  // namespace kelpie::experiments

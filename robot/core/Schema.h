// SPDX-License-Identifier: Apache-2.0
// The definition of a struct in ROS 1 message text, made from its field list: fields with units and
// ranges as comments, then one "MSG:" section for each struct within. Goes into every log, so that
// any reader can decode it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/FieldTypes.h"

namespace kelpie {

namespace detail {

// "float64[3] name  # unit, min..max"
std::string schemaLine(const std::string& type, const char* name, const std::string& comment);
// Unit and range as a comment; empty when there is neither.
std::string rangeText(const char* unit, bool isAngle, double min, double max);

using SchemaSections = std::vector<std::pair<std::string, std::string>>;  // name, text
std::string joinSections(const SchemaSections& sections);

template <class T>
std::string numberTypeName() {
  if constexpr (std::is_same_v<T, bool>) {
    return "bool";
  } else if constexpr (std::is_floating_point_v<T>) {
    static_assert(sizeof(T) <= 8, "long double has no place in a log");
    return "float" + std::to_string(8 * sizeof(T));
  } else {
    return (std::is_signed_v<T> ? "int" : "uint") + std::to_string(8 * sizeof(T));
  }
}

template <class T>
void addSection(SchemaSections& sections);

// ROS 1 name of a member's type; structs within get their section.
template <class T>
std::string wireTypeName(SchemaSections& sections) {
  if constexpr (std::is_enum_v<T>) {
    return numberTypeName<std::underlying_type_t<T>>();
  } else if constexpr (std::is_arithmetic_v<T>) {
    return numberTypeName<T>();
  } else if constexpr (std::is_same_v<T, Angle>) {
    return "float64";
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    return "int64";
  } else if constexpr (IsText<T>::value) {
    return "string";
  } else if constexpr (kIsSequence<T>) {
    using Item = typename T::value_type;
    static_assert(!kIsSequence<Item>,
                  "a sequence of sequences or texts: wrap the inner in a struct");
    const std::string item = wireTypeName<Item>(sections);
    if constexpr (IsFixedVector<T>::value) return item + "[]";
    return item + "[" + std::to_string(sizeof(T) / sizeof(Item)) + "]";
  } else {
    addSection<T>(sections);
    return schemaName<T>();
  }
}

template <class T>
struct ScalarOf {
  using Type = T;
};
template <class T, std::size_t N>
struct ScalarOf<std::array<T, N>> {
  using Type = T;
};
template <class T, std::size_t N>
struct ScalarOf<FixedVector<T, N>> {
  using Type = T;
};

template <class T>
void addSection(SchemaSections& sections) {
  const std::string name = schemaName<T>();
  for (const auto& section : sections) {
    if (section.first == name) return;
  }
  const std::size_t mine = sections.size();
  sections.emplace_back(name, "");
  std::string text;
  forEachFieldOf<T>([&](const auto& f) {
    using Member = decltype(memberType(f));
    constexpr bool kIsAngle = std::is_same_v<typename ScalarOf<Member>::Type, Angle>;
    text += schemaLine(wireTypeName<Member>(sections), f.name,
                       rangeText(f.unit, kIsAngle, f.min, f.max));
  });
  sections[mine].second = std::move(text);
}

}  // namespace detail

template <class T>
std::string schemaText() {
  detail::SchemaSections sections;
  detail::addSection<T>(sections);
  return detail::joinSections(sections);
}

}  // namespace kelpie

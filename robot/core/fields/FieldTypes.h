// SPDX-License-Identifier: Apache-2.0
// What a member in a field list can be, decided at compile time, and the name of a struct. Shared
// by encoding, schema, comparison, range check and the parameter reader.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <type_traits>

#include "robot/core/Angle.h"
#include "robot/core/FixedVector.h"
#include "robot/core/Text.h"
#include "robot/core/Time.h"
#include "robot/core/fields/Fields.h"

namespace kelpie {

template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};

template <class T>
struct IsFixedVector : std::false_type {};
template <class T, std::size_t N>
struct IsFixedVector<FixedVector<T, N>> : std::true_type {};
template <std::size_t N>
struct IsFixedVector<Text<N>> : std::true_type {};  // of its bytes

template <class T>
struct IsText : std::false_type {};
template <std::size_t N>
struct IsText<Text<N>> : std::true_type {};

template <class T>
inline constexpr bool kIsSequence = IsArray<T>::value || IsFixedVector<T>::value;
// Numbers whose bytes in memory are those on the wire (bool is not: only 0 and 1 are bools).
template <class T>
inline constexpr bool kIsPlainNumber = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the log is little-endian, as are we");

template <class T, class = void>
struct HasTypeName : std::false_type {};
template <class T>
struct HasTypeName<T, std::void_t<decltype(T::typeName())>> : std::true_type {};

namespace detail {
template <class T>
constexpr std::string_view compilerTypeName() {
  const std::string_view text = __PRETTY_FUNCTION__;
  const std::size_t start = text.find("T = ") + 4;
  return text.substr(start, text.find_first_of("<;]", start) - start);
}
// "kelpie::body::BodyParams" -> "kelpie_body/BodyParams"; unnamed namespaces are left out.
std::string rosName(std::string_view compilerName);
}  // namespace detail

// Name of a struct as a ROS 1 message type: folder's package, then the type without its template
// arguments, so Point2<Field> and Point2<Robot> are both kelpie/Point2. A struct overrides it with
// static constexpr const char* typeName().
template <class T>
std::string schemaName() {
  if constexpr (HasTypeName<T>::value) {
    return std::string("kelpie/") + T::typeName();
  } else {
    return detail::rosName(detail::compilerTypeName<T>());
  }
}

// The shortest text that reads back as the same number, the same on every machine.
std::string numberText(double value);

}  // namespace kelpie

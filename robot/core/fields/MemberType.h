// SPDX-License-Identifier: Apache-2.0
// What a member in a field list is, as data: its kind, its size, and of a struct the rows of its
// list and a way to its members. Encoding, schema, comparison and range check walk these tables, so
// that the compiler makes one small function for each struct and not one for each struct and use.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "robot/core/fields/FieldTypes.h"

namespace kelpie {

enum class MemberKind : std::uint8_t {
  boolean,
  whole,
  real,
  enumeration,
  angle,
  time,
  array,
  vector,
  text,
  structure
};

struct MemberType;

// A line of a field list.
struct FieldRow {
  const char* name;
  const char* unit;
  double min;
  double max;
  const MemberType* type;
};

// Where the members of one struct are, in the order of its list. No visitor is called for each of
// them: the robot's stack is counted on, and functions that call each other have no end to count.
constexpr std::size_t kMaxMembers = 64;
using MemberPlaces = std::array<const void*, kMaxMembers>;

struct Items {
  const void* first;
  std::size_t count;

  const void* at(std::size_t i, std::size_t size) const {
    return static_cast<const std::uint8_t*>(first) + i * size;
  }
};

struct MemberType {
  MemberKind kind = MemberKind::structure;
  bool isSigned = false;  // whole numbers and enums
  std::size_t size = 0;   // bytes in memory

  // Of array, vector and text.
  const MemberType* item = nullptr;
  std::size_t capacity = 0;
  Items (*items)(const void* sequence) = nullptr;
  void (*resize)(void* sequence, std::size_t count) = nullptr;  // vector and text only

  // Of a structure.
  std::string_view compilerName{};
  const char* ownName = nullptr;  // its typeName(), if it has one
  const FieldRow* rows = nullptr;
  std::size_t rowCount = 0;
  void (*places)(const void* object, MemberPlaces& at) = nullptr;  // rowCount of them

  bool isSequence() const {
    return kind == MemberKind::array || kind == MemberKind::vector || kind == MemberKind::text;
  }
  // Numbers and bools: no value of them has padding or a meaning of its own.
  bool isArithmetic() const {
    return kind == MemberKind::boolean || kind == MemberKind::whole || kind == MemberKind::real;
  }
};

namespace detail {

template <class T>
constexpr MemberType describe();
template <class T>
inline constexpr MemberType kMemberType = describe<T>();

template <class T>
inline constexpr auto kFieldRows = T::fields().apply([](const auto&... f) {
  return std::array<FieldRow, sizeof...(f)>{
      FieldRow{f.name, f.unit, f.min, f.max, &kMemberType<decltype(memberType(f))>}...};
});

template <class T>
void memberPlaces(const void* of, MemberPlaces& at) {
  static constexpr auto kFields = T::fields();
  static_assert(kFieldRows<T>.size() <= kMaxMembers);
  const T& object = *static_cast<const T*>(of);
  const void** next = at.data();
  kFields.apply([&](const auto&... f) { ((*next++ = &(object.*(f.member))), ...); });
}

template <class S>
Items itemsOf(const void* at) {
  const S& sequence = *static_cast<const S*>(at);
  return {sequence.begin(), sequence.size()};
}

template <class S>
void resizeTo(void* at, std::size_t count) {
  static_cast<S*>(at)->resize(count);
}

template <class T>
constexpr MemberKind scalarKind() {
  if (std::is_same_v<T, bool>) return MemberKind::boolean;
  if (std::is_floating_point_v<T>) return MemberKind::real;
  if (std::is_enum_v<T>) return MemberKind::enumeration;
  if (std::is_same_v<T, Angle>) return MemberKind::angle;
  return std::is_same_v<T, TimeUs> ? MemberKind::time : MemberKind::whole;
}

template <class S>
constexpr void describeSequence(MemberType& type) {
  type.kind = IsText<S>::value ? MemberKind::text : MemberKind::vector;
  type.item = &kMemberType<typename S::value_type>;
  type.items = itemsOf<S>;
  if constexpr (IsFixedVector<S>::value) {
    type.capacity = S::kCapacity;
    type.resize = resizeTo<S>;
  } else {
    type.kind = MemberKind::array;
    type.capacity = std::tuple_size<S>::value;
  }
}

template <class T>
constexpr void describeStruct(MemberType& type) {
  static_assert(HasFields<T>::value, "a member of this type cannot be in a field list");
  type.compilerName = compilerTypeName<T>();
  if constexpr (HasTypeName<T>::value) type.ownName = T::typeName();
  type.rows = kFieldRows<T>.data();
  type.rowCount = kFieldRows<T>.size();
  type.places = memberPlaces<T>;
}

template <class T>
constexpr MemberType describe() {
  MemberType type{};
  type.size = sizeof(T);
  if constexpr (kIsSequence<T>) {
    describeSequence<T>(type);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, Angle> ||
                       std::is_same_v<T, TimeUs>) {
    static_assert(sizeof(T) <= 8, "long double has no place in a log");
    type.kind = scalarKind<T>();
    if constexpr (std::is_enum_v<T>) {
      type.isSigned = std::is_signed_v<std::underlying_type_t<T>>;
    } else {
      type.isSigned = std::is_signed_v<T>;
    }
  } else {
    describeStruct<T>(type);
  }
  return type;
}

}  // namespace detail

template <class T>
constexpr const MemberType& memberTypeOf() {
  return detail::kMemberType<T>;
}

}  // namespace kelpie

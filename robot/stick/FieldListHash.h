// SPDX-License-Identifier: Apache-2.0
// One number for a struct's whole field list: names, units, ranges, types and capacities, those of
// the structs within included. Two programs with the same number read each other's bytes alike.
// The log's schema text says the same, but it is made of strings, which a robot's start-up does
// without. Worked out by the compiler: as code it took 100 KB of the robot's object.
#pragma once

#include <cstdint>
#include <string_view>

#include "robot/core/Checksum.h"
#include "robot/core/fields/FieldTypes.h"

namespace kelpie::stick {

class FieldListHash {
 public:
  template <class T>
  constexpr void add() {
    if constexpr (kIsSequence<T>) {
      number(IsFixedVector<T>::value ? 2 : 1);
      number(capacityOf<T>());
      add<typename T::value_type>();
    } else if constexpr (HasFields<T>::value) {
      addFields<T>(std::make_index_sequence<decltype(T::fields())::kCount>());
      number(3);
    } else {
      number(kindOf<T>());
      number(sizeof(T));
    }
  }
  constexpr std::uint64_t value() const { return hash_.value(); }

 private:
  template <class T, std::size_t... I>
  constexpr void addFields(std::index_sequence<I...> /*unused*/) {
    constexpr auto kFields = T::fields();
    (addField(kFields.template get<I>()), ...);
  }
  template <class Struct, class Member>
  constexpr void addField(const FieldOf<Struct, Member>& f) {
    text(f.name);
    text(f.unit);
    number(__builtin_bit_cast(std::uint64_t, f.min));
    number(__builtin_bit_cast(std::uint64_t, f.max));
    add<Member>();
  }
  template <class T>
  static constexpr std::size_t capacityOf() {
    if constexpr (IsFixedVector<T>::value) {
      return T::kCapacity;
    } else {
      return std::tuple_size<T>::value;
    }
  }
  template <class T>
  static constexpr std::uint64_t kindOf() {
    if (std::is_same_v<T, bool>) return 4;
    if (std::is_floating_point_v<T>) return 5;
    if (std::is_enum_v<T>) return 6;
    if (std::is_same_v<T, Angle>) return 7;
    if (std::is_same_v<T, TimeUs>) return 8;
    return std::is_signed_v<T> ? 9 : 10;
  }
  constexpr void number(std::uint64_t value) {
    for (unsigned shift = 0; shift < 64; shift += 8)
      hash_.add(static_cast<std::uint8_t>(value >> shift));
  }
  constexpr void text(std::string_view words) {
    for (const char c : words) hash_.add(static_cast<std::uint8_t>(c));
    hash_.add(std::uint8_t{0});
  }

  Fnv1a hash_;
};

template <class T>
constexpr std::uint64_t fieldListHash() {
  FieldListHash hash;
  hash.add<T>();
  return hash.value();
}

}  // namespace kelpie::stick

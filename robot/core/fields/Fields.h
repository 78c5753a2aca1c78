// SPDX-License-Identifier: Apache-2.0
// One field list per struct: name, member, unit and range, in ordinary templates. The list feeds
// the log's schema and encoding, the parameter reader, the Python view, range checks, the replay
// comparison and the viewer, so that a struct is described once.
//
//   struct Odometry {
//     double forward = 0.0;
//     template <int = 0>
//     static constexpr auto fields() {
//       return fieldList(field("forward", &Odometry::forward, "cm", -20, 20));
//     }
//   };
//
// fields() is a template, so that a list is compiled where somebody asks for it, and not wherever
// its struct is seen.
//
// A member may be a number, bool, enum with a fixed type, Angle, TimeUs, std::array, FixedVector,
// Text or a struct with a list of its own. Absent is a bool named `present`, never a magic number.
// The range limits each scalar inside the member; Angle ranges are given in degrees.
#pragma once

#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace kelpie {

template <class Struct, class Member>
struct FieldOf {
  const char* name;
  Member Struct::*member;
  const char* unit;
  double min;
  double max;
};

template <class Struct, class Member>
constexpr FieldOf<Struct, Member> field(const char* name, Member Struct::*member,
                                        const char* unit = "",
                                        double min = -std::numeric_limits<double>::infinity(),
                                        double max = std::numeric_limits<double>::infinity()) {
  return {name, member, unit, min, max};
}

namespace detail {
template <std::size_t I, class Field>
struct FieldAt {
  Field field;
};
template <class Indices, class... Fields>
struct FieldsAt;
template <std::size_t... I, class... Fields>
struct FieldsAt<std::index_sequence<I...>, Fields...> : FieldAt<I, Fields>... {};

template <std::size_t I, class Field>
constexpr const Field& fieldAt(const FieldAt<I, Field>& at) {
  return at.field;
}
}  // namespace detail

// What fields() returns. A std::tuple would do, but the choice among its constructors, which are
// made to convert, is most of what the compiler then does with a long list.
template <class... Fields>
struct FieldList : detail::FieldsAt<std::index_sequence_for<Fields...>, Fields...> {
  static constexpr std::size_t kCount = sizeof...(Fields);

  template <std::size_t I>
  constexpr const auto& get() const {
    return detail::fieldAt<I>(*this);
  }
  // f of all fields at once.
  template <class F>
  constexpr auto apply(F&& f) const {
    return applyAt(f, std::index_sequence_for<Fields...>());
  }

 private:
  template <class F, std::size_t... I>
  constexpr auto applyAt(F&& f, std::index_sequence<I...> /*unused*/) const {
    return f(static_cast<const detail::FieldAt<I, Fields>&>(*this).field...);
  }
};

template <class... Fields>
constexpr FieldList<Fields...> fieldList(Fields... fields) {
  return {{{fields}...}};
}

template <class T, class = void>
struct HasFields : std::false_type {};
template <class T>
struct HasFields<T, std::void_t<decltype(T::fields())>> : std::true_type {};

// Calls f(field, object.member) for every field in order. Object may be const.
template <class Struct, class F>
void forEachField(Struct& object, F&& f) {
  std::remove_const_t<Struct>::fields().apply(
      [&](const auto&... fs) { (f(fs, object.*(fs.member)), ...); });
}

// Calls f(field) for every field of the type, without an object.
template <class Struct, class F>
void forEachFieldOf(F&& f) {
  Struct::fields().apply([&](const auto&... fs) { (f(fs), ...); });
}

template <class Struct, class Member>
Member memberType(const FieldOf<Struct, Member>&);  // for decltype only

}  // namespace kelpie

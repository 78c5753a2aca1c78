// SPDX-License-Identifier: Apache-2.0
// Reads field lists out of bytes in memory, straight into the structs that they are for, with
// neither heap nor a large stack. It trusts nothing: an end that comes early, lengths over a
// capacity, bools and enums that do not exist, and numbers beyond their range are faults; the first
// one stays.
#pragma once

#include <cmath>
#include <cstring>

#include "robot/core/fields/Encoding.h"
#include "robot/stick/StickFault.h"

namespace kelpie::stick {

class FieldReader {
 public:
  FieldReader(const std::uint8_t* bytes, std::size_t count) : at_(bytes), left_(count) {}

  StickFault fault() const { return fault_; }
  bool atEnd() const { return left_ == 0; }

  bool take(void* to, std::size_t count) {
    if (count > left_) return fail(StickFault::cutShort);
    std::memcpy(to, at_, count);
    at_ += count;
    left_ -= count;
    return true;
  }

  // min and max: the range of the field.
  template <class T>
  bool get(T& value, double min, double max) {
    if constexpr (kIsSequence<T>) {
      return getSequence(value, min, max);
    } else if constexpr (HasFields<T>::value) {
      return getStruct(value);
    } else {
      return getScalar(value, min, max);
    }
  }
  template <class T>
  bool getStruct(T& value) {
    return getFields(value, std::make_index_sequence<decltype(T::fields())::kCount>());
  }

 private:
  // The list as a constant: its names and the building of it leave the program (145 KB less).
  template <class T, std::size_t... I>
  bool getFields(T& value, std::index_sequence<I...> /*unused*/) {
    constexpr auto kFields = T::fields();
    return (get(value.*(kFields.template get<I>().member), kFields.template get<I>().min,
                kFields.template get<I>().max) &&
            ...);
  }
  template <class T>
  bool getScalar(T& value, double min, double max) {
    std::uint8_t bytes[8];
    if (!take(bytes, sizeof value)) return false;
    if (!kelpie::detail::decodeScalar(memberTypeOf<T>(), bytes, sizeof value, min, max, &value))
      return fail(StickFault::undecodable);
    return checkRange(value, min, max);
  }
  template <class S>
  bool getSequence(S& items, double min, double max) {
    if constexpr (IsFixedVector<S>::value) {
      std::uint32_t count = 0;
      if (!take(&count, sizeof count)) return false;
      if (count > S::kCapacity) return fail(StickFault::undecodable);
      items.resize(count);
    }
    using Item = typename S::value_type;
    if constexpr (kIsPlainNumber<Item>) {
      return take(items.begin(), items.size() * sizeof(Item)) && checkItems(items, min, max);
    } else {
      for (auto& item : items)
        if (!get(item, min, max)) return false;
      return true;
    }
  }
  template <class S>
  bool checkItems(const S& items, double min, double max) {
    // Bytes without a range (tables) cannot be wrong.
    if (std::is_integral_v<typename S::value_type> && !std::isfinite(min) && !std::isfinite(max))
      return true;
    for (const auto& item : items)
      if (!checkRange(item, min, max)) return false;
    return true;
  }
  template <class T>
  bool checkRange(const T& value, double min, double max) {
    // A hash has no range; and a double of it wants __floatundidf, younger than the SDK's compiler.
    if constexpr (std::is_same_v<T, std::uint64_t>) return true;
    double number = 0.0;
    // Degrees are rounded when made from radians, as in robot/core/fields/FieldCheck.h.
    constexpr double kSlack = std::is_same_v<T, Angle> ? 1e-9 : 0.0;
    if constexpr (std::is_same_v<T, Angle>) {
      number = value.deg();
    } else if constexpr (std::is_same_v<T, TimeUs>) {
      number = static_cast<double>(value.us);
    } else {
      number = static_cast<double>(value);
    }
    const bool inside = std::isfinite(number) && number >= min - kSlack && number <= max + kSlack;
    return inside || fail(StickFault::outOfRange);
  }
  // Keeps the first fault; always false.
  bool fail(StickFault fault) {
    if (fault_ == StickFault::none) fault_ = fault;
    return false;
  }

  const std::uint8_t* at_;
  std::size_t left_;
  StickFault fault_ = StickFault::none;
};

}  // namespace kelpie::stick

// SPDX-License-Identifier: Apache-2.0
// Reads an open file in pieces of 4 KB through one buffer of its own, straight into the structs it
// is for, and keeps the checksums of what was taken. Neither heap nor large stack: a table of 100
// KB goes from the buffer into its place. It trusts nothing: an end that comes early, lengths over
// a capacity, bools and enums that do not exist, and numbers beyond their range are faults; the
// first one stays.
#pragma once

#include <cmath>
#include <cstring>

#include "robot/core/Checksum.h"
#include "robot/core/Encoding.h"
#include "robot/stick/StickFault.h"
#include "robot/stick/StickFiles.h"

namespace kelpie::stick {

class PieceReader {
 public:
  static constexpr std::size_t kPieceBytes = 4096;

  explicit PieceReader(StickFiles& files) : files_(files) {}

  // False, with the fault: there is no such file.
  bool open(const char* path);
  StickFault fault() const { return fault_; }

  bool take(void* to, std::size_t count);
  bool skip(std::uint32_t count);
  // Nothing left; else the fault is tooLong.
  bool atEnd();
  // Reads to the end of the file, whose length must be that.
  bool skipAll(std::uint32_t length) { return skip(length) && atEnd(); }

  // Since open(), and since the last startPart().
  std::uint64_t hash() const { return hash_.value(); }
  std::uint32_t crc() const { return crc_.value(); }
  std::uint32_t partBytes() const { return partBytes_; }
  void startPart();

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
    return getFields(value, std::make_index_sequence<std::tuple_size_v<decltype(T::fields())>>());
  }

 private:
  // The list as a constant: its names and the building of it leave the program (145 KB less).
  template <class T, std::size_t... I>
  bool getFields(T& value, std::index_sequence<I...> /*unused*/) {
    constexpr auto kFields = T::fields();
    return (get(value.*(std::get<I>(kFields).member), std::get<I>(kFields).min,
                std::get<I>(kFields).max) &&
            ...);
  }
  template <class T>
  bool getScalar(T& value, double min, double max) {
    std::uint8_t bytes[8];
    const std::size_t size = encodedSize(value);
    if (!take(bytes, size)) return false;
    if (!kelpie::detail::WireReader(bytes, size).get(value, min, max))
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
    // Degrees are rounded when made from radians, as in robot/core/FieldCheck.h.
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
  bool refill();
  // Keeps the first fault; always false.
  bool fail(StickFault fault);

  StickFiles& files_;
  std::array<std::uint8_t, kPieceBytes> piece_{};
  std::size_t at_ = 0;
  std::size_t filled_ = 0;
  std::uint32_t partBytes_ = 0;
  Crc32 crc_;
  Fnv1a hash_;
  StickFault fault_ = StickFault::none;
};

}  // namespace kelpie::stick

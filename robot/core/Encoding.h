// SPDX-License-Identifier: Apache-2.0
// The ROS 1 wire encoding of every struct with a field list: little-endian without padding, fields
// in the order of the list. bool = one byte 0 or 1, enum = its fixed type, Angle = float64 rad,
// TimeUs = int64, std::array = its elements, FixedVector = uint32 length and elements, Text = the
// same of its bytes. Used by the log and by the simulated world's protocol. decode() trusts
// nothing: it refuses data that end early or late, lengths over the capacity, bools and enums that
// do not exist.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "robot/core/FieldCheck.h"
#include "robot/core/FieldTypes.h"
#include "robot/core/Schema.h"

namespace kelpie {

// Bytes that encode() appends for this value.
template <class T>
std::size_t encodedSize(const T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    return sizeof(T);
  } else if constexpr (std::is_same_v<T, Angle> || std::is_same_v<T, TimeUs>) {
    return 8;
  } else if constexpr (kIsSequence<T>) {
    std::size_t size = IsFixedVector<T>::value ? 4 : 0;
    if constexpr (std::is_arithmetic_v<typename T::value_type>) {
      return size + value.size() * sizeof(typename T::value_type);
    } else {
      for (const auto& item : value) size += encodedSize(item);
      return size;
    }
  } else {
    static_assert(HasFields<T>::value, "a member of this type cannot be in a field list");
    std::size_t size = 0;
    forEachField(value, [&](const auto&, const auto& member) { size += encodedSize(member); });
    return size;
  }
}

namespace detail {

class WireWriter {
 public:
  explicit WireWriter(std::uint8_t* at) : at_(at) {}

  template <class T>
  void put(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      *at_++ = value ? 1 : 0;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      bytes(&value, sizeof value);
    } else if constexpr (std::is_same_v<T, Angle>) {
      put(value.rad());
    } else if constexpr (std::is_same_v<T, TimeUs>) {
      put(value.us);
    } else if constexpr (kIsSequence<T>) {
      sequence(value);
    } else {
      forEachField(value, [&](const auto&, const auto& member) { put(member); });
    }
  }

 private:
  template <class S>
  void sequence(const S& items) {
    if constexpr (IsFixedVector<S>::value) put(static_cast<std::uint32_t>(items.size()));
    if constexpr (kIsPlainNumber<typename S::value_type>) {
      if (items.size() > 0) bytes(items.begin(), items.size() * sizeof(typename S::value_type));
    } else {
      for (const auto& item : items) put(item);
    }
  }
  void bytes(const void* from, std::size_t count) {
    std::memcpy(at_, from, count);
    at_ += count;
  }

  std::uint8_t* at_;
};

// Every get() returns false when the data do not fit; the reader is of no use after that.
class WireReader {
 public:
  WireReader(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}
  bool atEnd() const { return left_ == 0; }

  // min and max: the range of the field, for enums.
  template <class T>
  bool get(T& value, double min, double max) {
    if constexpr (std::is_same_v<T, bool>) {
      return getBool(value);
    } else if constexpr (std::is_arithmetic_v<T>) {
      return bytes(&value, sizeof value);
    } else if constexpr (std::is_enum_v<T>) {
      return getEnum(value, min, max);
    } else if constexpr (std::is_same_v<T, Angle>) {
      double radians = 0.0;
      if (!bytes(&radians, sizeof radians)) return false;
      value = Angle::rad(radians);
      return true;
    } else if constexpr (std::is_same_v<T, TimeUs>) {
      return bytes(&value.us, sizeof value.us);
    } else if constexpr (kIsSequence<T>) {
      return getSequence(value, min, max);
    } else {
      return getStruct(value);
    }
  }

  template <class T>
  bool getStruct(T& value) {
    bool good = true;
    forEachField(value, [&](const auto& f, auto& member) {
      if (good) good = get(member, f.min, f.max);
    });
    return good;
  }

 private:
  bool getBool(bool& value) {
    std::uint8_t byte = 0;
    if (!bytes(&byte, 1) || byte > 1) return false;
    value = byte == 1;
    return true;
  }
  template <class T>
  bool getEnum(T& value, double min, double max) {
    std::underlying_type_t<T> number{};
    if (!bytes(&number, sizeof number)) return false;
    const auto asDouble = static_cast<double>(number);
    value = static_cast<T>(number);
    return asDouble >= min && asDouble <= max;
  }
  template <class S>
  bool getSequence(S& items, double min, double max) {
    if constexpr (IsFixedVector<S>::value) {
      std::uint32_t count = 0;
      if (!bytes(&count, sizeof count) || count > S::kCapacity) return false;
      items.resize(count);
    }
    if constexpr (kIsPlainNumber<typename S::value_type>) {
      return bytes(items.begin(), items.size() * sizeof(typename S::value_type));
    } else {
      for (auto& item : items) {
        if (!get(item, min, max)) return false;
      }
      return true;
    }
  }
  bool bytes(void* to, std::size_t count) {
    if (count > left_) return false;
    if (count > 0) std::memcpy(to, at_, count);
    at_ += count;
    left_ -= count;
    return true;
  }

  const std::uint8_t* at_;
  std::size_t left_;
};

}  // namespace detail

// Writes the encoded value where encodedSize(value) bytes are free.
template <class T>
void encodeTo(const T& value, std::uint8_t* at) {
  detail::WireWriter(at).put(value);
}

// Appends the encoded value.
template <class T>
void encode(const T& value, std::vector<std::uint8_t>& out) {
  const std::size_t before = out.size();
  out.resize(before + encodedSize(value));
  encodeTo(value, out.data() + before);
}

// False when the bytes are not exactly one T; `out` then holds nothing of use.
template <class T>
bool decode(const std::uint8_t* data, std::size_t size, T& out) {
  detail::WireReader reader(data, size);
  return reader.getStruct(out) && reader.atEnd();
}

}  // namespace kelpie

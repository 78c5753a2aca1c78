// SPDX-License-Identifier: Apache-2.0
#include "robot/core/fields/Encoding.h"

#include <cstring>

namespace kelpie::detail {
namespace {

constexpr std::size_t kLengthBytes = 4;

// Numbers whose bytes in memory are those on the wire (bool is not: only 0 and 1 are bools).
bool isPlainNumber(const MemberType& type) {
  return type.kind == MemberKind::whole || type.kind == MemberKind::real;
}

std::size_t sequenceSize(const MemberType& type, const void* value) {
  const Items items = type.items(value);
  std::size_t size = type.kind == MemberKind::array ? 0 : kLengthBytes;
  if (type.item->isArithmetic()) return size + items.count * type.item->size;
  for (std::size_t i = 0; i < items.count; ++i)
    size += encodedSize(*type.item, items.at(i, type.item->size));
  return size;
}

class WireWriter {
 public:
  explicit WireWriter(std::uint8_t* at) : at_(at) {}

  // Structs are walked in this function itself, so that only one calls itself on the robot.
  void put(const MemberType& type, const void* value) {
    if (type.kind == MemberKind::structure) {
      MemberPlaces at;
      type.places(value, at);
      for (std::size_t i = 0; i < type.rowCount; ++i) put(*type.rows[i].type, at[i]);
    } else if (type.isSequence()) {
      sequence(type, value);
    } else {
      scalar(type, value);
    }
  }

 private:
  void scalar(const MemberType& type, const void* value) {
    switch (type.kind) {
      case MemberKind::boolean: *at_++ = *static_cast<const bool*>(value) ? 1 : 0; return;
      case MemberKind::angle: number(static_cast<const Angle*>(value)->rad()); return;
      case MemberKind::time: number(static_cast<const TimeUs*>(value)->us); return;
      default: bytes(value, type.size);
    }
  }
  void sequence(const MemberType& type, const void* value) {
    const Items items = type.items(value);
    if (type.kind != MemberKind::array) number(static_cast<std::uint32_t>(items.count));
    if (isPlainNumber(*type.item)) {
      if (items.count > 0) bytes(items.first, items.count * type.item->size);
      return;
    }
    for (std::size_t i = 0; i < items.count; ++i) put(*type.item, items.at(i, type.item->size));
  }
  template <class T>
  void number(T value) {
    bytes(&value, sizeof value);
  }
  void bytes(const void* from, std::size_t count) {
    std::memcpy(at_, from, count);
    at_ += count;
  }

  std::uint8_t* at_;
};

// Every get() returns false when the data do not fit; the reader is of no use after that. The
// values that it writes belong to whoever decodes: the places of members are of constants only
// because writers have them by the same way.
class WireReader {
 public:
  WireReader(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}
  bool atEnd() const { return left_ == 0; }
  // min and max: the range of the field, for enums.
  bool get(const MemberType& type, void* value, double min, double max) {
    switch (type.kind) {
      case MemberKind::boolean: return getBool(*static_cast<bool*>(value));
      case MemberKind::enumeration: return getEnum(type, value, min, max);
      case MemberKind::angle: return getAngle(*static_cast<Angle*>(value));
      case MemberKind::time: return bytes(&static_cast<TimeUs*>(value)->us, sizeof(std::int64_t));
      case MemberKind::structure: return getMembers(type, value);
      case MemberKind::array:
      case MemberKind::vector:
      case MemberKind::text: return getSequence(type, value, min, max);
      default: return bytes(value, type.size);
    }
  }

 private:
  bool getMembers(const MemberType& type, void* value) {
    MemberPlaces at;
    type.places(value, at);
    for (std::size_t i = 0; i < type.rowCount; ++i) {
      const FieldRow& row = type.rows[i];
      if (!get(*row.type, const_cast<void*>(at[i]), row.min, row.max)) return false;
    }
    return true;
  }
  bool getBool(bool& value) {
    std::uint8_t byte = 0;
    if (!bytes(&byte, 1) || byte > 1) return false;
    value = byte == 1;
    return true;
  }
  bool getAngle(Angle& value) {
    double radians = 0.0;
    if (!bytes(&radians, sizeof radians)) return false;
    value = Angle::rad(radians);
    return true;
  }
  bool getEnum(const MemberType& type, void* value, double min, double max) {
    if (!bytes(value, type.size)) return false;
    const double number = numberOf(type, value);
    return number >= min && number <= max;
  }
  bool getSequence(const MemberType& type, void* value, double min, double max) {
    if (type.kind != MemberKind::array) {
      std::uint32_t count = 0;
      if (!bytes(&count, sizeof count) || count > type.capacity) return false;
      type.resize(value, count);
    }
    const Items items = type.items(value);
    if (isPlainNumber(*type.item))
      return bytes(const_cast<void*>(items.first), items.count * type.item->size);
    for (std::size_t i = 0; i < items.count; ++i)
      if (!get(*type.item, const_cast<void*>(items.at(i, type.item->size)), min, max)) return false;
    return true;
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

}  // namespace

std::size_t encodedSize(const MemberType& type, const void* value) {
  if (type.isSequence()) return sequenceSize(type, value);
  if (type.kind != MemberKind::structure) return type.size;
  MemberPlaces at;
  type.places(value, at);
  std::size_t size = 0;
  for (std::size_t i = 0; i < type.rowCount; ++i) size += encodedSize(*type.rows[i].type, at[i]);
  return size;
}

void encodeTo(const MemberType& type, const void* value, std::uint8_t* at) {
  WireWriter(at).put(type, value);
}

void encode(const MemberType& type, const void* value, std::vector<std::uint8_t>& out) {
  const std::size_t before = out.size();
  out.resize(before + encodedSize(type, value));
  encodeTo(type, value, out.data() + before);
}

bool decode(const MemberType& type, const std::uint8_t* data, std::size_t size, void* out) {
  WireReader reader(data, size);
  return reader.get(type, out, 0.0, 0.0) && reader.atEnd();
}

bool decodeScalar(const MemberType& type, const std::uint8_t* data, std::size_t size, double min,
                  double max, void* out) {
  return WireReader(data, size).get(type, out, min, max);
}

}  // namespace kelpie::detail

// SPDX-License-Identifier: Apache-2.0
#include "robot/core/fields/FieldCheck.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace kelpie::detail {
namespace {

// Each step writes its part of the path in front of what is there, from the inside out.
void prependName(const char* name, std::string* path) {
  const bool needsDot = !path->empty() && path->front() != '[' && path->front() != ':';
  *path = name + std::string(needsDot ? "." : "") + *path;
}

void prependIndex(std::size_t index, std::string* path) {
  const bool needsDot = !path->empty() && path->front() != ':';
  *path = '[' + std::to_string(index) + ']' + (needsDot ? "." : "") + *path;
}

std::string outsideText(double value, double min, double max, const std::string& unit) {
  const std::string shown = numberText(value) + (unit.empty() ? "" : ' ' + unit);
  if (!std::isfinite(value)) return ": " + shown + " is not finite";
  std::string range = std::isfinite(min) ? numberText(min) : "";
  range += "..";
  if (std::isfinite(max)) range += numberText(max);
  return ": " + shown + " is outside " + range;
}

template <class T>
T readAs(const void* at) {
  T value{};
  std::memcpy(&value, at, sizeof value);
  return value;
}

std::int64_t signedAt(const void* at, std::size_t size) {
  if (size == 1) return readAs<std::int8_t>(at);
  if (size == 2) return readAs<std::int16_t>(at);
  return size == 4 ? readAs<std::int32_t>(at) : readAs<std::int64_t>(at);
}

std::uint64_t unsignedAt(const void* at, std::size_t size) {
  if (size == 1) return readAs<std::uint8_t>(at);
  if (size == 2) return readAs<std::uint16_t>(at);
  return size == 4 ? readAs<std::uint32_t>(at) : readAs<std::uint64_t>(at);
}

std::string scalarText(const MemberType& type, const void* value) {
  if (type.kind == MemberKind::real || type.kind == MemberKind::angle)
    return numberText(numberOf(type, value));
  if (type.isSigned || type.kind == MemberKind::time)
    return std::to_string(signedAt(value, type.size));
  return std::to_string(unsignedAt(value, type.size));
}

std::string_view wordsOf(const Items& text) {
  return {static_cast<const char*>(text.first), text.count};
}

bool differs(const MemberType& type, const void* a, const void* b, std::string* path);

bool sequenceDiffers(const MemberType& type, const void* a, const void* b, std::string* path) {
  const Items as = type.items(a), bs = type.items(b);
  if (type.kind == MemberKind::text) {
    if (wordsOf(as) == wordsOf(bs)) return false;
    *path = ": \"" + std::string(wordsOf(as)) + "\" != \"" + std::string(wordsOf(bs)) + '"';
    return true;
  }
  if (as.count != bs.count) {
    *path = ": " + std::to_string(as.count) + " elements != " + std::to_string(bs.count);
    return true;
  }
  const std::size_t bytes = as.count * type.item->size;
  if (bytes == 0) return false;
  if (type.item->isArithmetic() && std::memcmp(as.first, bs.first, bytes) == 0) return false;
  for (std::size_t i = 0; i < as.count; ++i) {
    const std::size_t size = type.item->size;
    if (!differs(*type.item, as.at(i, size), bs.at(i, size), path)) continue;
    prependIndex(i, path);
    return true;
  }
  return false;
}

bool membersDiffer(const MemberType& type, const void* a, const void* b, std::string* path) {
  MemberPlaces as, bs;
  type.places(a, as);
  type.places(b, bs);
  for (std::size_t i = 0; i < type.rowCount; ++i) {
    if (!differs(*type.rows[i].type, as[i], bs[i], path)) continue;
    prependName(type.rows[i].name, path);
    return true;
  }
  return false;
}

bool differs(const MemberType& type, const void* a, const void* b, std::string* path) {
  if (type.isSequence()) return sequenceDiffers(type, a, b, path);
  if (type.kind == MemberKind::structure) return membersDiffer(type, a, b, path);
  if (std::memcmp(a, b, type.size) == 0) return false;
  *path = ": " + scalarText(type, a) + " != " + scalarText(type, b);
  return true;
}

bool inRange(const FieldRow& row, const MemberType& type, const void* value, std::string* why);

bool scalarInRange(const FieldRow& row, const MemberType& type, const void* value,
                   std::string* why) {
  const bool isAngle = type.kind == MemberKind::angle;
  const double number = isAngle ? static_cast<const Angle*>(value)->deg() : numberOf(type, value);
  // Degrees are rounded when made from radians: a limit itself may come out 3e-14 beyond it.
  const double slack = isAngle ? 1e-9 : 0.0;
  if (std::isfinite(number) && number >= row.min - slack && number <= row.max + slack) return true;
  *why = outsideText(number, row.min, row.max, isAngle ? "deg" : row.unit);
  return false;
}

bool sequenceInRange(const FieldRow& row, const MemberType& type, const void* value,
                     std::string* why) {
  // Bytes without a range (images) cannot be wrong.
  const bool integral = type.item->isArithmetic() && type.item->kind != MemberKind::real;
  if (integral && !std::isfinite(row.min) && !std::isfinite(row.max)) return true;
  const Items items = type.items(value);
  for (std::size_t i = 0; i < items.count; ++i) {
    if (inRange(row, *type.item, items.at(i, type.item->size), why)) continue;
    prependIndex(i, why);
    return false;
  }
  return true;
}

bool membersInRange(const MemberType& type, const void* value, std::string* why) {
  MemberPlaces at;
  type.places(value, at);
  for (std::size_t i = 0; i < type.rowCount; ++i) {
    if (inRange(type.rows[i], *type.rows[i].type, at[i], why)) continue;
    prependName(type.rows[i].name, why);
    return false;
  }
  return true;
}

bool inRange(const FieldRow& row, const MemberType& type, const void* value, std::string* why) {
  if (type.isSequence()) return sequenceInRange(row, type, value, why);
  if (type.kind != MemberKind::structure) return scalarInRange(row, type, value, why);
  return membersInRange(type, value, why);
}

}  // namespace

double numberOf(const MemberType& type, const void* value) {
  if (type.kind == MemberKind::angle) return static_cast<const Angle*>(value)->rad();
  if (type.kind == MemberKind::real)
    return type.size == 4 ? static_cast<double>(readAs<float>(value)) : readAs<double>(value);
  if (type.isSigned || type.kind == MemberKind::time)
    return static_cast<double>(signedAt(value, type.size));
  // By halves, since the SDK's compiler has no __floatundidf; the product is exact, the sum rounded
  // once.
  const std::uint64_t whole = unsignedAt(value, type.size);
  constexpr double kHalf = 4294967296.0;
  return static_cast<double>(static_cast<std::uint32_t>(whole >> 32)) * kHalf +
         static_cast<double>(static_cast<std::uint32_t>(whole));
}

bool firstDifference(const MemberType& type, const void* a, const void* b, std::string* path) {
  std::string text;
  if (!differs(type, a, b, &text)) return false;
  if (path != nullptr) *path = text;
  return true;
}

bool verify(const MemberType& type, const void* value, std::string* why) {
  std::string text;
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  if (inRange(FieldRow{"", "", -kEnd, kEnd, &type}, type, value, &text)) return true;
  if (why != nullptr) *why = text;
  return false;
}

}  // namespace kelpie::detail

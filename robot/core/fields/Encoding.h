// SPDX-License-Identifier: Apache-2.0
// The ROS 1 wire encoding of every struct with a field list: little-endian without padding, fields
// in the order of the list. bool = one byte 0 or 1, enum = its fixed type, Angle = float64 rad,
// TimeUs = int64, std::array = its elements, FixedVector = uint32 length and elements, Text = the
// same of its bytes. Used by the log and by the simulated world's protocol. decode() trusts
// nothing: it refuses data that end early or late, lengths over the capacity, bools and enums that
// do not exist.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/core/fields/FieldCheck.h"
#include "robot/core/fields/MemberType.h"
#include "robot/core/fields/Schema.h"

namespace kelpie {

namespace detail {

std::size_t encodedSize(const MemberType& type, const void* value);
void encodeTo(const MemberType& type, const void* value, std::uint8_t* at);
void encode(const MemberType& type, const void* value, std::vector<std::uint8_t>& out);
bool decode(const MemberType& type, const std::uint8_t* data, std::size_t size, void* out);
// Of a number, bool, enum, Angle or TimeUs; min and max: the range of the field, for enums.
bool decodeScalar(const MemberType& type, const std::uint8_t* data, std::size_t size, double min,
                  double max, void* out);

}  // namespace detail

// Bytes that encode() appends for this value.
template <class T>
std::size_t encodedSize(const T& value) {
  return detail::encodedSize(memberTypeOf<T>(), &value);
}

// Writes the encoded value where encodedSize(value) bytes are free.
template <class T>
void encodeTo(const T& value, std::uint8_t* at) {
  detail::encodeTo(memberTypeOf<T>(), &value, at);
}

// Appends the encoded value.
template <class T>
void encode(const T& value, std::vector<std::uint8_t>& out) {
  detail::encode(memberTypeOf<T>(), &value, out);
}

// False when the bytes are not exactly one T; `out` then holds nothing of use.
template <class T>
bool decode(const std::uint8_t* data, std::size_t size, T& out) {
  return detail::decode(memberTypeOf<T>(), data, size, &out);
}

}  // namespace kelpie

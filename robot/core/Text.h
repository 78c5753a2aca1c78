// SPDX-License-Identifier: Apache-2.0
// A short text in a frame struct: at most Capacity bytes of UTF-8, no heap. On the wire a ROS 1
// string. What is longer is cut off before the character that does not fit whole.
#pragma once

#include <cstdint>
#include <string_view>

#include "robot/core/FieldTypes.h"
#include "robot/core/FixedVector.h"

namespace kelpie {

template <std::size_t Capacity>
class Text : public FixedVector<std::uint8_t, Capacity> {
 public:
  Text() = default;
  explicit Text(std::string_view text) { assign(text); }

  void assign(std::string_view text) {
    std::size_t size = text.size();
    if (size > Capacity) {
      size = Capacity;
      while (size > 0 && (static_cast<std::uint8_t>(text[size]) & 0xC0U) == 0x80U) --size;
    }
    this->clear();
    for (const char c : text.substr(0, size)) this->push_back(static_cast<std::uint8_t>(c));
  }
  std::string_view view() const {
    return {reinterpret_cast<const char*>(this->begin()), this->size()};
  }
};

template <std::size_t N>
struct IsFixedVector<Text<N>> : std::true_type {};

template <class T>
struct IsText : std::false_type {};
template <std::size_t N>
struct IsText<Text<N>> : std::true_type {};

}  // namespace kelpie

// SPDX-License-Identifier: Apache-2.0
// A short text in a frame struct: at most Capacity bytes of UTF-8, no heap. On the wire a ROS 1
// string. What is longer is cut off before the character that does not fit whole. What came from
// outside, a log's, may be no UTF-8: whoever shows it must stand that.
#pragma once

#include <cstring>
#include <string_view>

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
    this->resize(size);
    if (size > 0) std::memcpy(this->begin(), text.data(), size);
  }
  std::string_view view() const {
    return {reinterpret_cast<const char*>(this->begin()), this->size()};
  }
};

}  // namespace kelpie

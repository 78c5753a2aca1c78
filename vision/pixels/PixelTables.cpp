// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/PixelTables.h"

namespace kelpie::vision {

RingByValue::RingByValue(const RingTable& table) : centre(table.centre) {
  for (std::size_t value = 0; value < kByteValues; ++value) {
    for (std::size_t d = 0; d < kRingDistances; ++d) {
      const std::size_t at = kStride * value + d;
      cells[at] = table.y[kByteValues * d + value];
      cells[at + kCr] = table.cr[kByteValues * d + value];
      cells[at + kCb] = table.cb[kByteValues * d + value];
    }
  }
}

}  // namespace kelpie::vision

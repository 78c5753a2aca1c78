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

void PixelTables::relight(const ChannelBytes& bytes, std::size_t part) {
  constexpr std::size_t kValues = kByteValues / kTableParts;
  for (std::size_t value = part * kValues; value < (part + 1) * kValues; ++value) {
    const std::uint8_t* const from = calibrated.cells.data() + RingByValue::kStride * value;
    std::uint8_t* const to = ring.cells.data() + RingByValue::kStride * value;
    for (std::size_t i = 0; i < RingByValue::kCr; ++i) to[i] = bytes.y[from[i]];
    for (std::size_t i = RingByValue::kCr; i < 3 * kRingDistances; ++i)
      to[i] = bytes.chroma[from[i]];
  }
}

}  // namespace kelpie::vision

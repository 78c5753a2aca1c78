// SPDX-License-Identifier: Apache-2.0
// The calibration as a pixel is looked up in it: the colour table, the ring table turned over, and
// the distances of all pixels from the ring's centres. Made once, at start-up; the ring table again
// where the light changed.
#pragma once

#include "vision/colour/RingTable.h"
#include "vision/colour/VisionCalibration.h"

namespace kelpie::vision {

// The ring table by value first, the three channels of a value side by side. The pixels of a row
// have nearly the same values at a hundred distances: by distance first, each row of the image read
// 450 cache lines of the table and put out what the next one would read, by value first it reads a
// quarter of them.
struct RingByValue {
  static constexpr std::size_t kStride = 512;  // of a value; three channels have 447
  static constexpr std::size_t kCr = kRingDistances;
  static constexpr std::size_t kCb = 2 * kRingDistances;
  static_assert(3 * kRingDistances <= kStride);

  explicit RingByValue(const RingTable& table);

  Yuv operator()(Yuv raw, RingPlace at) const {
    return {cells[kStride * raw.y + at.y], cells[kStride * raw.cr + kCr + at.cr],
            cells[kStride * raw.cb + kCb + at.cb]};
  }

  std::array<std::uint8_t, kByteValues * kStride> cells{};
  std::array<RingCentre, 3> centre{};
};

// What each value of Y, and of Cr and Cb, becomes.
struct ChannelBytes {
  std::array<std::uint8_t, kByteValues> y{};
  std::array<std::uint8_t, kByteValues> chroma{};
};

// The ring table is made anew by as many parts, one an image, so that none pays for all of it.
constexpr std::size_t kTableParts = 4;

struct PixelTables {
  explicit PixelTables(const VisionCalibration& calibration)
      : colour(calibration.colour), ring(calibration.ring), calibrated(ring) {}

  // That part of the ring table again, its corrected values changed.
  void relight(const ChannelBytes& bytes, std::size_t part);

  ColourTable colour;
  RingByValue ring;
  RingDistances distances;
  RingByValue calibrated;  // the ring table as it was measured
};

}  // namespace kelpie::vision

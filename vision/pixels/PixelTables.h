// SPDX-License-Identifier: Apache-2.0
// The calibration as a pixel is looked up in it: the colour table, the ring table turned over, and
// the distances of all pixels from the ring's centres. Made once, at start-up; the ring table again
// where the light changed.
#pragma once

#include "robot/core/types/CameraLight.h"
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

// Pixels are divided by what the light is over that which the colour table was made for. The
// division is in the ring table, so a pixel costs what it did.
class PixelTables {
 public:
  explicit PixelTables(const VisionCalibration& calibration);

  // Makes those parts of the ring table anew that are of another light than this one says, and
  // takes the colour table with or without glare.
  void follow(const CameraLight& light);

  ColourTable colour;
  RingByValue ring;
  RingDistances distances;

 private:
  void make(std::size_t part);

  ColourTable otherColour_;  // with glare where `colour` is without, or the other way round
  bool inGlare_ = false;
  RingByValue calibrated_;  // the ring table as it was measured
  std::array<LightGains, kTableParts> lights_;
  LightGains bytesAreOf_;
  ChannelBytes bytes_{};  // filled once another light than the table's is met
};

// The light in which the next image is looked at: one part more of the ring table is of it.
CameraLight advanced(CameraLight light);

}  // namespace kelpie::vision

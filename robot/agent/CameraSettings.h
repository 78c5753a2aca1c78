// SPDX-License-Identifier: Apache-2.0
// What the ERS-7's camera is set to, which a person chooses by a venue's light (docs/flash.md). The
// numbers are OPEN-R's (openr.md 5.5), so that a file of parameters says what the robot is told.
// The camera has no automatic of its own that is known to work.
#pragma once

#include <cstdint>

#include "robot/core/fields/Fields.h"

namespace kelpie::agent {

enum class WhiteBalance : std::uint8_t { indoor = 1, outdoor, fluorescent };  // 2856, 6500, 5000 K
enum class CameraGain : std::uint8_t { low = 1, mid, high };                  // -6, 0, 6 dB
enum class Shutter : std::uint8_t { slow = 1, mid, fast };  // 1/50, 1/100, 1/200 s

// As in 2005: high gain for a fast shutter, so that little is smeared (facts-2005 2.1).
struct CameraSettings {
  WhiteBalance whiteBalance = WhiteBalance::fluorescent;
  CameraGain gain = CameraGain::high;
  Shutter shutter = Shutter::fast;

  bool operator==(const CameraSettings& other) const {
    return whiteBalance == other.whiteBalance && gain == other.gain && shutter == other.shutter;
  }
  bool operator!=(const CameraSettings& other) const { return !(*this == other); }

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("whiteBalance", &CameraSettings::whiteBalance, "", 1, 3),
                     field("gain", &CameraSettings::gain, "", 1, 3),
                     field("shutter", &CameraSettings::shutter, "", 1, 3));
  }
};

}  // namespace kelpie::agent

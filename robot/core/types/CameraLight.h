// SPDX-License-Identifier: Apache-2.0
// What light the camera sees, over that which the colour table was made for: how far the tables
// follow it, and what was seen of it in the last seconds. It is believed after an image and the
// next one is looked at with it, so that a log which keeps few images replays to the bit.
#pragma once

#include <cstdint>

#include "robot/core/fields/Fields.h"

namespace kelpie {

// Of Y, and of Cr and Cb about grey.
struct LightGains {
  double brightness = 1.0;
  double colour = 1.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("brightness", &LightGains::brightness, "", 0.1, 4),
                     field("colour", &LightGains::colour, "", 0.1, 4));
  }
};

inline bool operator==(const LightGains& a, const LightGains& b) {
  return a.brightness == b.brightness && a.colour == b.colour;
}
inline bool operator!=(const LightGains& a, const LightGains& b) { return !(a == b); }

// Means of the natural logarithms of what one kind of surface looked like over what is expected.
struct LightMemory {
  double images = 0.0;  // that they are of
  double brightness = 0.0;
  double colour = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("images", &LightMemory::images, "", 0, 10000),
                     field("brightness", &LightMemory::brightness, "", -10, 10),
                     field("colour", &LightMemory::colour, "", -10, 10));
  }
};

struct CameraLight {
  LightGains applied;            // what pixels are divided by, once the tables are whole
  LightGains before;             // so, in those parts of the ring table still to be made
  std::uint8_t partsToMake = 0;  // the first ones
  LightMemory carpet;
  LightMemory line;
  LightMemory landmark;
  bool glare = false;         // landmarks are looked for as glare leaves them
  std::uint16_t missing = 0;  // images in a row that should show such a landmark and do not

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("applied", &CameraLight::applied), field("before", &CameraLight::before),
                     field("partsToMake", &CameraLight::partsToMake, "", 0, 4),
                     field("carpet", &CameraLight::carpet), field("line", &CameraLight::line),
                     field("landmark", &CameraLight::landmark), field("glare", &CameraLight::glare),
                     field("missing", &CameraLight::missing));
  }
};

}  // namespace kelpie

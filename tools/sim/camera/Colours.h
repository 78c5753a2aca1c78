// SPDX-License-Identifier: Apache-2.0
// Nominal colours of everything on a field, in the camera's own Y, Cr, Cb (0..255). The centres are
// those of the trained 2005 colour table (facts-2005 section 3); the rest was chosen to lie where
// that table says "none", white or grey.
#pragma once

#include "robot/core/types/Image.h"

namespace kelpie::sim {

struct Colour {
  float y = 0.0F;
  float cr = 128.0F;
  float cb = 128.0F;
};

namespace colours {
constexpr Colour kOrange{140, 181, 79};
constexpr Colour kBlue{82, 121, 167};
constexpr Colour kYellow{120, 160, 61};
constexpr Colour kPink{113, 193, 124};
constexpr Colour kGreen{77, 103, 97};
constexpr Colour kWhite{189, 124, 129};
constexpr Colour kShell{173.88F, 124, 129};  // white in a robot's own shade
constexpr Colour kRobotRed{85, 165, 131};
constexpr Colour kRobotBlue{28, 126, 147};
constexpr Colour kGrey{79, 130, 129};
constexpr Colour kBlack{20, 126, 128};
constexpr Colour kFloor{96, 131, 122};
constexpr Colour kWall{150, 129, 124};
constexpr Colour kCeiling{172, 126, 128};
constexpr Colour kSkin{132, 152, 112};
}  // namespace colours

inline Colour brighter(Colour c, double factor) {
  return {c.y * static_cast<float>(factor), c.cr, c.cb};
}

}  // namespace kelpie::sim

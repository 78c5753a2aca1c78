// SPDX-License-Identifier: Apache-2.0
// Places on the straight line between two pixels.
#pragma once

#include "robot/core/types/Geometry.h"

namespace kelpie::vision {

// share 0 at a, 1 at b
inline PixelPoint between(PixelPoint a, PixelPoint b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

}  // namespace kelpie::vision

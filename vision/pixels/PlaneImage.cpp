// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/PlaneImage.h"

namespace kelpie::vision {

void imageOf(const ClassPlane& plane, Image& image) {
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const Yuv& colour = kPlaneColours[plane[i]];
    image.y[i] = colour.y;
    image.cr[i] = colour.cr;
    image.cb[i] = colour.cb;
  }
}

}  // namespace kelpie::vision

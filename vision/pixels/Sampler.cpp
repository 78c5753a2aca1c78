// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

ColourClass Sampler::classified(int px, int py) const {
  const ColourClass colour = classOf(corrected(px, py));
  classes_.keep(Image::at(px, py), static_cast<unsigned>(colour));
  return colour;
}

}  // namespace kelpie::vision

// SPDX-License-Identifier: Apache-2.0
// Where robots and ball really are in the middle of an exposure, the same for all cameras. Truth:
// it goes into a View and no further.
#pragma once

#include <vector>

#include "tools/sim/bodies/BodyShape.h"

namespace kelpie::percepts {

struct Moment {
  std::vector<sim::BodyPlace> robots;
  std::vector<TeamColour> teams;  // of them
  Point2<Field> ball;
};

}  // namespace kelpie::percepts

// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/Resistance.h"

#include <cmath>

namespace kelpie::sim {

void Resistance::feel(Point2<Field> walked, Point2<Field> pushed) {
  const double way2 = walked.x * walked.x + walked.y * walked.y;
  const double back = -(walked.x * pushed.x + walked.y * pushed.y);
  const double share = way2 > 0.0 ? maths::clamp(back / way2, 0.0, 1.0) : 0.0;
  pushedBack_ += (share - pushedBack_) * (1.0 - maths::exp(-1.0 / params_.settleTicks));
}

void Resistance::newStep() {
  constexpr double kMax = 0.95;  // a stalled joint still gives a little
  grip_ = maths::clamp(random_.gaussian(params_.grip, params_.gripSd), 0.0, kMax);
}

}  // namespace kelpie::sim

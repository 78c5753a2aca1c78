// SPDX-License-Identifier: Apache-2.0
// Whether two poses are one, within so many centimetres and degrees.
#pragma once

#include "robot/core/types/Geometry.h"

namespace kelpie::gps {

inline bool samePose(const Pose2& a, const Pose2& b, double cm, double deg) {
  const Point2<Field> d = a.position - b.position;
  return d.x * d.x + d.y * d.y < cm * cm && (a.heading - b.heading).abs().deg() < deg;
}

}  // namespace kelpie::gps

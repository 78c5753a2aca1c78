// SPDX-License-Identifier: Apache-2.0
// The field of 2006 for tests, its table of the nearest paint, each built once, and views of it.
#pragma once

#include <memory>

#include "gps/lines/LineFit.h"

namespace kelpie::gps {

inline const body::FieldDescription& field2006() {
  static const body::FieldDescription field = *body::fieldDescription("2006");
  return field;
}

inline const FieldFeatures& features() {
  static const auto built = [] {
    auto f = std::make_unique<FieldFeatures>();
    f->build(field2006());
    return f;
  }();
  return *built;
}

// Points of the painted lines up to 250 cm around a pose, without noise.
inline SeenLines seenFrom(const Pose2& pose) {
  SeenLines seen;
  for (const body::FieldLine& line : field2006().lines) {
    const Point2<Field> way = line.end - line.start;
    for (double at = 0.0; at < way.norm(); at += 15.0) {
      const Point2<Robot> p = robotFromField(pose, line.start + way * (at / way.norm()));
      if (p.y > 0.0 && p.norm() < 250.0) seen.lines.push_back({p, 1.0});
    }
  }
  return seen;
}

inline const Pose2 kPose{{150.0, 120.0}, Angle::deg(40.0)};

}  // namespace kelpie::gps

// SPDX-License-Identifier: Apache-2.0
// The field that lines are matched to, and its symmetry: it looks the same after half a turn.
#pragma once

#include "gps/lines/FieldFeatures.h"
#include "robot/body/FieldDescription.h"

namespace kelpie::gps {

struct PaintedField {
  const body::FieldDescription& description;
  const FieldFeatures& features;
};

// The pose turned by 180 deg about the middle of the field.
inline Pose2 twinOf(const Pose2& pose, const body::FieldDescription& field) {
  return {{field.width - pose.position.x, field.length - pose.position.y},
          pose.heading + Angle::rad(maths::kPi)};
}

}  // namespace kelpie::gps

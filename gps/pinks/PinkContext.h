// SPDX-License-Identifier: Apache-2.0
// What localising by pinks reads of the parameters, and the field.
#pragma once

#include "gps/lines/LineUpdateParams.h"
#include "gps/lines/PaintedField.h"
#include "gps/pinks/PinkMapParams.h"
#include "gps/pose/PoseParams.h"

namespace kelpie::gps {

struct PinkContext {
  const PaintedField& field;
  const PinkMapParams& pinks;
  const ModeParams& modes;
  const LandmarkGates& gates;
  const LineUpdateParams& lines;
};

}  // namespace kelpie::gps

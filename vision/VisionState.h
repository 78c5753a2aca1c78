// SPDX-License-Identifier: Apache-2.0
// Vision's memory: the calibration and work buffers that each step overwrites. Nothing of an
// earlier image survives. 300 KB: keep it off the stack.
#pragma once

#include "vision/Blobs.h"
#include "vision/Judged.h"
#include "vision/RingTable.h"
#include "vision/Sampler.h"
#include "vision/VisionCalibration.h"

namespace kelpie::vision {

struct VisionState {
  VisionState() : VisionState(nominalCalibration()) {}
  explicit VisionState(const VisionCalibration& given) : calibration(given) {}

  VisionCalibration calibration;
  RingDistances distances;
  ClassPlane classes{};
  RunBuffer runs;
  BlobBuffer blobs;
  Judged judged;
};

}  // namespace kelpie::vision

// SPDX-License-Identifier: Apache-2.0
// What one robot's camera and one venue's light need: colour table and ring correction, 164 KB.
// Loaded at start-up, handed to VisionState, and logged whole with the configuration.
#pragma once

#include <string>

#include "robot/core/Expected.h"
#include "robot/core/fields/Fields.h"
#include "vision/colour/ColourTable.h"
#include "vision/colour/RingTable.h"

namespace kelpie::vision {

struct VisionCalibration {
  ColourTable colour;
  RingTable ring;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("colour", &VisionCalibration::colour),
                     field("ring", &VisionCalibration::ring));
  }
};

// The simulated world's colours and the nominal ring model.
VisionCalibration nominalCalibration();

// colour: "nominal" or a file for loadColourTable; ring: "nominal", "none", "2006" or a
// file.
Expected<VisionCalibration> loadCalibration(const std::string& colour, const std::string& ring);

}  // namespace kelpie::vision

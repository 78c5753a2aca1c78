// SPDX-License-Identifier: Apache-2.0
#include "vision/colour/VisionCalibration.h"

#include "vision/colour/ColourBuilder.h"

namespace kelpie::vision {

VisionCalibration nominalCalibration() {
  return {buildColourTable(nominalPrototypes()), buildRingTable(ringModelNominal())};
}

Expected<VisionCalibration> loadCalibration(const std::string& colour, const std::string& ring) {
  VisionCalibration calibration;
  if (colour == "nominal") {
    calibration.colour = buildColourTable(nominalPrototypes());
  } else {
    auto table = loadColourTable(colour);
    if (!table) return Error{table.error()};
    calibration.colour = *table;
  }
  auto correction = loadRingTable(ring);
  if (!correction) return Error{correction.error()};
  calibration.ring = *correction;
  return calibration;
}

}  // namespace kelpie::vision

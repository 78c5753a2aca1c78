// SPDX-License-Identifier: Apache-2.0
// `kelpie calibrate time`: how much older a robot's images are than their stamps, from the log of
// one that played or looked round. The filter that plays (gps/camera/Lag) goes over the recorded
// percepts again, from a doubt that holds for any robot; it compares sightings of one landmark at
// different rates of the head's pan, so images need not be kept. Fails where the head never turned
// over a landmark.
#pragma once

#include <cstdint>
#include <string>

#include "robot/core/Expected.h"

namespace kelpie::calibrate {

struct LagEstimate {
  double seconds = 0.0;  // above 0: images are older; below: the joints are
  double sd = 0.0;       // s
  std::uint32_t frames = 0;
  std::uint32_t compared = 0;  // of these, with a landmark that had been seen at another pan rate
  std::string lacks;           // what of the log could not be read
};

// An error says in one line why nothing can be told.
Expected<LagEstimate> estimateLag(const std::string& path);

}  // namespace kelpie::calibrate

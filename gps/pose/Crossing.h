// SPDX-License-Identifier: Apache-2.0
// Two different landmarks within seconds that the best mode did not predict: most likely the robot
// was carried, and the two together say where to. Keeps the last such sighting, moved along by
// odometry, and makes one mode of it and the next. The wide mode would get there too, by steps that
// are linearised far from the place. Wrong where one of the two was false: then the next sightings
// refuse the mode.
#pragma once

#include "gps/pose/Landmarks.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

struct CrossingParams {
  double gate = 4.0;      // standard deviations of bearing or distance, beyond which: not predicted
  double seconds = 12.0;  // between the two
  double weight = 1e-2;   // of the mode, over the weight of all others
  double apart = 40.0;    // cm between the two as seen; nearer ones do not tell the heading

  template <int = 0>
  static constexpr auto fields() {
    using P = CrossingParams;
    return fieldList(field("gate", &P::gate, "", 1, 100), field("seconds", &P::seconds, "s", 0, 60),
                     field("weight", &P::weight, "", 0, 1),
                     field("apart", &P::apart, "cm", 1, 1000));
  }
};

// Call before each landmark's update: may add a mode, which the update then corrects.
void cross(const Measurement& seen, const body::FieldDescription& field,
           const CrossingParams& params, const ModeParams& modes, PoseState& state);

// The step of a frame, in the robot frame.
void moveCrossing(const Odometry& step, double elapsed, SurprisingSighting& before);

}  // namespace kelpie::gps

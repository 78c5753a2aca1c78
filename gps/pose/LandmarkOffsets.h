// SPDX-License-Identifier: Apache-2.0
// How far each landmark stands from its place on the map: beacons are moved by robots, and set up
// by hand. An offset of each on the carpet, with its covariance, beside the modes: what it may be
// is part of the doubt of a sighting, and what the best mode did not expect is divided between the
// two by their covariances. What they share is dropped after each sighting. Fails where all that is
// seen is off alike: then the pose follows.
#pragma once

#include "gps/pose/Landmarks.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

struct LandmarkOffsetParams {
  bool use = true;
  double sd = 2.0;      // cm, of each axis at the start, and most
  double drift = 1.0;   // cm a root second of noise, with a pull to the map that keeps sd
  double maxSd = 15.0;  // cm, of the best mode; a wider one tells nothing of landmarks
  double gate = 3.0;    // standard deviations; a sighting farther off is another mode's, or false
  double max = 40.0;    // cm, of an offset
  double moved = 7.0;   // cm, from which each sighting is counted as of one that was moved

  template <int = 0>
  static constexpr auto fields() {
    using P = LandmarkOffsetParams;
    return fieldList(field("use", &P::use), field("sd", &P::sd, "cm", 0.1, 100),
                     field("drift", &P::drift, "cm", 0, 100),
                     field("maxSd", &P::maxSd, "cm", 0, 1000), field("gate", &P::gate, "", 1, 100),
                     field("max", &P::max, "cm", 0, 1000),
                     field("moved", &P::moved, "cm", 0, 1000));
  }
};

LandmarkOffsets startingOffsets(const LandmarkOffsetParams& params);

// May be elsewhere by now. On the other side of the field the landmarks are the other ones.
void driftOffsets(TeamColour team, double elapsed, const LandmarkOffsetParams& params,
                  LandmarkOffsets& offsets);

// The sighting of a landmark that stands where it is believed to, as far as that is known.
Measurement displaced(const Measurement& seen, const LandmarkOffsetParams& params,
                      const LandmarkOffsets& offsets);

// The same with the doubt of the offset, alike in all directions.
Measurement doubted(const Measurement& displaced, const LandmarkOffsets& offsets);

// What the sighting, displaced, tells of the offset. Call before the modes are corrected.
void learnOffset(const PoseMode& best, const Measurement& displaced,
                 const LandmarkOffsetParams& params, LandmarkOffsets& offsets, GpsCounts& counts);

}  // namespace kelpie::gps

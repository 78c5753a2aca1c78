// SPDX-License-Identifier: Apache-2.0
// `kelpie calibrate body`: the BodyParams of a robot from the log of one that stood and looked
// round in stops. All sightings of landmarks, lines and the carpet's end are fitted together with
// the robot's place; vision then looks again with what was found. What the log cannot tell better
// than what is known of all robots stays as it was. Fails where the field is not as its description
// says.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/calibrate/body/BodySightings.h"

namespace kelpie::calibrate {

struct Estimated {
  Unknown unknown = kFocalLength;
  double value = 0.0;  // in the unknown's unit (kUnknownKinds)
  double sd = 0.0;
  double recorded = 0.0;  // what the log's robot believed
  bool observed = false;  // otherwise `value` is that as well
};

// A sighting's place in the image and how far it is beside where it should be.
struct Residual {
  SightKind kind = SightKind::bandBorder;
  PixelPoint pixel;
  PixelPoint miss;  // px
};
using Residuals = std::vector<Residual>;

struct BodyEstimate {
  body::BodyParams params;
  std::vector<Estimated> unknowns;  // in their order
  int frames = 0;
  int stops = 0;
  double seconds = 0.0;  // of the stand
  std::size_t landmarkKinds = 0;
  Residuals before;  // with the parameters of the log, at the place that then fits best
  Residuals after;
};

// px, robust: half of them are smaller. 0 of none.
double medianMiss(const Residuals& residuals, SightKind kind);

// An error says in one line what is missing.
Expected<BodyEstimate> estimateBody(const StandingLog& log);

}  // namespace kelpie::calibrate

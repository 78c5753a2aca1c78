// SPDX-License-Identifier: Apache-2.0
// Where a standing robot saw what, in pixels, beside what it was on the field: of beacons the
// border between the bands and both their ends, the posts of goals, points of painted lines, the
// carpet's end. Which line a point lies on is decided by the present estimate: wrong where that is
// further off than half the way to the next line.
#pragma once

#include <string>
#include <vector>

#include "robot/core/types/Percepts.h"
#include "tools/calibrate/body/BodyModel.h"

namespace kelpie::calibrate {

enum class SightKind : std::uint8_t { bandBorder, beaconEnd, goalPost, linePoint, carpetEnd };
constexpr std::size_t kSightKindCount = 5;
const char* nameOf(SightKind kind);  // "carpet's end"

// One measured coordinate.
struct Sighting {
  SightKind kind = SightKind::bandBorder;
  std::size_t frame = 0;  // of StandingLog::frames
  PixelPoint pixel;
  PixelPoint normal;  // unit vector in the image in which it is measured; {0, 0}: across the line
  Point2<Field> place;
  double height = 0.0;    // cm, of the place
  double radius = 0.0;    // cm, that what is seen is nearer than the place
  Point2<Field> along;    // unit vector of a line; {0, 0}: a point
  double outwards = 0.0;  // how much of its spread is along the normal
  double sd = 1.0;        // px
};
using Sightings = std::vector<Sighting>;

// Of all frames.
struct Seen {
  std::vector<Percepts> percepts;
  std::vector<CameraPose> cameras;  // with which vision saw them
};

// Runs vision on the frames, with a head that hangs as `values` say.
Seen look(const StandingLog& log, const Numbers& values, std::size_t every);

struct Gathering {
  bool lines = true;  // and the carpet's end, for which the place must be known well
  double gate = 5.0;  // px; what is further beside is something else
};

Sightings sightings(const StandingLog& log, const Seen& seen, const BodyModel& model,
                    const Numbers& values, const Gathering& gathering);

// How far beside where it should be a sighting is, along its normal.
struct Miss {
  double size = 0.0;  // px; nothing sensible (`kLost`) behind the camera
  PixelPoint normal;  // unit vector
};
constexpr double kLost = 50.0;
Miss missOf(const Sighting& sighting, const CameraPose& camera, const Numbers& values);

}  // namespace kelpie::calibrate

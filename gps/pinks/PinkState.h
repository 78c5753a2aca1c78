// SPDX-License-Identifier: Apache-2.0
// What the localiser remembers of pink patches: the map, and, while the pose is lost, the survey of
// what was seen around and the state of the search by it. Plain data.
#pragma once

#include <cstdint>

#include "gps/pose/PoseSearch.h"
#include "robot/core/FixedVector.h"
#include "robot/core/types/Command.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

using PinkLandmarks = FixedVector<PinkLandmark, kMaxPinks>;

// A direction in which pink was seen, in the survey's frame.
struct SurveyBearing {
  Point2<Robot> origin;
  double eyeHeight = 0.0;  // cm, of the camera
  Angle heading;
  Angle elevation;
  double weight = 0.0;  // sightings
};

struct SurveyPoint {
  Point2<Robot> place;
  double weight = 0.0;
};

constexpr std::size_t kSurveyPoints = 128;

// All in the robot frame of where the survey began.
struct Survey {
  Point2<Robot> place;  // of the robot now
  Angle turned;         // the robot since
  double seconds = 0.0;
  double nextSearch = 0.0;  // s
  FixedVector<SurveyPoint, kSurveyPoints> points;
  FixedVector<SurveyBearing, 24> bearings;
};

struct PinkState {
  PinkUse use = PinkUse::off;  // in the last frame
  PinkLandmarks map;
  double sinceForgotten = 0.0;    // s
  std::uint32_t unexplained = 0;  // sightings in a row that no mode predicted
  Survey survey;
  PoseSearch search;           // for where on the field the survey began
  std::uint32_t searches = 0;  // that came to an end while lost
};

}  // namespace kelpie::gps

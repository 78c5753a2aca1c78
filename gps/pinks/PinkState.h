// SPDX-License-Identifier: Apache-2.0
// What the localiser remembers of pink patches: the map, and, while the pose is lost, the survey of
// what was seen around and the state of the search by it. Plain data.
#pragma once

#include <cstdint>

#include "robot/core/Command.h"
#include "robot/core/FixedVector.h"
#include "robot/core/Geometry.h"
#include "robot/core/WorldModel.h"

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

// A pose of the survey's frame on the field.
struct PoseCandidate {
  Pose2 pose;
  double score = 0.0;  // log likelihood, up to a constant
  double match = 0.0;  // of the line points, 0 to 1
};

struct PinkPoseSearch {
  bool running = false;
  std::uint32_t cursor = 0;   // the next pose to be tried
  std::uint32_t refined = 0;  // candidates done
  FixedVector<PoseCandidate, 32> candidates;
  std::uint32_t count = 0;  // searches that came to an end
};

struct PinkState {
  PinkUse use = PinkUse::off;  // in the last frame
  PinkLandmarks map;
  double sinceForgotten = 0.0;    // s
  std::uint32_t unexplained = 0;  // sightings in a row that no mode predicted
  Survey survey;
  PinkPoseSearch search;
};

}  // namespace kelpie::gps

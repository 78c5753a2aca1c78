// SPDX-License-Identifier: Apache-2.0
// What an image shows of objects besides ball and landmarks: the gaps of a goal, robots, pink
// patches and points of obstacles; part of Percepts.h. All come from one image alone: what that
// does not show, or shows wrongly, is so here.
#pragma once

#include <cstddef>
#include <cstdint>

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Geometry.h"

namespace kelpie {

enum class LandmarkKind : std::uint8_t {
  goalBlue,
  goalYellow,
  beaconBlueOnPink,  // blue above pink
  beaconPinkOnBlue,
  beaconYellowOnPink,
  beaconPinkOnYellow,
};
constexpr std::size_t kLandmarkKindCount = 6;

// Where in the image an object was found.
struct PixelBox {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("left", &PixelBox::left, "px"), field("top", &PixelBox::top, "px"),
                     field("right", &PixelBox::right, "px"),
                     field("bottom", &PixelBox::bottom, "px"));
  }
};

// A free stretch of a goal's mouth, between a post and a robot, or from post to post when nobody
// stands in it (thesis 2006 section 6.4.2).
struct GoalGap {
  LandmarkKind goal = LandmarkKind::goalBlue;
  Angle left;
  Angle right;
  bool leftCut = false;  // ends at the image border, not at a post or robot
  bool rightCut = false;
  PixelBox box;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("goal", &GoalGap::goal, "", 0, 1), field("left", &GoalGap::left, "rad", -180, 180),
        field("right", &GoalGap::right, "rad", -180, 180), field("leftCut", &GoalGap::leftCut),
        field("rightCut", &GoalGap::rightCut), field("box", &GoalGap::box));
  }
};

// Another robot, known by the uniform patches that belong together.
struct RobotPercept {
  TeamColour team = TeamColour::red;
  double distance = 0.0;
  Angle heading;
  Angle elevation;
  double distanceVariance = 0.0;  // cm2
  double headingVariance = 0.0;   // rad2
  PixelBox box;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("team", &RobotPercept::team, "", 0, 1),
                     field("distance", &RobotPercept::distance, "cm", 0, 1000),
                     field("heading", &RobotPercept::heading, "rad", -180, 180),
                     field("elevation", &RobotPercept::elevation, "rad", -90, 90),
                     field("distanceVariance", &RobotPercept::distanceVariance, "cm2", 0),
                     field("headingVariance", &RobotPercept::headingVariance, "rad2", 0),
                     field("box", &RobotPercept::box));
  }
};

// A pink patch that is no beacon: a landmark of the 2004 localisation challenge.
struct PinkPercept {
  double distance = 0.0;
  Angle heading;
  Angle elevation;
  double distanceVariance = 0.0;  // cm2
  double headingVariance = 0.0;   // rad2
  PixelBox box;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("distance", &PinkPercept::distance, "cm", 0, 1000),
                     field("heading", &PinkPercept::heading, "rad", -180, 180),
                     field("elevation", &PinkPercept::elevation, "rad", -90, 90),
                     field("distanceVariance", &PinkPercept::distanceVariance, "cm2", 0),
                     field("headingVariance", &PinkPercept::headingVariance, "rad2", 0),
                     field("box", &PinkPercept::box));
  }
};

// Where something dark stands on the carpet: the foot of a robot or of its shadow.
struct ObstaclePoint {
  Point2<Robot> position;
  PixelPoint pixel;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("position", &ObstaclePoint::position),
                     field("pixel", &ObstaclePoint::pixel));
  }
};

}  // namespace kelpie

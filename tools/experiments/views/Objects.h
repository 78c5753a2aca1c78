// SPDX-License-Identifier: Apache-2.0
// What of a view vision should have seen, and how well a percept agrees with it.
#pragma once

#include <vector>

#include "robot/core/types/Percepts.h"
#include "tools/experiments/views/Visibility.h"

namespace kelpie::experiments {

enum class ObjectKind { ball, beacon, goal, robot };

// One object of the field in one view.
struct TrueObject {
  ObjectKind kind = ObjectKind::ball;
  LandmarkKind landmark = LandmarkKind::goalBlue;  // of beacons and goals
  TeamColour team = TeamColour::red;               // of robots
  double distance = 0.0;  // cm on the ground, from the robot frame's origin
  Angle heading;
  bool inView = false;  // some of it may be in the image: a percept of it is not false
  bool toSee = false;   // enough of it shows that it should be recognised
  int pixels = 0;       // of it that show; 0 where it is not in view
  int pixelsAlone = 0;  // the same as if nothing stood before it
  bool cut = false;     // it reaches the border of the usable image
};

std::vector<TrueObject> trueObjects(const View& view, const body::FieldDescription& field,
                                    Visibility& visibility);

// A percept of any of them.
struct SeenObject {
  ObjectKind kind = ObjectKind::ball;
  LandmarkKind landmark = LandmarkKind::goalBlue;
  TeamColour team = TeamColour::red;
  double distance = 0.0;
  Angle heading;
};

SeenObject seenObject(const BallPercept& ball);
SeenObject seenObject(const LandmarkPercept& landmark);
SeenObject seenObject(const RobotPercept& robot);
std::vector<SeenObject> seenObjects(const Percepts& percepts);

// Whether a percept is of the object; one that matches no object is false. A robot's team does not
// count.
bool matches(const SeenObject& percept, const TrueObject& object);

// A free interval of a goal's mouth as it really is, its ends as directions from the robot.
struct TrueGap {
  LandmarkKind goal = LandmarkKind::goalBlue;
  Angle left;
  Angle right;
  bool leftInImage = false;
  bool rightInImage = false;
};
std::vector<TrueGap> trueGaps(const View& view, const body::FieldDescription& field,
                              LandmarkKind goal);

}  // namespace kelpie::experiments

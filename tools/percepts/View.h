// SPDX-License-Identifier: Apache-2.0
// What a robot's camera is turned to, in the middle of an exposure: where the true camera has
// things of the field in its image, and which other robots stand before them. What the robot makes
// of a pixel goes by the camera pose that it believes, so that the errors of joints, stance and
// lean are its own. Fails where things show between the legs of a robot whose box hides them, and
// knows nothing of the own legs.
#pragma once

#include <optional>
#include <vector>

#include "robot/core/types/Percepts.h"
#include "tools/percepts/Moment.h"
#include "tools/sim/camera/FieldCamera.h"

namespace kelpie::percepts {

// A pixel, and how far before the camera it shows what it shows.
struct Spot {
  PixelPoint pixel;
  double depth = 0.0;  // cm
};

// A part of another robot as the image has it.
struct Blocker {
  PixelBox box;
  double depth = 0.0;     // cm, of its middle
  std::size_t robot = 0;  // whose it is
  bool lowerLeg = false;  // grey, and on the ground
};

class View {
 public:
  // In place of what was there before.
  void turnTo(const Moment& moment, std::size_t self, const CameraPose& believed);

  // Nothing if it is behind the camera.
  std::optional<Spot> spot(sim::FieldPoint3 point) const;
  bool hidden(const Spot& spot) const;
  // Inside what vision uses of the image, and hidden by nobody.
  bool shows(const Spot& spot) const;
  // Where on the ground the true camera has a pixel, with its depth; nothing above the horizon.
  std::optional<Point2<Field>> ground(PixelPoint pixel) const;

  const sim::FieldCamera& eye() const { return eye_; }
  const Pose2& pose() const { return pose_; }
  const CameraPose& believed() const { return believed_; }
  const std::vector<Blocker>& blockers() const { return blockers_; }
  // cm along the ground from the camera.
  double distance(Point2<Field> place) const;

 private:
  void addRobot(const sim::BodyPlace& place, std::size_t robot);
  double addCorner(sim::FieldPoint3 way, PixelBox& box) const;

  Pose2 pose_;
  sim::FieldCamera eye_;
  CameraPose believed_;
  std::vector<Blocker> blockers_;
};

// Inside what vision uses of the image.
bool usable(PixelPoint pixel, double margin = 0.0);

// A place so far from the camera (cm along the ground) in a pixel's direction, by the camera pose
// that is believed.
Point2<Robot> readPlace(const CameraPose& believed, PixelPoint pixel, double distance);
// Tangent of the elevation of a pixel's ray.
double readSlope(const CameraPose& believed, PixelPoint pixel);

}  // namespace kelpie::percepts

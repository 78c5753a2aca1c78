// SPDX-License-Identifier: Apache-2.0
// Small test images by ray casting in the robot frame: carpet, balls, beacons, upright walls. Its
// geometry is its own, so that it can be wrong only independently of the code under test.
#pragma once

#include <memory>
#include <vector>

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"
#include "vision/VisionParams.h"
#include "vision/VisionState.h"

namespace kelpie::vision {

struct Paint {
  double y = 0.0;
  double cr = 128.0;
  double cb = 128.0;
};
constexpr Paint kOrangePaint{140, 181, 79};
constexpr Paint kBluePaint{82, 121, 167};
constexpr Paint kYellowPaint{120, 160, 61};
constexpr Paint kPinkPaint{113, 193, 124};
constexpr Paint kGreenPaint{77, 103, 97};
constexpr Paint kWhitePaint{189, 124, 129};
constexpr Paint kRedPaint{85, 165, 131};
constexpr Paint kWallPaint{150, 129, 124};
constexpr Paint kFloorPaint{96, 131, 122};

struct PaintedBall {
  double x = 0.0;
  double y = 0.0;
  double z = 4.2;
  double radius = 4.2;
  Paint paint = kOrangePaint;
};

struct PaintedWall {
  Point2<Robot> from;
  Point2<Robot> to;
  double low = 0.0;
  double high = 30.0;
  Paint paint;
};

struct PaintedBeacon {
  Point2<Robot> centre;
  Paint upper;
  Paint lower;
  Paint foot = kWhitePaint;
  double radius = 5.0;
  double bandHeight = 10.0;
  double lift = 0.0;  // how far it hovers above the ground
};

struct Painting {
  double carpetEnd = 600.0;  // cm ahead; the plain floor lies beyond
  double lineAt = -1.0;      // a white line across, 2.5 cm wide, at this distance
  Paint carpet = kGreenPaint;
  std::vector<PaintedBall> balls;
  std::vector<PaintedWall> walls;
  std::vector<PaintedBeacon> beacons;
  bool ring = true;    // the ERS-7's ring effect
  double noise = 0.0;  // sd in grey levels
};

// Camera at x = 0, y = 8 cm, turned to the left, then up, then rolled clockwise (degrees).
CameraPose cameraAt(double height, double left, double up, double roll = 0.0);
BodyState bodyOf(const CameraPose& camera);
void paint(const Painting& painting, const CameraPose& camera, Image& image);
// Vision for the painted camera, whose ring effects are centred on the image.
std::unique_ptr<VisionState> stateForPaintings();

// One step of vision on a painting.
struct Seen {
  Percepts percepts;
  std::unique_ptr<VisionState> state;
};
Seen look(const Painting& painting, const CameraPose& camera, const VisionParams& params = {});
const LandmarkPercept* find(const Percepts& percepts, LandmarkKind kind);
// A goal as the rules have it, its mouth square to the y axis.
void addGoal(Painting& painting, double x, double y, Paint colour);

}  // namespace kelpie::vision

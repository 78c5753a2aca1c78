// SPDX-License-Identifier: Apache-2.0
// What one image shows, in the robot frame. Distances are along the ground from the robot frame's
// origin; headings are left positive; variances are of the measurement, not of its history.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/types/CameraLight.h"
#include "robot/core/types/CameraModel.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/ObjectPercepts.h"

namespace kelpie {

// Position of the camera and direction of its axes, in the robot frame. Columns of `axes` (row by
// row: axes[3 * row + column]) are the camera's x, y and z axes in the robot frame in the middle of
// the exposure. The sensor exposes columns left to right: from the first to the last the axes turn
// by the vector `turn`. `tilt` is contained in position and axes; its variances say how well these
// are known. So are the offsets of the body's own lean (BodyParams), which `tilt` is beyond.
struct CameraPose {
  Point3<Robot> position;
  std::array<double, 9> axes{};
  std::array<double, 3> turn{};  // rad over the image, about x, y, z of the robot frame
  Lens lens;
  CameraTilt tilt;
  Angle bodyTiltOffset;
  Angle bodyRollOffset;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("position", &CameraPose::position),
                     field("axes", &CameraPose::axes, "", -1.000001, 1.000001),
                     field("turn", &CameraPose::turn, "rad", -10, 10),
                     field("lens", &CameraPose::lens), field("tilt", &CameraPose::tilt),
                     field("bodyTiltOffset", &CameraPose::bodyTiltOffset, "rad", -10, 10),
                     field("bodyRollOffset", &CameraPose::bodyRollOffset, "rad", -10, 10));
  }
};

// Line of equal elevation with the camera, y = atLeft + (atRight - atLeft) * x / 208.
struct Horizon {
  double atLeft = 0.0;
  double atRight = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("atLeft", &Horizon::atLeft, "px"),
                     field("atRight", &Horizon::atRight, "px"));
  }
};

struct BodyState {
  CameraPose camera;
  Horizon horizon;
  double headSpeed = 0.0;  // rad per frame, largest of the three head joints
  bool fallen = false;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("camera", &BodyState::camera), field("horizon", &BodyState::horizon),
                     field("headSpeed", &BodyState::headSpeed, "rad/frame", 0, 10),
                     field("fallen", &BodyState::fallen));
  }
};

// How much higher a thing is seen than it stands at the distance that its size alone tells: what
// the camera's tilt is wrong by in that direction.
struct ElevationError {
  Angle value;
  double variance = 0.0;  // rad2; 0: its size tells nothing

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("value", &ElevationError::value, "rad", -90, 90),
                     field("variance", &ElevationError::variance, "rad2", 0, 1));
  }
};

struct BallPercept {
  bool present = false;
  double distance = 0.0;
  Angle heading;
  Angle elevation;
  double distanceVariance = 0.0;  // cm2
  double headingVariance = 0.0;   // rad2
  ElevationError elevationError;  // of its centre
  PixelPoint centre;
  double radius = 0.0;  // px

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("present", &BallPercept::present),
                     field("distance", &BallPercept::distance, "cm", 0, 1000),
                     field("heading", &BallPercept::heading, "rad", -180, 180),
                     field("elevation", &BallPercept::elevation, "rad", -90, 90),
                     field("distanceVariance", &BallPercept::distanceVariance, "cm2", 0),
                     field("headingVariance", &BallPercept::headingVariance, "rad2", 0),
                     field("elevationError", &BallPercept::elevationError),
                     field("centre", &BallPercept::centre),
                     field("radius", &BallPercept::radius, "px", 0, 2000));
  }
};

struct LandmarkPercept {
  LandmarkKind kind = LandmarkKind::goalBlue;
  double distance = 0.0;
  Angle heading;
  Angle elevation;
  double distanceVariance = 0.0;  // cm2
  double headingVariance = 0.0;   // rad2
  ElevationError elevationError;  // of a beacon's bands, of a goal's feet
  // Directions of a goal's two visible edges; for a beacon both equal its heading.
  Angle leftEdge;
  Angle rightEdge;
  bool leftEdgeCut = false;  // the image border cuts the object on that side
  bool rightEdgeCut = false;
  PixelBox box;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("kind", &LandmarkPercept::kind, "", 0, 5),
                     field("distance", &LandmarkPercept::distance, "cm", 0, 1000),
                     field("heading", &LandmarkPercept::heading, "rad", -180, 180),
                     field("elevation", &LandmarkPercept::elevation, "rad", -90, 90),
                     field("distanceVariance", &LandmarkPercept::distanceVariance, "cm2", 0),
                     field("headingVariance", &LandmarkPercept::headingVariance, "rad2", 0),
                     field("elevationError", &LandmarkPercept::elevationError),
                     field("leftEdge", &LandmarkPercept::leftEdge, "rad", -180, 180),
                     field("rightEdge", &LandmarkPercept::rightEdge, "rad", -180, 180),
                     field("leftEdgeCut", &LandmarkPercept::leftEdgeCut),
                     field("rightEdgeCut", &LandmarkPercept::rightEdgeCut),
                     field("box", &LandmarkPercept::box));
  }
};

// One straight border of the carpet: y = atLeft + (atRight - atLeft) * x / 208, carpet below. Where
// several are seen, as at a corner of the carpet, the carpet is below all of them.
struct FieldEdgePercept {
  double atLeft = 0.0;   // row where the edge meets the left image border
  double atRight = 0.0;  // row where it meets the right one
  double support = 0.0;  // scan lines that show it
  double rms = 0.0;      // px, distance of their features from it

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("atLeft", &FieldEdgePercept::atLeft, "px"),
                     field("atRight", &FieldEdgePercept::atRight, "px"),
                     field("support", &FieldEdgePercept::support, "", 0, 100),
                     field("rms", &FieldEdgePercept::rms, "px", 0, 100));
  }
};

enum class LinePointKind : std::uint8_t { line, border, field };

struct LinePoint {
  LinePointKind kind = LinePointKind::line;
  Point2<Robot> position;
  double weight = 0.0;
  PixelPoint pixel;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("kind", &LinePoint::kind, "", 0, 2), field("position", &LinePoint::position),
        field("weight", &LinePoint::weight, "", 0, 1), field("pixel", &LinePoint::pixel));
  }
};

// How many candidates each check refused, in the order of vision's reasons (docs in vision/).
struct VisionCounts {
  std::uint32_t sampledPixels = 0;
  std::uint32_t runs = 0;
  std::uint32_t blobs = 0;
  std::array<std::uint16_t, 96> refused{};

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("sampledPixels", &VisionCounts::sampledPixels),
                     field("runs", &VisionCounts::runs), field("blobs", &VisionCounts::blobs),
                     field("refused", &VisionCounts::refused));
  }
};

struct Percepts {
  BallPercept ball;
  FixedVector<LandmarkPercept, 8> landmarks;
  FixedVector<GoalGap, 6> gaps;  // left to right
  FixedVector<RobotPercept, 8> robots;
  FixedVector<PinkPercept, 8> pinkPatches;
  FixedVector<ObstaclePoint, 64> obstacles;
  std::uint16_t obstaclesAhead = 0;  // dark pixels 25 cm to either side, up to 100 cm ahead
  FixedVector<FieldEdgePercept, 3> fieldEdges;  // strongest first
  FixedVector<LinePoint, 256> linePoints;
  VisionCounts counts;
  CameraLight light;  // believed after the image

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("ball", &Percepts::ball), field("landmarks", &Percepts::landmarks),
        field("gaps", &Percepts::gaps), field("robots", &Percepts::robots),
        field("pinkPatches", &Percepts::pinkPatches), field("obstacles", &Percepts::obstacles),
        field("obstaclesAhead", &Percepts::obstaclesAhead),
        field("fieldEdges", &Percepts::fieldEdges), field("linePoints", &Percepts::linePoints),
        field("counts", &Percepts::counts), field("light", &Percepts::light));
  }
};

}  // namespace kelpie

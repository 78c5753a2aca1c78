// SPDX-License-Identifier: Apache-2.0
// The head chain and the camera as exact geometry: where the camera is for given joints and stance,
// which ground point a pixel sees, and which pixel a point falls on. What differs between robots is
// in BodyParams; `kelpie calibrate body` finds it. Wrong where the neck's play is not on the side
// that the last movement pressed it to.
#pragma once

#include <cstddef>
#include <optional>

#include "robot/body/Infrared.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::body {

constexpr Lens kNominalLens;

// Of one robot. Offsets are added to what is sensed.
struct BodyParams {
  Lens lens;
  Angle neckTiltOffset;
  Angle headPanOffset;
  Angle headNodOffset;
  Angle bodyTiltOffset;    // nose down positive, as Stance::bodyTilt
  Angle bodyRollOffset;    // left side up positive
  Angle cameraRollOffset;  // of the camera in the head, clockwise as it looks
  // The team of 2005 added, to a neck tilted t down beyond 3 deg, 0.078 t + 1.25 deg upwards
  // (facts-2005 section 2.2): the head's weight hangs in the play of the joint.
  double neckGives = 0.0;  // share of the sensed neck tilt that is missing
  Angle neckBacklash;      // play between both sides; a turning neck lags by half of it
  InfraredParams infrared;

  template <int = 0>
  static constexpr auto fields() {
    using P = BodyParams;
    return fieldList(
        field("lens", &P::lens), field("neckTiltOffset", &P::neckTiltOffset, "rad", -10, 10),
        field("headPanOffset", &P::headPanOffset, "rad", -10, 10),
        field("headNodOffset", &P::headNodOffset, "rad", -10, 10),
        field("bodyTiltOffset", &P::bodyTiltOffset, "rad", -10, 10),
        field("bodyRollOffset", &P::bodyRollOffset, "rad", -10, 10),
        field("cameraRollOffset", &P::cameraRollOffset, "rad", -10, 10),
        field("neckGives", &P::neckGives, "", -0.3, 0.3),
        field("neckBacklash", &P::neckBacklash, "rad", 0, 10), field("infrared", &P::infrared));
  }
};

// Camera pose in the robot frame, with the nominal lens. Joints: neckTilt, headPan, headNod of
// `joints`.
CameraPose cameraPose(const JointAngles& joints, const Stance& stance);

// The same with the body turned about the neck base by a tilt and a roll.
CameraPose leaning(const CameraPose& camera, const Stance& stance, const CameraTilt& tilt);

// Variance of a ray's elevation from what is not known of the tilt, rad2; `right` and `forward` are
// the ray's direction on the ground, of length one.
double elevationVariance(const CameraTilt& tilt, double right, double forward);

// Camera coordinates of the ray through a pixel, of any length; and the pixel of such a ray, whose
// z must be positive.
Point3<Camera> pixelRay(const Lens& lens, PixelPoint pixel);
PixelPoint pixelOf(const Lens& lens, const Point3<Camera>& ray);

// Direction, in the robot frame, of the ray through a pixel, of any length; and of length one,
// which takes a root and three quotients more.
Point3<Robot> wayThrough(const CameraPose& camera, PixelPoint pixel);
Point3<Robot> rayThrough(const CameraPose& camera, PixelPoint pixel);

// Where the ray through the pixel meets the plane z = height; nothing if it does not descend to it.
std::optional<Point2<Robot>> groundPoint(const CameraPose& camera, PixelPoint pixel,
                                         double height = 0.0);

// Ground points of many pixels at once. Those that do not meet the plane are left with valid[i] =
// false.
void groundPoints(const CameraPose& camera, const PixelPoint* pixels, std::size_t count,
                  Point2<Robot>* points, bool* valid, double height = 0.0);

// The pixel a point falls on, inside the image or not; nothing if it is behind the camera.
std::optional<PixelPoint> project(const CameraPose& camera, Point3<Robot> point);
void project(const CameraPose& camera, const Point3<Robot>* points, std::size_t count,
             PixelPoint* pixels, bool* valid);

Horizon horizon(const CameraPose& camera);

// rad a frame, the fastest of the head's three joints.
double headSpeed(const HeadRate& rate);

// First stage of the camera loop.
BodyState step(const FrameInput& input, const BodyParams& params);

}  // namespace kelpie::body

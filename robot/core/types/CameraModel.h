// SPDX-License-Identifier: Apache-2.0
// What differs between the cameras of two robots: the lens and its sensor's shutter, how much the
// body leans more than its joints say, and how late the images are.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie {

// Square pixels. The nominal values are those of facts-2005 section 2.1; beacons measured in 2005
// tell 201.5 px (`kelpie evaluate distances`).
struct Lens {
  double focalLength = 192.0;  // px
  double principalX = 104.0;   // px
  double principalY = 80.0;    // px
  // A ray's tangent is this much larger than its pixel's, per squared tangent: 0 is a pinhole,
  // positive a barrel.
  double edgeTerm = 0.0;
  // Share of the frame's 33 ms in which the columns are exposed one after the other; 0 is a global
  // shutter.
  double readOut = 1.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("focalLength", &Lens::focalLength, "px", 100, 400),
                     field("principalX", &Lens::principalX, "px", 64, 144),
                     field("principalY", &Lens::principalY, "px", 40, 120),
                     field("edgeTerm", &Lens::edgeTerm, "", -0.5, 0.5),
                     field("readOut", &Lens::readOut, "", 0, 1));
  }
};

// How much the body is turned more than stance and joints say, about the neck base: tilt about the
// robot frame's x axis, nose up positive; roll about its y axis, left side up positive. With what
// is not known of it. The default is a tilt that has been estimated for a second of play; a robot
// that begins knows less (TiltParams).
struct CameraTilt {
  Angle tilt;
  Angle roll;
  double tiltVariance = 2.7e-5;  // rad2: sd 0.3 deg
  double rollVariance = 2.7e-5;  // rad2
  double covariance = 0.0;       // rad2

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("tilt", &CameraTilt::tilt, "rad", -45, 45),
                     field("roll", &CameraTilt::roll, "rad", -45, 45),
                     field("tiltVariance", &CameraTilt::tiltVariance, "rad2", 0, 1),
                     field("rollVariance", &CameraTilt::rollVariance, "rad2", 0, 1),
                     field("covariance", &CameraTilt::covariance, "rad2", -1, 1));
  }
};

// How many times as long the focal length is as the robot's parameters say. The default is one that
// has been estimated for ten seconds of play (FocalParams).
struct FocalScale {
  double ratio = 1.0;
  double variance = 2.5e-5;  // sd 0.5 %

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("ratio", &FocalScale::ratio, "", 0.5, 2),
                     field("variance", &FocalScale::variance, "", 0, 1));
  }
};

// How much earlier an image was exposed than its stamp says, or rather than its joints: negative
// where the joints are the older ones. The default is one that has been estimated for a second of
// panning (LagParams).
struct ImageLag {
  double seconds = 0.0;
  double variance = 4e-6;  // s2: sd 2 ms

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("seconds", &ImageLag::seconds, "s", -0.1, 0.2),
                     field("variance", &ImageLag::variance, "s2", 0, 1));
  }
};

}  // namespace kelpie

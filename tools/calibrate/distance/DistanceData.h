// SPDX-License-Identifier: Apache-2.0
// Sizes measured in the images of real robots in 2005 against true distances, and the geometry that
// vision's finders use, as far as a size alone decides: distances start at the neck base, the head
// looks level (at the ball: towards it). For experiments and tests; reads ../shared/data/distance.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::calibrate {

struct Measured {
  int series = 0;         // run of the ball, kind of beacon, row of the goal
  double pixels = 0.0;    // radius of a ball, height of a beacon or goal
  double distance = 0.0;  // cm
  double ahead = 0.0;     // cm, of the camera before the neck base, looking at the object
  double level = 1.0;     // cosine of the direction in which the camera sees a ball's centre
};
using Measurements = std::vector<Measured>;

enum class SizedObject { ball, beacon, goal };

// Rows that the team left out of its own fit are left out. The error names the file.
Expected<Measurements> readMeasurements(SizedObject object);
// From another folder, that ends in '/'.
Expected<Measurements> readMeasurements(SizedObject object, const std::string& folder);

// What a real camera, and the way its images were measured, may add to vision's geometry. As vision
// stands: 192 px, 0 and 0.
struct Optics {
  double focalLength = 192.0;  // px, near the middle of the image, where objects were measured
  double edge = 0.0;           // px, by which the measured size is larger than the true one
  // px, sd of the blur: half brightness on the outline of a disc of radius r lies blur^2 / (2 r)
  // within it. A straight edge stays where it is.
  double blur = 0.0;
};

// From pixels to cm.
using DistanceModel = std::function<double(const Measured&)>;
DistanceModel geometry(SizedObject object, const Optics& optics);
// factor / (pixels + offset): the form of the team's fits.
DistanceModel hyperbola(double factor, double offset);
// The team's constants on the robot (facts-2005 section 4.4).
DistanceModel teamsFit(SizedObject object);

struct Misfit {
  double rms = 0.0;         // cm
  double rmsPercent = 0.0;  // of the true distance
  double bias = 0.0;        // cm, model less truth
};
Misfit misfit(const Measurements& rows, const DistanceModel& model);

}  // namespace kelpie::calibrate

// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Crossing.h"

#include <cmath>

#include "gps/pose/Modes.h"
#include "gps/pose/PoseUpdate.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {
namespace {

bool predicted(const PoseMode& mode, const Measurement& seen, double gate) {
  const Innovation bearing = bearingInnovation(mode, seen);
  const double limit = maths::square(gate);
  if (maths::square(bearing.value) > limit * bearing.variance) return false;
  if (!seen.useDistance) return true;
  const double off = seen.distance - distance(mode.pose.position, seen.landmark);
  const double variance = mode.covariance[0] + mode.covariance[4] + seen.distanceVariance;
  return off * off <= limit * variance;
}

// The pose from which both lie where they were seen: turned as the line between them, then moved so
// that the nearer one, whose place is seen best, is right.
Pose2 crossing(const SurprisingSighting& before, Point2<Robot> place, const Measurement& seen) {
  const Point2<Field> way = seen.landmark - before.landmark;
  const Point2<Robot> seenWay = place - before.place;
  const Angle turn = Angle::rad(maths::atan2(way.y, way.x)) - bearing(seenWay);
  const bool nearer = place.norm() < before.place.norm();
  const Pose2 turnOnly{{}, turn};
  const Point2<Field> to = fieldFromRobot(turnOnly, nearer ? place : before.place);
  return {(nearer ? seen.landmark : before.landmark) - to, turn};
}

Measurement remembered(const SurprisingSighting& before) {
  Measurement m;
  m.landmark = before.landmark;
  m.useDistance = m.useHeading = true;
  m.distance = before.place.norm();
  m.heading = bearing(before.place);
  m.distanceVariance = before.distanceVariance;
  m.headingVariance = before.headingVariance;
  return m;
}

double weightOf(const Modes& modes) {
  double sum = 0.0;
  for (const PoseMode& mode : modes) sum += mode.weight;
  return sum;
}

}  // namespace

void cross(const Measurement& seen, const body::FieldDescription& field,
           const CrossingParams& params, const ModeParams& modes, PoseState& state) {
  SurprisingSighting& before = state.surprising;
  if (predicted(state.modes[0], seen, params.gate)) {
    before.present = false;
    return;
  }
  const Point2<Robot> place = robotPolar(seen.distance, seen.heading);
  const bool other = before.present && before.age <= params.seconds &&
                     distance(before.landmark, seen.landmark) > 0.0;
  if (other && (place - before.place).norm() > params.apart) {
    PoseMode mode = wideMode(field, modes, 1.0);
    mode.tilt = tiltOf(state.modes);
    mode.pose = crossing(before, place, seen);
    mode = corrected(mode, remembered(before));
    mode.weight = params.weight * weightOf(state.modes);
    if (body::carpetDistance(field, mode.pose.position) <= 0.0) state.modes.push_back(mode);
  }
  before = {true, 0.0, seen.landmark, place, seen.distanceVariance, seen.headingVariance};
}

void moveCrossing(const Odometry& step, double elapsed, SurprisingSighting& before) {
  if (!before.present) return;
  before.age += elapsed;
  before.place = robotFromField(moved({}, step), fieldFromRobot({}, before.place));
}

}  // namespace kelpie::gps

// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/pose/LocaliseSenses.h"

#include <cmath>

namespace kelpie::experiments {
namespace {

constexpr double kDegrees = 180.0 / maths::kPi;

bool isGoal(LandmarkKind kind) {
  return kind == LandmarkKind::goalBlue || kind == LandmarkKind::goalYellow;
}

bool isCut(const LandmarkPercept& percept) { return percept.leftEdgeCut || percept.rightEdgeCut; }

LandmarkRow rowOf(const LandmarkPercept& percept, const TrueLandmark& truth, TimeUs time) {
  LandmarkRow row;
  row.time = time;
  row.kind = percept.kind;
  row.distance = percept.distance;
  row.trueDistance = truth.distance;
  row.heading = percept.heading;
  row.trueHeading = truth.heading;
  row.distanceSd = std::sqrt(percept.distanceVariance);
  row.headingSd = std::sqrt(percept.headingVariance) * kDegrees;
  row.cut = isCut(percept);
  return row;
}

}  // namespace

template <class Percept>
void LandmarkErrors::add(const Percept& percept, const TrueLandmark& truth) {
  const double farther = percept.distance - truth.distance;
  const double off = (percept.heading - truth.heading).rad();
  distance.push_back(farther / truth.distance);
  heading.push_back(off * kDegrees);
  distanceOverSd.push_back(farther / std::sqrt(percept.distanceVariance));
  headingOverSd.push_back(off / std::sqrt(percept.headingVariance));
}

void LandmarkErrors::add(const LandmarkErrors& other) {
  append(other.distance, distance);
  append(other.heading, heading);
  append(other.distanceOverSd, distanceOverSd);
  append(other.headingOverSd, headingOverSd);
}

Json LandmarkErrors::summary(double seconds) const {
  return {{"per_s", static_cast<double>(distance.size()) / seconds},
          {"distance_bias_rate", mean(distance)},
          {"distance_rms_rate", rms(distance)},
          {"heading_bias_deg", mean(heading)},
          {"heading_rms_deg", rms(heading)},
          {"distance_over_sd_rms", rms(distanceOverSd)},
          {"heading_over_sd_rms", rms(headingOverSd)}};
}

void OdometryErrors::add(const OdometryErrors& other) {
  append(other.reported, reported);
  append(other.real, real);
}

Json OdometryErrors::summary() const {
  double cross = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < reported.size(); ++i) {
    cross += reported[i] * real[i];
    square += reported[i] * reported[i];
  }
  const double slope = ratio(cross, square);
  Values residuals;
  for (std::size_t i = 0; i < reported.size(); ++i)
    residuals.push_back(real[i] - slope * reported[i]);
  return {{"ratio", slope}, {"bias", mean(residuals)}, {"rms", rms(residuals)}};
}

void SenseErrors::add(const SenseErrors& other) {
  seconds += other.seconds;
  falseLandmarks += other.falseLandmarks;
  beacons.add(other.beacons);
  goals.add(other.goals);
  balls.add(other.balls);
  falseBalls += other.falseBalls;
  forward.add(other.forward);
  left.add(other.left);
  turn.add(other.turn);
}

Json SenseErrors::summary() const {
  return {{"beacon", beacons.summary(seconds)},      {"goal", goals.summary(seconds)},
          {"ball", balls.summary(seconds)},          {"false_balls_per_s", falseBalls / seconds},
          {"false_per_s", falseLandmarks / seconds}, {"odometryForward", forward.summary()},
          {"odometryLeft", left.summary()},          {"odometryTurn", turn.summary()}};
}

void SenseRecorder::addLandmark(const LandmarkPercept& percept, const WatchedFrame& frame) {
  const TrueLandmark truth =
      trueLandmark(percept.kind, frame.truth, params_, frame.input.game.team);
  trace_.add(rowOf(percept, truth, frame.input.time));
  if (!isThere(percept, truth)) {
    ++errors_.falseLandmarks;
    return;
  }
  const bool goal = isGoal(percept.kind);
  if (goal && isCut(percept)) return;
  (goal ? errors_.goals : errors_.beacons).add(percept, truth);
}

void SenseRecorder::addBall(const BallPercept& percept, const WatchedFrame& frame) {
  constexpr double kFarthest = 150.0;
  const Point2<Robot> ball = robotFromField(frame.truth, frame.ball);
  if (!percept.present || percept.distance > kFarthest) return;
  const bool there = (percept.heading - bearing(ball)).abs().deg() < 10.0 &&
                     std::fabs(percept.distance - ball.norm()) < ball.norm() / 3.0;
  if (there) {
    errors_.balls.add(percept, {ball.norm(), bearing(ball)});
  } else {
    ++errors_.falseBalls;
  }
}

void SenseRecorder::addStep(const WatchedFrame& frame) {
  const auto second = static_cast<std::size_t>(frame.input.time.seconds());
  if (second >= errors_.turn.reported.size())
    for (OdometryErrors* one : {&errors_.forward, &errors_.left, &errors_.turn})
      for (Values* sums : {&one->reported, &one->real}) sums->resize(second + 1);
  const Odometry& reported = frame.input.odometry;
  const Angle turn = frame.truth.heading - frame.before.heading;
  const Point2<Robot> moved = robotFromField(
      {frame.before.position, frame.before.heading + turn * 0.5}, frame.truth.position);
  errors_.forward.reported[second] += reported.forward;
  errors_.left.reported[second] += reported.left;
  errors_.turn.reported[second] += reported.turn.deg();
  errors_.forward.real[second] += moved.y;
  errors_.left.real[second] -= moved.x;
  errors_.turn.real[second] += turn.deg();
}

void SenseRecorder::frame(const WatchedFrame& frame) {
  errors_.seconds = frame.input.time.seconds();
  for (const LandmarkPercept& percept : frame.output.percepts.landmarks)
    addLandmark(percept, frame);
  addBall(frame.output.percepts.ball, frame);
  addStep(frame);
}

}  // namespace kelpie::experiments

// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/pose/LocaliseFilters.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/body/Camera.h"

namespace kelpie::experiments {
namespace {

constexpr double kGross = 50.0;        // cm
constexpr double kNinetyFive = 7.815;  // chi2 with three degrees of freedom
constexpr double kMedian = 2.366;
constexpr double kDegreesOfFreedom = 3.0;

// The step from one pose to the next as perfect odometry would report it.
Odometry trueStep(const Pose2& before, const Pose2& now) {
  Odometry odometry;
  odometry.turn = now.heading - before.heading;
  const Pose2 middle{before.position, before.heading + odometry.turn * 0.5};
  const Point2<Robot> moved = robotFromField(middle, now.position);
  odometry.forward = moved.y;
  odometry.left = -moved.x;
  return odometry;
}

}  // namespace

Listener::Listener(std::string name, const gps::GpsParams& params, const Hearing& hearing,
                   gps::Localise localise)
    : name_(std::move(name)), params_(params), hearing_(hearing), localise_(localise) {}

const WorldModel& Listener::hear(const WatchedFrame& frame) {
  *input_ = frame.input;
  *percepts_ = frame.output.percepts;
  if (!hearing_.lines) percepts_->linePoints.clear();
  if (hearing_.trueOdometry) input_->odometry = trueStep(frame.before, frame.truth);
  percepts_->landmarks.clear();
  for (LandmarkPercept percept : frame.output.percepts.landmarks) {
    const TrueLandmark truth =
        trueLandmark(percept.kind, frame.truth, params_, frame.input.game.team);
    const bool there = isThere(percept, truth);
    if (!hearing_.landmarks || (hearing_.noFalse && !there)) continue;
    if (hearing_.trueDistances && there) percept.distance = truth.distance;
    if (hearing_.trueHeadings && there) percept.heading = truth.heading;
    percepts_->landmarks.push_back(percept);
  }
  *world_ = localise_({*input_, *percepts_, body::step(*input_, {}).camera}, params_, *state_);
  return *world_;
}

TrueLandmark trueLandmark(LandmarkKind kind, const Pose2& robot, const gps::GpsParams& params,
                          TeamColour team) {
  for (const body::Landmark& landmark : body::landmarksFor(params.field, team)) {
    if (landmark.kind != kind) continue;
    const Point2<Robot> p = robotFromField(robot, landmark.position);
    return {p.norm(), bearing(p)};
  }
  return {};
}

bool isThere(const LandmarkPercept& percept, const TrueLandmark& truth) {
  const bool goal =
      percept.kind == LandmarkKind::goalBlue || percept.kind == LandmarkKind::goalYellow;
  const double halfGoal = goal ? maths::atan2(40.0, truth.distance) * 180.0 / maths::kPi : 0.0;
  return (percept.heading - truth.heading).abs().deg() < std::max(10.0, halfGoal) &&
         std::fabs(percept.distance - truth.distance) < truth.distance / 3.0;
}

PoseError poseError(const WorldModel& world, const Pose2& truth) {
  const Point2<Field> away = world.pose.position - truth.position;
  const Angle turned = world.pose.heading - truth.heading;
  const Eigen::Vector3d e(away.x, away.y, turned.rad());
  const Eigen::Matrix3d p = Eigen::Map<const Eigen::Matrix3d>(world.covariance.data());
  PoseError error;
  error.cm = away.norm();
  error.deg = turned.abs().deg();
  error.nees = e.dot(p.inverse() * e);
  return error;
}

void ErrorTrack::add(const PoseError& error) {
  cm.push_back(error.cm);
  deg.push_back(error.deg);
  nees.push_back(error.nees);
}

void ErrorTrack::add(const ErrorTrack& other) {
  append(other.cm, cm);
  append(other.deg, deg);
  append(other.nees, nees);
}

Json ErrorTrack::summary() const {
  return {{"mean_cm", mean(cm)},
          {"median_cm", percentile(cm, 0.5)},
          {"p95_cm", percentile(cm, 0.95)},
          {"mean_deg", mean(deg)},
          {"p95_deg", percentile(deg, 0.95)},
          {"gross_rate", shareAbove(cm, kGross)},
          {"understated_rate", shareAbove(nees, kNinetyFive)},
          {"nees", percentile(nees, 0.5) / kMedian},
          {"nees_mean", mean(nees) / kDegreesOfFreedom}};
}

}  // namespace kelpie::experiments

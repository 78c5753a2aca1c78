// SPDX-License-Identifier: Apache-2.0
// What the robot believes: its own pose with covariance, the other hypotheses, the ball, the other
// robots; and what it has to tell its team.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/types/CameraModel.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/LastingErrors.h"
#include "robot/core/types/ObstacleCells.h"
#include "robot/core/types/TeamEstimates.h"
#include "robot/core/types/TeamMessage.h"

namespace kelpie {

// One Gaussian over (x, y, heading, tilt, roll): covariance of the pose row by row in cm and rad;
// cross of x, y and heading (rows) with tilt and roll.
struct PoseMode {
  double weight = 0.0;
  Pose2 pose;
  std::array<double, 9> covariance{};
  CameraTilt tilt;
  std::array<double, 6> cross{};

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("weight", &PoseMode::weight, "", 0, 1), field("pose", &PoseMode::pose),
                     field("covariance", &PoseMode::covariance, "cm2, cm rad, rad2"),
                     field("tilt", &PoseMode::tilt),
                     field("cross", &PoseMode::cross, "cm rad, rad2"));
  }
};

// The heaviest hypothesis that puts the robot elsewhere, not a copy of the best one.
struct SecondHypothesis {
  bool present = false;
  PoseMode mode;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("present", &SecondHypothesis::present),
                     field("mode", &SecondHypothesis::mode));
  }
};

struct BallEstimate {
  bool present = false;  // seen at least once since the reset and not given up
  Point2<Field> position;
  Point2<Field> velocity;              // cm/s
  std::array<double, 4> covariance{};  // of the position relative to the robot, cm2
  Point2<Robot> relative;              // position in the robot frame
  double distance = 0.0;
  Angle heading;
  double secondsSinceSeen = 0.0;
  std::array<double, 4> fieldCovariance{};  // of the position on the field, the pose's included
  Point2<Field> stoppingPoint;              // where it will lie when nothing stops it

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("present", &BallEstimate::present),
                     field("position", &BallEstimate::position),
                     field("velocity", &BallEstimate::velocity),
                     field("covariance", &BallEstimate::covariance, "cm2"),
                     field("relative", &BallEstimate::relative),
                     field("distance", &BallEstimate::distance, "cm", 0, 1500),
                     field("heading", &BallEstimate::heading, "rad", -180, 180),
                     field("secondsSinceSeen", &BallEstimate::secondsSinceSeen, "s", 0, 1e6),
                     field("fieldCovariance", &BallEstimate::fieldCovariance, "cm2"),
                     field("stoppingPoint", &BallEstimate::stoppingPoint));
  }
};

struct GpsCounts {
  std::uint32_t updates = 0;
  std::array<std::uint16_t, 32> refused{};

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("updates", &GpsCounts::updates), field("refused", &GpsCounts::refused));
  }
};

constexpr std::size_t kMaxModes = 8;

// A pink patch on the outer wall, as mapped.
struct PinkLandmark {
  Point2<Field> position;
  double weight = 0.0;  // sightings, less one every few seconds

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("position", &PinkLandmark::position),
                     field("weight", &PinkLandmark::weight, "", 0, 1e6));
  }
};
constexpr std::size_t kMaxPinks = 16;

struct WorldModel {
  Pose2 pose;                          // mean of the heaviest mode
  std::array<double, 9> covariance{};  // of that mode
  double positionSd = 0.0;             // cm, root of the larger position eigenvalue
  Angle headingSd;
  CameraTilt cameraTilt;  // of that mode
  FocalScale focalScale;
  ImageLag imageLag;
  OdometryErrorEstimate odometryErrors;
  MovedLandmarks movedLandmarks;  // by kind
  double secondsSinceLandmark = 0.0;
  double secondsSinceLines = 0.0;  // since field lines corrected or weighed the modes
  double stuck = 0.0;  // share of the walked way that is thought lost because something holds us
  FixedVector<PoseMode, kMaxModes> modes;  // heaviest first
  SecondHypothesis second;
  BallEstimate ball;
  TeamBall teamBall;
  FixedVector<OpponentEstimate, kOpponents> opponents;  // those known of, in no order
  FixedVector<TeammateEstimate, kTeammates> teammates;  // heard within the last seconds
  ObstacleCells obstacles;
  FixedVector<PinkLandmark, kMaxPinks> pinkMap;  // in the order of their discovery
  TeamMessage message;  // for the team, when its number differs from the last
  GpsCounts counts;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("pose", &WorldModel::pose),
        field("covariance", &WorldModel::covariance, "cm2, cm rad, rad2"),
        field("positionSd", &WorldModel::positionSd, "cm", 0, 1e4),
        field("headingSd", &WorldModel::headingSd, "rad", 0, 180),
        field("cameraTilt", &WorldModel::cameraTilt), field("focalScale", &WorldModel::focalScale),
        field("imageLag", &WorldModel::imageLag),
        field("odometryErrors", &WorldModel::odometryErrors),
        field("movedLandmarks", &WorldModel::movedLandmarks),
        field("secondsSinceLandmark", &WorldModel::secondsSinceLandmark, "s", 0, 1e6),
        field("secondsSinceLines", &WorldModel::secondsSinceLines, "s", 0, 1e6),
        field("stuck", &WorldModel::stuck, "", 0, 1), field("modes", &WorldModel::modes),
        field("second", &WorldModel::second), field("ball", &WorldModel::ball),
        field("teamBall", &WorldModel::teamBall), field("opponents", &WorldModel::opponents),
        field("teammates", &WorldModel::teammates), field("obstacles", &WorldModel::obstacles),
        field("pinkMap", &WorldModel::pinkMap), field("message", &WorldModel::message),
        field("counts", &WorldModel::counts));
  }
};

}  // namespace kelpie

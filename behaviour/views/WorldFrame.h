// SPDX-License-Identifier: Apache-2.0
// What a behaviour sees as `world`: the parts of one frame that it may decide on, copied so that a
// reference kept by a script never dangles (it then shows the newest frame).
#pragma once

#include "behaviour/BehaviourIn.h"
#include "behaviour/BehaviourParams.h"

namespace kelpie::behaviour {

struct HeadAngles {
  Angle neckTilt;
  Angle headPan;
  Angle headNod;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("neckTilt", &HeadAngles::neckTilt, "rad"),
                     field("headPan", &HeadAngles::headPan, "rad"),
                     field("headNod", &HeadAngles::headNod, "rad"));
  }
};

// The near distance is as the base robot would read it.
struct WorldSensors : SensorFrame {
  double headNearThreshold = 20.0;  // a smaller near distance is that of something in the way

  template <int = 0>
  static constexpr auto fields() {
    return SensorFrame::fields().apply([](const auto&... sensed) {
      return fieldList(sensed...,
                       field("headNearThreshold", &WorldSensors::headNearThreshold, "cm"));
    });
  }
};

struct WorldFrame {
  TimeUs time;
  std::uint32_t frame = 0;
  double elapsed = 0.0;
  HeadAngles head;  // as sensed at the exposure
  WorldSensors sensors;
  Stance stance;
  Odometry odometry;
  MotionStatus motion;
  Battery battery;
  GameState game;
  Command lastCommand;
  Percepts percepts;
  Pose2 pose;
  double positionSd = 0.0;
  Angle headingSd;
  double secondsSinceLandmark = 0.0;
  double secondsSinceLines = 0.0;
  std::array<double, 9> covariance{};  // x, y and heading, row by row
  double stuck = 0.0;
  FixedVector<PoseMode, kMaxModes> modes;
  SecondHypothesis second;
  BallEstimate ball;
  TeamBall teamBall;
  FixedVector<OpponentEstimate, kOpponents> opponents;
  FixedVector<TeammateEstimate, kTeammates> teammates;
  ObstacleCells obstacles;
  FixedVector<PinkLandmark, kMaxPinks> pinkMap;
  Task task;
  body::FieldDescription field;

  template <int = 0>
  static constexpr auto fields() {
    using kelpie::field;
    using W = WorldFrame;
    return fieldList(
        field("time", &W::time, "us"), field("frame", &W::frame),
        field("elapsed_s", &W::elapsed, "s"), field("head", &W::head),
        field("sensors", &W::sensors), field("stance", &W::stance), field("odometry", &W::odometry),
        field("motion", &W::motion), field("battery", &W::battery), field("game", &W::game),
        field("lastCommand", &W::lastCommand), field("percepts", &W::percepts),
        field("pose", &W::pose), field("positionSd", &W::positionSd, "cm"),
        field("headingSd", &W::headingSd, "rad"),
        field("secondsSinceLandmark", &W::secondsSinceLandmark, "s"),
        field("secondsSinceLines", &W::secondsSinceLines, "s"), field("stuck", &W::stuck),
        field("covariance", &W::covariance, "cm2, cm rad, rad2"), field("modes", &W::modes),
        field("second", &W::second), field("ball", &W::ball), field("teamBall", &W::teamBall),
        field("opponents", &W::opponents), field("teammates", &W::teammates),
        field("obstacles", &W::obstacles), field("pinkMap", &W::pinkMap), field("task", &W::task),
        field("field", &W::field));
  }
};

void fill(WorldFrame& frame, const BehaviourIn& in);

}  // namespace kelpie::behaviour

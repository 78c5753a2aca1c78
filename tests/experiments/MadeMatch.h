// SPDX-License-Identifier: Apache-2.0
// A match made by hand: robots and ball where a test puts them, frame by frame.
#pragma once

#include "tools/experiments/match/Played.h"

namespace kelpie::experiments {

// A red robot in the middle that looks up the field, a blue one where it is put, and a ball that
// moves so from frame to frame.
struct MadeMatch {
  Played played;
  Pose2 robot{{180.0, 270.0}, Angle::deg(90.0)};
  std::optional<Pose2> opponent;
  Point2<Field> ball{180.0, 290.0};
  MotionKind motion = MotionKind::none;
  bool seesBall = false;  // exactly where it is

  double seconds() const { return kFrameSeconds * static_cast<double>(played.moments.size()); }

  void frame(Point2<Field> velocity) {
    ball = ball + velocity * kFrameSeconds;
    PlayedMoment moment;
    const double now = kFrameSeconds * static_cast<double>(played.moments.size() + 1);
    moment.truth.time = {static_cast<std::int64_t>(1e6 * now)};
    moment.truth.robots.push_back({TeamColour::red, 1, robot, {}});
    if (opponent) moment.truth.robots.push_back({TeamColour::blue, 1, *opponent, {}});
    moment.truth.ball = ball;
    moment.truth.ballVelocity = velocity;
    moment.seen = true;
    moment.motion.running = motion;
    const Point2<Robot> place = robotFromField(robot, ball);
    if (seesBall) {
      moment.ball.present = true;
      moment.ball.distance = place.norm();
      moment.ball.heading = bearing(place);
    }
    played.moments.push_back(moment);
  }
  void rolls(int frames, Point2<Field> velocity) {
    for (int i = 0; i < frames; ++i) frame(velocity);
  }
  // In a direction as a heading over the field.
  void rolls(int frames, double deg, double speed) {
    const Angle way = Angle::deg(deg);
    rolls(frames, {speed * way.cos(), speed * way.sin()});
  }
  // The ball lies in front of the chest while the robot goes and turns, deg in all.
  void carries(int frames, double forward, double turn) {
    for (int i = 0; i < frames; ++i) {
      robot.heading = robot.heading + Angle::deg(turn / frames);
      robot.position = fieldFromRobot(robot, {0.0, forward / frames});
      ball = fieldFromRobot(robot, {0.0, 8.0});
      frame({});
    }
  }
  void happens(sim::EventKind kind) {
    sim::MatchEvent event;
    event.time = {static_cast<std::int64_t>(1e6 * seconds())};
    event.kind = kind;
    played.events.push_back(event);
  }
};

}  // namespace kelpie::experiments

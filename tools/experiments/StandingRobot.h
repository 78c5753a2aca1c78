// SPDX-License-Identifier: Apache-2.0
// A robot that stands somewhere on the field and turns its head from side to side. Its percepts are
// the truth with vision's errors: of single points, shared by all points of a frame, and shared by
// all frames while it stands. Without images, so that thousands of places cost little.
#pragma once

#include <memory>

#include "gps/Localiser.h"
#include "robot/core/Random.h"

namespace kelpie::experiments {

class StandingRobot {
 public:
  // Stands at a random place; the same seed gives the same place, errors and start.
  explicit StandingRobot(std::uint64_t seed);

  // Believes to stand within 40 cm and 20 deg of where it does.
  void believeCoarsely();
  // Sees one frame of its pan, four seconds from side to side and back; landmarks too if asked for.
  void look(bool landmarks);
  WorldModel step();

  Pose2 twin() const;

  Pose2 truth;
  gps::GpsParams params;
  FrameInput input;
  Percepts percepts;
  std::unique_ptr<gps::GpsState> state = std::make_unique<gps::GpsState>();

 private:
  struct SharedError {
    double scale = 1.0;
    double turn = 0.0;  // rad
  };
  void seeLine(const body::FieldLine& line);
  void seeCircle();
  void seeCarpet();
  void seePoint(Point2<Field> place, LinePointKind kind);
  void seeLandmarks();
  bool inView(Point2<Robot> point) const;

  Random random_;
  double pan_ = 0.0;
  SharedError standing_;
  SharedError frame_;
};

// Errors of a belief beside a pose.
struct StandingError {
  double cm = 0.0;
  double deg = 0.0;
  bool within(double maxCm, double maxDeg) const { return cm <= maxCm && deg <= maxDeg; }
};
StandingError standingError(const Pose2& believed, const Pose2& truth);

}  // namespace kelpie::experiments

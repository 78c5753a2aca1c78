// SPDX-License-Identifier: Apache-2.0
// A player whose truth is known: it walks with the simulated body's slip, and its percepts are the
// truth with the errors that vision was measured to have (docs/experiments.md). Without images, so
// that thousands of seconds cost a few.
#pragma once

#include <memory>
#include <vector>

#include "gps/Localiser.h"
#include "robot/core/Random.h"

namespace kelpie::experiments {

struct WalkSpeed {
  double forward = 0.0;  // cm/s
  double left = 0.0;     // cm/s
  double turn = 0.0;     // rad/s
};

struct BallNoise {
  double distanceShare = 0.023;
  double distanceBias = 0.006;
  double heading = 0.15;         // deg
  double walkingHeading = 0.70;  // deg more while walking
  bool sway = false;             // that part swings with the step instead of being drawn anew
};

class TruePlayer {
 public:
  TruePlayer(Pose2 start, std::uint8_t player, std::uint64_t seed);

  // Believes to stand there when it starts; without, it has to find out.
  void believe(Pose2 pose, double positionSd, Angle headingSd);
  // One frame of walking: the truth slips, the odometry is what was asked for.
  void walk(const WalkSpeed& speed);
  void look(double pan);  // rad; forgets the percepts of the last frame
  void seeLandmarks();
  void seeBall(Point2<Field> ball, const BallNoise& noise);
  void seeOpponents(const std::vector<Point2<Field>>& opponents);
  bool inView(Angle heading) const;
  Angle bearingOf(Point2<Field> point) const;
  WorldModel step();
  WorldModel stepAlone();  // the same frame for a second self that hears no messages

  Pose2 truth;
  gps::GpsParams params;
  FrameInput input;
  Percepts percepts;

 private:
  struct Repeated {  // the part of a distance's error that stays for a second
    double share = 0.0;
    double left = 0.0;
  };

  Random random_;
  double pan_ = 0.0;
  double slip_ = 0.0;
  double slipLeft_ = 0.0;
  double phase_ = 0.0;  // of the step
  bool walking_ = false;
  std::vector<Repeated> repeated_;
  std::unique_ptr<gps::GpsState> state_ = std::make_unique<gps::GpsState>();
  std::unique_ptr<gps::GpsState> alone_ = std::make_unique<gps::GpsState>();
};

// Goes to one random place after the other, and never nearer to the others than a robot's length.
class Wanderer {
 public:
  Wanderer(Point2<Field> start, std::uint64_t seed) : position(start), random_(seed) {}

  void step(double speed, const std::vector<Point2<Field>>& others);

  Point2<Field> position;

 private:
  Random random_;
  Point2<Field> target_;
  double timeLeft_ = 0.0;
};

// Carries messages: late by one to three frames, one of ten lost.
class Radio {
 public:
  Radio(std::size_t players, std::uint64_t seed) : lastNumber_(players, 0), random_(seed) {}

  void send(std::size_t from, const TeamMessage& message);
  void pass();  // one frame
  FixedVector<TeamMessage, kTeammates> receive(std::size_t to);

 private:
  struct Letter {
    std::size_t from = 0;
    int frames = 0;
    TeamMessage message;
  };

  std::vector<Letter> underWay_;
  std::vector<std::uint16_t> lastNumber_;
  Random random_;
};

}  // namespace kelpie::experiments

// SPDX-License-Identifier: Apache-2.0
// Players of a match without images: robots whose truth is known (tools/sim/world/Observer.h),
// opponents that wander about, and the radio between the players.
#pragma once

#include <memory>
#include <vector>

#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::experiments {

struct WalkSpeed {
  double forward = 0.0;  // cm/s
  double left = 0.0;     // cm/s
  double turn = 0.0;     // rad/s
};

// Walks with the simulated body's slip and sees what its head is turned to.
class Player : public sim::LocalisingRobot {
 public:
  Player(const Pose2& start, std::uint8_t player, std::uint64_t seed);

  void walk(const WalkSpeed& speed);  // one frame
  void turnHead(double pan);          // rad; forgets the percepts of the last frame
  void seeLandmarks() { lookAround(pan_); }
  void seeOpponents(const std::vector<Point2<Field>>& opponents) {
    lookAtOpponents(opponents, pan_);
  }
  bool inView(Angle heading) const { return Observer::inView(heading, pan_); }
  // The coming frame for a second localiser that gets no messages; before step().
  WorldModel stepAlone();

 private:
  double pan_ = 0.0;
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

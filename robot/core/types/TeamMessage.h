// SPDX-License-Identifier: Apache-2.0
// What robots of one team tell each other, as plain data; how it travels is not said here. All
// points are in the team's own field frame. A sender tells only what its own camera saw, but
// from a pose that may hold the ball of a surer mate (gps/players/BallLandmark.h).
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/TeamNote.h"

namespace kelpie {

constexpr std::size_t kTeammates = 3;
constexpr std::size_t kOpponents = 4;
constexpr std::size_t kSharedObstacles = 24;

// The ball by the sender's own sightings.
struct SharedBall {
  bool present = false;
  Point2<Field> position;
  Point2<Field> velocity;              // cm/s
  std::array<double, 4> covariance{};  // of the position, the sender's pose error included
  double secondsSinceSeen = 0.0;       // when the message was made

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("present", &SharedBall::present),
                     field("position", &SharedBall::position),
                     field("velocity", &SharedBall::velocity),
                     field("covariance", &SharedBall::covariance, "cm2"),
                     field("secondsSinceSeen", &SharedBall::secondsSinceSeen, "s", 0, 1e6));
  }
};

// What the sender's sightings of one opponent since its last message tell together: their product
// as one Gaussian, so that a receiver adds its information.
struct SharedOpponent {
  Point2<Field> position;
  std::array<double, 4> covariance{};

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("position", &SharedOpponent::position),
                     field("covariance", &SharedOpponent::covariance, "cm2"));
  }
};

// A square of 10 cm of the obstacle map.
struct SharedObstacle {
  Point2<Field> position;
  double count = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("position", &SharedObstacle::position),
                     field("count", &SharedObstacle::count, "", 0, 1e4));
  }
};

struct TeamMessage {
  std::uint8_t player = 1;   // of the sender
  std::uint16_t number = 0;  // counts a sender's messages, from 1; 0: not ready to be sent
  double age = 0.0;          // s from its making to the frame that reads it
  Pose2 pose;
  std::array<double, 9> covariance{};  // of (x, y, heading)
  TeamNote note;                       // of the behaviours, in the frame before
  SharedBall ball;
  FixedVector<SharedOpponent, kOpponents> opponents;
  FixedVector<SharedObstacle, kSharedObstacles> obstacles;  // the fullest of the sender's own

  template <int = 0>
  static constexpr auto fields() {
    using M = TeamMessage;
    return fieldList(field("player", &M::player, "", 1, 4), field("number", &M::number),
                     field("age", &M::age, "s", 0, 1e6), field("pose", &M::pose),
                     field("covariance", &M::covariance, "cm2, cm rad, rad2"),
                     field("note", &M::note), field("ball", &M::ball),
                     field("opponents", &M::opponents), field("obstacles", &M::obstacles));
  }
};

}  // namespace kelpie

// SPDX-License-Identifier: Apache-2.0
// What a robot believes of the other robots, and of the ball when its team helps; part of
// WorldModel.h. All points are in the field frame.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/types/Geometry.h"
#include "robot/core/types/TeamNote.h"

namespace kelpie {

// The ball by all of the team who agree, the own sightings among them.
struct TeamBall {
  bool present = false;
  Point2<Field> position;
  Point2<Field> velocity;              // cm/s
  std::array<double, 4> covariance{};  // of the position
  std::uint8_t witnesses = 0;          // whose sightings it is made of
  std::uint8_t outvoted = 0;           // who saw a ball elsewhere
  double secondsSinceSeen = 0.0;       // by the one who saw it last

  template <int = 0>
  static constexpr auto fields() {
    using B = TeamBall;
    return fieldList(field("present", &B::present), field("position", &B::position),
                     field("velocity", &B::velocity), field("covariance", &B::covariance, "cm2"),
                     field("witnesses", &B::witnesses, "", 0, 4),
                     field("outvoted", &B::outvoted, "", 0, 4),
                     field("secondsSinceSeen", &B::secondsSinceSeen, "s", 0, 1e6));
  }
};

struct OpponentEstimate {
  Point2<Field> position;
  std::array<double, 4> covariance{};
  double secondsSinceSeen = 0.0;  // by any of the team

  template <int = 0>
  static constexpr auto fields() {
    using O = OpponentEstimate;
    return fieldList(field("position", &O::position), field("covariance", &O::covariance, "cm2"),
                     field("secondsSinceSeen", &O::secondsSinceSeen, "s", 0, 1e6));
  }
};

// What a team mate last said of itself.
struct TeammateEstimate {
  std::uint8_t player = 1;
  TeamNote note;
  Pose2 pose;
  double positionSd = 0.0;  // cm, grown since it was said
  Angle headingSd;
  double secondsSinceHeard = 0.0;
  double secondsSinceBall = 0.0;  // since it saw the ball itself; 1000 when it knows of none

  template <int = 0>
  static constexpr auto fields() {
    using M = TeammateEstimate;
    return fieldList(field("player", &M::player, "", 1, 4), field("note", &M::note),
                     field("pose", &M::pose), field("positionSd", &M::positionSd, "cm", 0, 1e4),
                     field("headingSd", &M::headingSd, "rad", 0, 180),
                     field("secondsSinceHeard", &M::secondsSinceHeard, "s", 0, 1e6),
                     field("secondsSinceBall", &M::secondsSinceBall, "s", 0, 1e6));
  }
};

}  // namespace kelpie

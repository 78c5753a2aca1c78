// SPDX-License-Identifier: Apache-2.0
// What a person who watches a match orders while it is played, one line each:
//
//   pause                       time stands still
//   resume                      it goes on
//   step N                      so many camera images, then it stands again
//   speed F                     of the clock's; 0: as fast as this machine can
//   ball X,Y                    the ball is put there
//   carry TEAM:PLAYER:X,Y,DEG   a robot is put there as soon as the place is free
//
// Places are those of the red team's field, in cm.
#pragma once

#include <string>
#include <vector>

#include "tools/sim/staging/Staging.h"

namespace kelpie::sim {

struct LiveOrder {
  enum class Kind : std::uint8_t { pause, resume, step, speed, ball, carry };
  Kind kind = Kind::pause;
  int images = 1;      // of step
  double speed = 1.0;  // of speed
  Point2<Field> ball;  // of ball
  RobotPlace place;    // of carry
};

constexpr int kMaxStep = 3000;  // images: 100 s
constexpr double kMaxSpeed = 100.0;

// An error is one line with the words in it.
Expected<LiveOrder> liveOrderFrom(const std::string& line);
std::string wordsFor(const LiveOrder& order);
// Whether a match of these robots can obey.
Status checkOrder(const body::FieldDescription& field, const std::vector<host::AgentHello>& robots,
                  const LiveOrder& order);

}  // namespace kelpie::sim

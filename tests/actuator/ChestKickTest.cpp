// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/ChestKick.h"
#include "tests/actuator/Walker.h"

namespace kelpie::actuator {
namespace {

Walker kicked() {
  Walker w;
  w.standUp();
  Command kick;
  kick.motion = MotionKind::kickForward;
  w.run(kick, 1 + static_cast<int>(chestKickTicks(w.params.kick)) / 4);
  return w;
}

// How far the body is ahead of where it began, by a front foot that stays where it is.
double ahead(const Walker& w, std::size_t tick) {
  return w.params.stance.frontAhead - w.foot(w.ticks[tick], LegId::leftFront).y;
}

TEST(ChestKick, TakesBetweenFourTenthsAndOneSecond) {
  EXPECT_GT(chestKickTicks({}) * 0.008, 0.4);
  EXPECT_LT(chestKickTicks({}) * 0.008, 1.0);
}

TEST(ChestKick, ChestIsThrownForwardAtOneAndAHalfMetresASecond) {
  const Walker w = kicked();
  double fastest = 0.0;
  for (std::size_t t = 1; t < w.ticks.size(); ++t)
    fastest = std::fmax(fastest, (ahead(w, t) - ahead(w, t - 1)) / 0.008);
  EXPECT_GT(fastest, 150.0);
}

TEST(ChestKick, StrikeZoneReachesFromBehindTheStanceToAheadOfIt) {
  const Walker w = kicked();
  double least = 0.0;
  double most = 0.0;
  for (std::size_t t = 0; t < w.ticks.size(); ++t) {
    least = std::fmin(least, ahead(w, t));
    most = std::fmax(most, ahead(w, t));
  }
  EXPECT_NEAR(least, -3.0, 0.05);
  EXPECT_NEAR(most, 6.0, 0.05);
}

TEST(ChestKick, AllFeetStayDownAndNoneDragsAnother) {
  const Walker w = kicked();
  for (std::size_t t = 0; t < w.ticks.size(); ++t) {
    const double body = ahead(w, t);
    for (const LegId leg : kLegs) {
      const auto foot = w.foot(w.ticks[t], leg);
      const bool front = leg == LegId::leftFront || leg == LegId::rightFront;
      const double home = front ? w.params.stance.frontAhead : -w.params.stance.hindBehind;
      ASSERT_NEAR(foot.z, 0.0, 1e-6);
      ASSERT_NEAR(foot.y + body, home, 1e-6);
    }
  }
}

TEST(ChestKick, OdometryOfAWholeKickIsZero) {
  Walker w;
  w.standUp();
  Command kick;
  kick.motion = MotionKind::kickForward;
  w.run(kick, 30);
  double forward = 0.0;
  double farthest = 0.0;
  for (const Odometry& odometry : w.travelled) {
    forward += odometry.forward;
    farthest = std::fmax(farthest, forward);
  }
  EXPECT_NEAR(forward, 0.0, 1e-6);
  EXPECT_GT(farthest, 5.0);
}

TEST(ChestKick, StartedWhileWalkingItBringsTheFeetHome) {
  Walker w;
  w.standUp();
  w.run(WalkRequest{30, 0, 0.5}, 33);
  Command kick;
  kick.motion = MotionKind::kickForward;
  w.run(kick, 40);
  for (const LegId leg : kLegs) {
    const auto foot = w.foot(w.ticks.back(), leg);
    const bool front = leg == LegId::leftFront || leg == LegId::rightFront;
    EXPECT_NEAR(foot.y, front ? w.params.stance.frontAhead : -w.params.stance.hindBehind, 0.2);
  }
}

}  // namespace
}  // namespace kelpie::actuator

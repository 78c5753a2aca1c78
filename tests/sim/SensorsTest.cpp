// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/fields/FieldCheck.h"
#include "tools/sim/bodies/KinematicBodies.h"
#include "tools/sim/bodies/Sensors.h"

namespace kelpie::sim {
namespace {

struct Place {
  std::vector<Obstacle> obstacles = obstaclesOf(*body::fieldDescription("2006"));
  KinematicBodies bodies{{}, *body::fieldDescription("2006")};
  std::vector<BodyPlace> places;

  Place() {
    bodies.putBall({{180, 300}, {}});
    add({{180, 200}, Angle::deg(90)}, 1);
  }
  void add(const Pose2& pose, std::uint64_t seed) { bodies.add({RobotParams{}, pose, seed}); }
  Surroundings around() {
    EXPECT_TRUE(bodies.setObstacles(obstacles));
    places.clear();
    for (std::size_t i = 0; i < bodies.count(); ++i) places.push_back(bodies.place(i));
    return {bodies.ball(), obstacles, places, 0};
  }
  SensorFrame felt(const SensorParams& params, Random& random) {
    const Surroundings now = around();
    return sense(now, bodies.feel(0), params, random);
  }
};

TEST(Sensors, RayStopsAtGroundBallAndGoal) {
  Place place;
  // 10 cm high, falling 1 in 2: the ground is 10 sqrt(5) away.
  const double c = 1.0 / std::sqrt(5.0);
  EXPECT_NEAR(rayDistance(place.around(), {100, 100, 10}, {2 * c, 0, -c}), 10.0 * std::sqrt(5.0),
              1e-9);
  EXPECT_NEAR(rayDistance(place.around(), {180, 250, 4.2}, {0, 1, 0}), 50.0 - 4.2, 1e-9);
  // The blue goal's back wall is at 570 and 0.6 cm thick to each side.
  EXPECT_NEAR(rayDistance(place.around(), {180, 500, 15}, {0, 1, 0}), 69.4, 0.6);
}

TEST(Sensors, StandingStillUpReadsGravity) {
  Place place;
  SensorParams params;
  params.accelerationSd = 0.0;
  Random random(1);
  const SensorFrame frame = place.felt(params, random);
  const double tilt = place.bodies.robot(0).place().stance.bodyTilt.rad();
  EXPECT_NEAR(frame.acceleration[2], 981.0 * std::cos(tilt), 1e-6);
  EXPECT_NEAR(frame.acceleration[0], -981.0 * std::sin(tilt), 1e-6);
  EXPECT_TRUE(frame.paw[0] && frame.paw[1] && frame.paw[2] && frame.paw[3]);
  EXPECT_FALSE(frame.chin);
}

TEST(Sensors, ANoseThatIsNoOtherRobotsReadsAStraightLineOfTheDistance) {
  Place place;
  SensorParams params;
  params.distanceNoise = 0.0;
  Random random(1);
  place.obstacles.push_back({{150.0, 240.0}, {210.0, 240.0}, 1.0});
  const Surroundings around = place.around();
  const BodyFeeling feeling = place.bodies.feel(0);
  const SensorFrame exact = sense(around, feeling, params, random);
  ASSERT_TRUE(exact.headNearDistance > 15.0 && exact.headNearDistance < 45.0);
  const SensorFrame other = sense(around, feeling, params, random, {1.05, -0.5});
  EXPECT_NEAR(other.headNearDistance, 1.05 * exact.headNearDistance - 0.5, 1e-9);
  EXPECT_EQ(other.headFarDistance, exact.headFarDistance);
  EXPECT_EQ(other.chestDistance, exact.chestDistance);
}

TEST(Sensors, ABatteryOf2200MilliamperehoursGivesItsMilliamperesForAnHour) {
  EXPECT_NEAR(drained(1.0, 2200.0, 3600.0, {}), 0.0, 1e-12);
  EXPECT_NEAR(drained(1.0, 1100.0, 1800.0, {}), 0.75, 1e-12);
  EXPECT_EQ(drained(0.001, 2200.0, 3600.0, {}), 0.0);
}

TEST(Sensors, FrameIsInsideItsRanges) {
  Place place;
  Random random(1);
  std::string why;
  for (int i = 0; i < 50; ++i) {
    place.bodies.robot(0).tick();
    EXPECT_TRUE(verify(place.felt({}, random), &why)) << why;
  }
}

// A robot that a hand holds a finger's breadth above the ground, so that only what its paws push
// into can press them. It lies on its belly and looks up the field.
struct Hanging : Place {
  Hanging() {
    bodies.robot(0).lift(1.0);
    bodies.robot(0).tick();
  }
  std::array<bool, kLegCount> paws() {
    Random random(1);
    return felt({}, random).paw;
  }
  Point2<Field> paw(LegId leg, std::size_t robot = 0) const {
    const FieldPoint3 p = bodyParts(bodies.place(robot))[index(leg)].centre;
    return {p.x, p.y};
  }
  void wall(Point2<Field> a, Point2<Field> b) { obstacles.push_back({a, b, 0.6}); }
};

using Paws = std::array<bool, kLegCount>;
constexpr Paws kNone{};
constexpr Paws kLeft{true, false, false, false};
constexpr Paws kRight{false, false, true, false};
constexpr Paws kBothFront{true, false, true, false};

TEST(Sensors, PawsInTheAirFeelNothing) { EXPECT_EQ(Hanging().paws(), kNone); }

TEST(Sensors, APawFeelsAGoalPost) {
  Hanging place;
  const Point2<Field> paw = place.paw(LegId::leftFront);
  place.obstacles.push_back({paw + Point2<Field>{0.0, 2.0}, paw + Point2<Field>{0.0, 2.0}, 1.0});
  EXPECT_EQ(place.paws(), kLeft);
}

TEST(Sensors, APostJustOutOfReachIsNotFelt) {
  Hanging place;
  const Point2<Field> beyond = place.paw(LegId::leftFront) + Point2<Field>{0.0, 2.7};
  place.obstacles.push_back({beyond, beyond, 1.0});
  EXPECT_EQ(place.paws(), kNone);
}

// The three cases of checklist A-4.3.3.1: left, right, both.
TEST(Sensors, AWallIsFeltByThePawsThatReachIt) {
  Hanging ahead, left, right;
  const double front = ahead.paw(LegId::leftFront).y + 1.8;
  ahead.wall({100.0, front}, {260.0, front});
  EXPECT_EQ(ahead.paws(), kBothFront);
  const double side = left.paw(LegId::leftFront).x - 1.8;
  left.wall({side, 195.0}, {side, 300.0});
  EXPECT_EQ(left.paws(), kLeft);
  const double other = right.paw(LegId::rightFront).x + 1.8;
  right.wall({other, 195.0}, {other, 300.0});
  EXPECT_EQ(right.paws(), kRight);
}

TEST(Sensors, APawFeelsAnotherRobotsLeg) {
  Hanging place;
  place.add({{180.0, 212.0}, Angle::deg(-90.0)}, 1);
  EXPECT_EQ(place.paws(), kNone);
  const double gap = place.paw(LegId::rightFront, 1).y - place.paw(LegId::leftFront).y;
  place.bodies.robot(1).push({0.0, 2.5 - gap});
  EXPECT_EQ(place.paws(), kBothFront);
}

TEST(Sensors, FingersPressHeadBackAndChin) {
  Place place;
  Random random(1);
  SensorFrame frame = place.felt({}, random);
  EXPECT_EQ(frame.headTouch, 0.0);
  EXPECT_FALSE(frame.back[0] || frame.back[1] || frame.back[2] || frame.chin);
  place.bodies.robot(0).touch({42.0, {true, false, true}, true});
  frame = place.felt({}, random);
  EXPECT_EQ(frame.headTouch, 42.0);
  EXPECT_TRUE(frame.back[0] && !frame.back[1] && frame.back[2] && frame.chin);
}

}  // namespace
}  // namespace kelpie::sim

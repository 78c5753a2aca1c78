// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "tests/sim/Targets.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {
namespace {

struct Place {
  Place() {
    for (int i = 0; i < 20; ++i) world.tick();
  }
  Pose2 truth(TimeUs time) const { return world.truth(time).robots[0].pose; }
  body::FieldDescription field = *body::fieldDescription("2006");
  World world{WorldParams{}, field, *scenario("empty-goal", field, {{TeamColour::red, 1}}, 3), 3};
};

TEST(World, ACarriedRobotIsThereAtOnceAndNoImageShowsTheWay) {
  Place place;
  const Pose2 there{{30.0, 500.0}, Angle::deg(-100.0)};
  ASSERT_TRUE(place.world.carry(0, there));
  for (const std::int64_t back : {0, 16667, 40000}) {
    const Pose2 seen = place.truth({place.world.time().us - back});
    EXPECT_NEAR(distance(seen.position, there.position), 0.0, 1e-9);
    EXPECT_NEAR((seen.heading - there.heading).deg(), 0.0, 1e-9);
  }
  for (int i = 0; i < 20; ++i) place.world.tick();
  EXPECT_LT(distance(place.truth(place.world.time()).position, there.position), 1.0);
}

TEST(World, ACarriedRobotDoesNotHitTheBallOnTheWay) {
  Place place;
  const Point2<Field> ball = place.world.ball().position;
  ASSERT_TRUE(place.world.carry(0, {{ball.x - 60.0, ball.y}, Angle()}));
  place.world.tick();
  ASSERT_TRUE(place.world.carry(0, {{ball.x + 60.0, ball.y}, Angle()}));
  for (int i = 0; i < 20; ++i) place.world.tick();
  EXPECT_NEAR(distance(place.world.ball().position, ball), 0.0, 1e-9);
}

TEST(World, APlaceThatNoRobotCanStandOnIsRefused) {
  Place place;
  const Pose2 before = place.truth(place.world.time());
  EXPECT_FALSE(place.world.carry(1, before));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(place.world.carry(0, {{nan, 100.0}, Angle()}));
  EXPECT_FALSE(place.world.carry(0, {{100.0, 100.0}, Angle::rad(nan)}));
  EXPECT_FALSE(place.world.carry(0, {{-200.0, 100.0}, Angle()}));
  EXPECT_FALSE(place.world.carry(0, {{100.0, 1000.0}, Angle()}));
  EXPECT_NEAR(distance(place.truth(place.world.time()).position, before.position), 0.0, 1e-9);
}

const SensorFrame& felt(const Place& place) { return place.world.sensors(0).back(); }

TEST(World, ALiftedRobotFeelsTheHandAndNoGround) {
  Place place;
  EXPECT_FALSE(felt(place).back[1]);
  EXPECT_TRUE(felt(place).paw[0]);
  const double height = place.world.truth(place.world.time()).robots[0].stance.shoulderHeight;
  ASSERT_TRUE(place.world.lift(0, 12.0));
  for (int i = 0; i < 8; ++i) place.world.tick();
  EXPECT_TRUE(felt(place).back[1]);
  for (const bool paw : felt(place).paw) EXPECT_FALSE(paw);
  EXPECT_NEAR(place.world.truth(place.world.time()).robots[0].stance.shoulderHeight, height + 12.0,
              1e-9);
  ASSERT_TRUE(place.world.lift(0, 0.0));
  place.world.tick();
  EXPECT_FALSE(felt(place).back[1]);
  EXPECT_TRUE(felt(place).paw[0]);
}

TEST(World, ACarriedRobotFeelsTheHandForAFifthOfASecond) {
  Place place;
  ASSERT_TRUE(place.world.carry(0, {{100.0, 100.0}, Angle()}));
  place.world.tick();
  EXPECT_TRUE(felt(place).back[1]);
  for (int i = 0; i < 25; ++i) place.world.tick();
  EXPECT_FALSE(felt(place).back[1]);
}

TEST(World, TouchesReachTheSensorsUntilTheNextCall) {
  Place place;
  ASSERT_TRUE(place.world.touch(0, {30.0, {false, false, true}, false}));
  place.world.tick();
  EXPECT_EQ(felt(place).headTouch, 30.0);
  EXPECT_TRUE(felt(place).back[2]);
  ASSERT_TRUE(place.world.touch(0, {}));
  place.world.tick();
  EXPECT_EQ(felt(place).headTouch, 0.0);
}

TEST(World, LiftsAndTouchesThatCannotBeAreRefused) {
  Place place;
  EXPECT_FALSE(place.world.lift(1, 5.0));
  EXPECT_FALSE(place.world.lift(0, -1.0));
  EXPECT_FALSE(place.world.lift(0, 16.0));
  EXPECT_FALSE(place.world.lift(0, std::nan("")));
  EXPECT_FALSE(place.world.touch(1, {}));
  EXPECT_FALSE(place.world.touch(0, {81.0, {}, false}));
  EXPECT_FALSE(place.world.touch(0, {std::nan(""), {}, false}));
}

// Legs that stand, the head as asked for.
JointAngles standing(double tilt, double pan, double nod) {
  const Stance stance{10.0, Angle::deg(10.0), {}};
  JointAngles joints;
  setFrontFeet(joints, stance, {Point2<Robot>{-9.5, 4.0}, {9.5, 0.0}});
  for (const LegId leg : {LegId::leftHind, LegId::rightHind}) {
    const double side = leg == LegId::leftHind ? -10.0 : 10.0;
    const auto foot = body::torsoFromRobot(stance, {side, -13.0, 0.0});
    body::setLegAngles(joints, leg, body::reachFoot(leg, foot).angles);
  }
  joints[Joint::neckTilt] = Angle::deg(tilt);
  joints[Joint::headPan] = Angle::deg(pan);
  joints[Joint::headNod] = Angle::deg(nod);
  return joints;
}

// What the first of two red robots sees after half a second, the other 65 cm before it.
std::unique_ptr<Image> seen(const WorldParams& params, const JointAngles& joints) {
  Setup setup;
  setup.players.push_back({TeamColour::red, 1, {{180.0, 200.0}, Angle::deg(90.0)}});
  setup.players.push_back({TeamColour::red, 2, {{186.0, 265.0}, Angle::deg(0.0)}});
  setup.ball = {20.0, 20.0};
  World world(params, *body::fieldDescription("2006"), setup, 5);
  world.bodies().command(0, targets(joints));
  for (int i = 0; i < 60; ++i) world.tick();
  auto image = std::make_unique<Image>();
  world.render(0, world.time(), *image);
  return image;
}

bool same(const Image& a, const Image& b) { return a.y == b.y && a.cr == b.cr && a.cb == b.cb; }

TEST(World, ShineCentresAndOwnLegsCanEachBeLeftOut) {
  const JointAngles ahead = standing(-10, 0, 0);
  const JointAngles down = standing(-75, 45, -10);
  const auto before = seen({}, ahead);
  EXPECT_TRUE(same(*before, *seen({}, ahead)));
  WorldParams matt, centred, blind;
  matt.shine.on = false;
  centred.camera.artefacts.centres = false;
  blind.ownLegs = false;
  EXPECT_FALSE(same(*before, *seen(matt, ahead)));
  EXPECT_FALSE(same(*before, *seen(centred, ahead)));
  EXPECT_TRUE(same(*before, *seen(blind, ahead)));
  EXPECT_FALSE(same(*seen({}, down), *seen(blind, down)));
}

TEST(World, AnImageOfTheKeptPastDoesNotShowWhatMovedSince) {
  sim::Setup setup;
  setup.players.push_back({TeamColour::red, 1, {{180.0, 200.0}, Angle::deg(90.0)}});
  setup.players.push_back({TeamColour::blue, 2, {{186.0, 265.0}, Angle::deg(0.0)}});
  setup.ball = {185.0, 235.0};
  const auto shown = [&setup](int ticksSince) {
    World world({}, *body::fieldDescription("2006"), setup, 5);
    for (int i = 0; i < 20; ++i) world.tick();
    const Past past = world.past();
    const TimeUs end = world.time();
    for (int i = 0; i < ticksSince; ++i) {
      world.shove(0, {1.0, 0.0}, Angle::deg(2.0));
      world.shove(1, {1.0, 0.0}, {});
      world.putBall({{100.0, 300.0}, {}});
      world.tick();
    }
    auto image = std::make_unique<Image>();
    world.render(0, past, end, *image);
    return image;
  };
  EXPECT_TRUE(same(*shown(0), *shown(4)));
}

}  // namespace
}  // namespace kelpie::sim

// SPDX-License-Identifier: Apache-2.0
// What a walking robot's body and legs do when something holds it, and with weak legs.
#include <gtest/gtest.h>

#include "tools/sim/bodies/WalkingBody.h"

namespace kelpie::sim {
namespace {

struct Walk {
  double cm = 0.0;       // true way
  double effort = 0.0;   // mean
  double current = 0.0;  // mA, mean
};

Walk walked(WalkingBody& body, const WalkRequest& walk) {
  constexpr int kMessages = 60;
  Command command;
  command.walk = walk;
  Walk sum;
  const Pose2 from = body.pose();
  for (int i = 0; i < kMessages; ++i) {
    sum.effort += body.step(command).status.effort / kMessages;
    sum.current += body.world().batteryCurrent(0) / kMessages;
  }
  sum.cm = distance(body.pose().position, from.position);
  return sum;
}

const WalkRequest kAhead{20.0, 0.0, 0.0};

TEST(Resistance, AHeldRobotGoesNowhereAndItsLegsWorkHarder) {
  WalkingBody free(3);
  WalkingBody held(3);
  ASSERT_TRUE(held.world().hold(0, 1.0));
  const Walk a = walked(free, kAhead);
  const Walk b = walked(held, kAhead);
  EXPECT_GT(a.cm, 30.0);
  EXPECT_LT(b.cm, 1.0);
  EXPECT_GT(b.effort, 1.2 * a.effort);
  EXPECT_GT(b.current, 1.2 * a.current);
}

TEST(Resistance, TheMoreItIsHeldTheLessItGoes) {
  double last = 1e9;
  for (const double share : {0.0, 0.3, 0.6, 0.9}) {
    WalkingBody body(4);
    ASSERT_TRUE(body.world().hold(0, share));
    const double cm = walked(body, kAhead).cm;
    EXPECT_LT(cm, last);
    last = cm;
  }
}

TEST(Resistance, AWallStopsTheBodyAndIsFelt) {
  WalkingBody free(5);
  WalkingBody blocked(5);
  ASSERT_TRUE(blocked.world().carry(0, {{130.0, 550.0}, Angle::deg(0.0)}));  // beside the goal
  const Walk a = walked(free, kAhead);
  const Walk b = walked(blocked, kAhead);
  EXPECT_LT(b.cm, 0.5 * a.cm);
  EXPECT_GT(b.effort, 1.2 * a.effort);
}

TEST(Resistance, AFreeRobotWalksAsIfNobodyEverHeldOne) {
  WalkingBody one(6);
  WalkingBody other(6);
  ASSERT_TRUE(other.world().hold(0, 0.0));
  walked(one, kAhead);
  walked(other, kAhead);
  EXPECT_EQ(one.pose().position.x, other.pose().position.x);
  EXPECT_EQ(one.pose().position.y, other.pose().position.y);
}

TEST(Resistance, HoldsThatCannotBeAreRefused) {
  WalkingBody body(7);
  EXPECT_FALSE(body.world().hold(1, 0.5));
  EXPECT_FALSE(body.world().hold(0, 1.5));
  EXPECT_FALSE(body.world().hold(0, std::nan("")));
  EXPECT_FALSE(body.world().shove(0, {std::nan(""), 0.0}, Angle()));
}

TEST(Resistance, AShovedRobotMovesAndTurnsByThat) {
  WalkingBody body(8);
  const Pose2 before = body.pose();
  ASSERT_TRUE(body.world().shove(0, {5.0, -3.0}, Angle::deg(20.0)));
  body.step({});
  EXPECT_NEAR(body.pose().position.x - before.position.x, 5.0, 0.1);
  EXPECT_NEAR(body.pose().position.y - before.position.y, -3.0, 0.1);
  EXPECT_NEAR((body.pose().heading - before.heading).deg(), 20.0, 0.1);
}

TEST(Resistance, WeakLegsTurnAboutHalfAsFar) {
  actuator::ActuatorParams alike;  // the same feet, weak or not
  alike.walks.weak = alike.walks.normal;
  WalkingBody strong(9, alike);
  WalkingBody weak(9, alike);
  weak.wearOut();
  Command turn;
  turn.walk.turn = 1.2;
  for (int i = 0; i < 150; ++i) {
    strong.step(turn);
    weak.step(turn);
  }
  const auto turned = [&turn](WalkingBody& body) {
    double rad = 0.0;
    for (int i = 0; i < 100; ++i) {
      const Angle before = body.pose().heading;
      body.step(turn);
      rad += (body.pose().heading - before).rad();
    }
    return rad;
  };
  EXPECT_NEAR(turned(weak) / turned(strong), 0.5, 0.1);
}

// Of two seconds' messages, those in which a front paw is pressed though its leg swings.
int pressedWhileSwinging(WalkingBody& body, const WalkRequest& walk) {
  Command command;
  command.walk = walk;
  int count = 0;
  for (int i = 0; i < 60; ++i) {
    body.step(command);
    const SensorFrame& now = body.world().sensors(0).back();
    for (const LegId leg : {LegId::leftFront, LegId::rightFront})
      count += now.paw[index(leg)] && !body.world().bodies().onGround(0)[index(leg)] ? 1 : 0;
  }
  return count;
}

TEST(Resistance, APawThatSwingsIntoAWallIsPressed) {
  WalkingBody free(5);
  WalkingBody blocked(5);
  ASSERT_TRUE(blocked.world().carry(0, {{130.0, 550.0}, Angle::deg(0.0)}));
  EXPECT_EQ(pressedWhileSwinging(free, kAhead), 0);
  EXPECT_GT(pressedWhileSwinging(blocked, kAhead), 4);
}

TEST(Resistance, ALiftedRobotWalksInTheAir) {
  WalkingBody body(6);
  ASSERT_TRUE(body.world().lift(0, 5.0));
  EXPECT_EQ(walked(body, kAhead).cm, 0.0);
  ASSERT_TRUE(body.world().lift(0, 0.0));
  EXPECT_GT(walked(body, kAhead).cm, 20.0);
}

TEST(Resistance, TwoRobotsThatPushEachOtherGiveWayAlike) {
  const auto field = *body::fieldDescription("2006");
  sim::Setup setup;
  setup.players.push_back({TeamColour::red, 1, {{180.0, 200.0}, Angle::deg(90.0)}});
  setup.players.push_back({TeamColour::blue, 1, {{183.0, 210.0}, Angle::deg(90.0)}});
  setup.ball = {20.0, 20.0};
  World world(WorldParams{}, field, setup, 1);
  const Point2<Field> a = world.bodies().place(0).pose.position;
  const Point2<Field> b = world.bodies().place(1).pose.position;
  world.tick();
  const double first = distance(world.bodies().place(0).pose.position, a);
  const double second = distance(world.bodies().place(1).pose.position, b);
  EXPECT_GT(first, 0.5);
  EXPECT_NEAR(first, second, 0.2 * first);
}

}  // namespace
}  // namespace kelpie::sim

// SPDX-License-Identifier: Apache-2.0
// What the player without Python asks of the body.
#include <gtest/gtest.h>

#include <memory>

#include "behaviour/Behaviour.h"
#include "robot/body/Lights.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/object/SimplePlayer.h"

namespace kelpie::object {
namespace {

class SimplePlayer : public testing::Test {
 protected:
  Command next() { return step({*input, *percepts, world, field}, state); }
  void seeBall(double distance, double degrees) {
    world.ball.present = true;
    world.ball.distance = distance;
    world.ball.heading = Angle::deg(degrees);
    world.ball.relative = {-distance * maths::sin(Angle::deg(degrees).rad()),
                           distance * maths::cos(Angle::deg(degrees).rad())};
    world.ball.secondsSinceSeen = 0.0;
  }

  std::unique_ptr<FrameInput> input = std::make_unique<FrameInput>();
  std::unique_ptr<Percepts> percepts = std::make_unique<Percepts>();
  WorldModel world;
  body::FieldDescription field = *body::fieldDescription("2006");
  SimpleState state;
};

TEST_F(SimplePlayer, LooksAtTheBallAndWalksToIt) {
  seeBall(100.0, 10.0);
  const Command command = next();
  EXPECT_GT(command.walk.forward, 20.0);
  EXPECT_GT(command.walk.turn, 0.0);
  EXPECT_EQ(command.head.aim, HeadAim::point);
  EXPECT_EQ(command.head.target.x, world.ball.relative.x);
  EXPECT_EQ(command.head.target.y, world.ball.relative.y);
}

TEST_F(SimplePlayer, TurnsOnTheSpotToABallBesideIt) {
  seeBall(100.0, -90.0);
  const Command command = next();
  EXPECT_EQ(command.walk.forward, 0.0);
  EXPECT_LT(command.walk.turn, 0.0);
}

TEST_F(SimplePlayer, LooksForALostBallWhereItWasLast) {
  seeBall(100.0, -20.0);
  next();
  world.ball.secondsSinceSeen = 2.5;
  EXPECT_LT(next().walk.turn, 0.0);
  seeBall(100.0, 20.0);
  next();
  world.ball.present = false;
  const Command command = next();
  EXPECT_GT(command.walk.turn, 0.0);
  EXPECT_GT(command.head.headPan.deg(), 0.0);
}

TEST_F(SimplePlayer, GetsUpFromEachSideAndAsksOnceForIt) {
  const std::pair<FallSide, MotionKind> ways[] = {{FallSide::front, MotionKind::getUpFront},
                                                  {FallSide::back, MotionKind::getUpBack},
                                                  {FallSide::left, MotionKind::getUpLeft},
                                                  {FallSide::right, MotionKind::getUpRight}};
  for (const auto& [side, motion] : ways) {
    state = {};
    input->motion.feeling.fallen = side;
    EXPECT_EQ(next().motion, motion);
    EXPECT_EQ(next().motion, MotionKind::none);  // between two motions a frame asks for none
    EXPECT_EQ(next().motion, motion);
  }
  input->motion.running = MotionKind::getUpLeft;
  const Command command = next();
  EXPECT_EQ(command.motion, MotionKind::none);
  EXPECT_EQ(command.walk.forward, 0.0);
}

TEST_F(SimplePlayer, StandsWhilePlayIsHaltedOrItIsPenalised) {
  seeBall(100.0, 0.0);
  input->game.state = PlayState::set;
  EXPECT_EQ(next().walk.forward, 0.0);
  input->game.state = PlayState::playing;
  input->game.penalised = true;
  EXPECT_EQ(next().walk.forward, 0.0);
}

TEST_F(SimplePlayer, AsksNothingOutsideTheRangesAndSaysWhy) {
  for (double degrees = -180.0; degrees < 180.0; degrees += 15.0) {
    for (const double distance : {0.0, 10.0, 500.0}) {
      seeBall(distance, degrees);
      const Command command = next();
      std::string why;
      EXPECT_TRUE(verify(command, &why)) << why;
      ASSERT_EQ(command.trace.size(), 1U);
      EXPECT_EQ(command.trace[0].module.view(), "simple");
    }
  }
}

TEST_F(SimplePlayer, ShowsAlwaysThatItIsNotTheOneInPython) {
  for (const PlayState play : {PlayState::initial, PlayState::set, PlayState::playing}) {
    input->game.state = play;
    EXPECT_EQ(next().leds, body::kLightBackMiddle);
    EXPECT_EQ(body::lights(input->game, Role::attacker, next().leds) & body::kLightBackMiddle,
              body::kLightBackMiddle);
  }
}

TEST_F(SimplePlayer, StandsBehindTheInterfaceOfTheBehaviours) {
  seeBall(100.0, 0.0);
  behaviour::BehaviourState behaviours("no such folder");
  EXPECT_EQ(behaviours.lastError(), "");
  EXPECT_GT(behaviour::step({*input, *percepts, world, field}, {}, behaviours).walk.forward, 20.0);
  EXPECT_FALSE(behaviours.ask("tree"));
}

}  // namespace
}  // namespace kelpie::object

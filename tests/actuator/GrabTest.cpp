// SPDX-License-Identifier: Apache-2.0
// The motions that grab: how long they take, where they put the head, and that one which is hurried
// goes on twice as fast from where it is (thesis 2006 section 6.3.5).
#include <gtest/gtest.h>

#include "tests/actuator/Walker.h"

namespace kelpie::actuator {
namespace {

constexpr double kFrame = 1.0 / 30.0;  // s of the camera
constexpr int kMessages = 40;          // longer than any grab

// As a script does: asks until the motion runs, and then for what `asked` says of its message.
struct Grabber {
  Walker walker;
  int begun = 0;  // messages since it runs

  Grabber() { walker.standUp(); }
  MotionKind running() const { return walker.out.status.running; }
  // Messages that it has run.
  template <class Asked>
  int grab(MotionKind kind, Asked&& asked) {
    Command command;
    command.head.headPan = Angle::deg(20.0);
    for (int i = 0; i < kMessages; ++i) {
      command.motion = begun == 0 ? kind : asked(begun);
      walker.run(command, 1);
      begun += running() != MotionKind::none ? 1 : 0;
      if (begun > 0 && running() == MotionKind::none) break;
    }
    return begun;
  }
};

constexpr auto kNothing = [](int) { return MotionKind::none; };
constexpr auto kQuick = [](int) { return MotionKind::grabQuick; };

double secondsOf(MotionKind kind) { return kTickSeconds * ticksOf(standardMotions()[kind]); }

TEST(Grab, TakesTwelveFramesAndTheQuickOneSix) {
  EXPECT_NEAR(secondsOf(MotionKind::grab) / kFrame, 12.0, 0.01);
  EXPECT_NEAR(secondsOf(MotionKind::grabLift) / kFrame, 12.0, 0.01);
  EXPECT_NEAR(secondsOf(MotionKind::grabQuick) / kFrame, 6.0, 0.01);
}

TEST(Grab, HurriedFromItsStartTakesHalfTheTime) {
  for (const MotionKind kind : {MotionKind::grab, MotionKind::grabLift}) {
    Grabber slow, fast;
    const int all = slow.grab(kind, kNothing);
    EXPECT_NEAR(fast.grab(kind, kQuick), 0.5 * all, 1.0);
  }
}

TEST(Grab, HurriedMidwayGoesOnFromWhereItIs) {
  Grabber slow, fast;
  const int all = slow.grab(MotionKind::grabLift, kNothing);
  const int first = all / 2;
  const auto later = [&](int begun) {
    return begun < first ? MotionKind::none : MotionKind::grabQuick;
  };
  EXPECT_NEAR(fast.grab(MotionKind::grabLift, later), first + 0.5 * (all - first), 1.0);
}

TEST(Grab, IsHurriedOnlyWhileItIsAsked) {
  Grabber slow, fast;
  const int all = slow.grab(MotionKind::grab, kNothing);
  const auto fourMessages = [](int begun) {
    return begun >= 2 && begun < 6 ? MotionKind::grabQuick : MotionKind::none;
  };
  EXPECT_NEAR(fast.grab(MotionKind::grab, fourMessages), all - 4, 1.0);
}

TEST(Grab, KeepsItsKindAndTellsTheTimeThatIsLeftWhileItIsHurried) {
  Grabber grabber;
  const auto watched = [&](int) {
    EXPECT_EQ(grabber.running(), MotionKind::grab);
    return MotionKind::grabQuick;
  };
  grabber.walker.run(Command{}, 1);
  Command command;
  command.motion = MotionKind::grab;
  while (grabber.running() == MotionKind::none) grabber.walker.run(command, 1);
  const double left = grabber.walker.out.status.secondsLeft;
  command.motion = MotionKind::grabQuick;
  grabber.walker.run(command, 1);
  EXPECT_NEAR(grabber.walker.out.status.secondsLeft, 0.5 * left - 0.032, 0.01);
  grabber.begun = 1;
  grabber.grab(MotionKind::grab, watched);
}

TEST(Grab, AHurriedOneIsNotFollowedByTheQuickOne) {
  Grabber grabber;
  grabber.grab(MotionKind::grab, kQuick);
  Command command;
  command.motion = MotionKind::grabQuick;
  grabber.walker.run(command, 10);
  EXPECT_EQ(grabber.running(), MotionKind::none);
}

// What the thesis has of neck and mouth, by the share of the motion: 3, 3 and 6 frames.
TEST(GrabLift, LiftsTheHeadThenDropsItThenOpensTheMouth) {
  Grabber grabber;
  const auto& frames = standardMotions()[MotionKind::grabLift].frames;
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_NEAR(frames[0].head[0].deg(), -60.0, 1e-9);
  EXPECT_NEAR(frames[1].head[0].deg(), -40.0, 1e-9);
  EXPECT_NEAR(frames[2].head[0].deg(), -40.0, 1e-9);
  EXPECT_LT(frames[2].mouth.deg(), -50.0);
  EXPECT_GT(frames[1].mouth.deg(), -5.0);
  EXPECT_NEAR(frames[0].ticks * kTickSeconds / kFrame, 3.0, 0.2);
  EXPECT_NEAR(frames[1].ticks * kTickSeconds / kFrame, 3.0, 0.2);
}

TEST(GrabLift, PanGoesToTheBallAndThatOfTheOtherGrabsAhead) {
  Grabber lift, plain;
  lift.grab(MotionKind::grabLift, kNothing);
  EXPECT_NEAR(lift.walker.state.target[Joint::headPan].deg(), 20.0, 1e-6);
  const auto still = [&](int) {
    EXPECT_NEAR(plain.walker.state.target[Joint::headPan].deg(), 0.0, 1e-6);
    return MotionKind::none;
  };
  Command ahead;
  plain.walker.run(ahead, 10);
  plain.grab(MotionKind::grab, still);
}

TEST(GrabLift, NeckIsWhereItsFramesSayAndTheLegsWalkStraightAhead) {
  Grabber grabber;
  double lowest = 0.0;
  double last = 0.0;
  const auto watch = [&](int) {
    last = grabber.walker.state.target[Joint::neckTilt].deg();
    lowest = std::fmin(lowest, last);
    EXPECT_GE(grabber.walker.state.walk.feet.forward, 0.0);
    EXPECT_NEAR(grabber.walker.state.walk.feet.turn, 0.0, 0.05);
    return MotionKind::none;
  };
  grabber.grab(MotionKind::grabLift, watch);
  EXPECT_NEAR(lowest, -60.0, 1e-6);
  EXPECT_NEAR(last, -40.0, 1e-6);
}

}  // namespace
}  // namespace kelpie::actuator

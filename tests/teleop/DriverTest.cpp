// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "robot/core/fields/FieldCheck.h"
#include "tools/teleop/Driver.h"
#include "tools/teleop/StatusLine.h"

namespace kelpie::teleop {
namespace {

struct Drive {
  Drive() { view->motion.ready = true; }
  Command next() { return view->command = driver.next(*view); }
  Command press(const std::string& keys) {
    for (const char key : keys) driver.press(key);
    return next();
  }
  Driver driver;
  std::unique_ptr<host::DriverView> view = std::make_unique<host::DriverView>();
};

TEST(TeleopDriver, SpeedsGoByStepsAndSpaceStops) {
  Drive drive;
  const Command command = drive.press("wwaqe");
  EXPECT_EQ(command.walk.forward, 10.0);
  EXPECT_EQ(command.walk.left, 0.0);
  EXPECT_NEAR(command.walk.turn, 20.0 * maths::kPi / 180.0, 1e-12);
  EXPECT_EQ(drive.press("s").walk.forward, 5.0);
  const WalkRequest stopped = drive.press(" ").walk;
  EXPECT_TRUE(stopped.forward == 0.0 && stopped.left == 0.0 && stopped.turn == 0.0);
}

TEST(TeleopDriver, NoNumberOfKeysLeavesTheRanges) {
  for (const char key : std::string("wsadqeijkl")) {
    Drive drive;
    std::string why;
    EXPECT_TRUE(verify(drive.press(std::string(40, key)), &why)) << key << ": " << why;
  }
}

TEST(TeleopDriver, HeadTurnsLeftAndLooksAhead) {
  Drive drive;
  EXPECT_NEAR(drive.press("jj").head.direction.deg(), 30.0, 1e-12);
  EXPECT_NEAR(drive.press("i").head.elevation.deg(), -10.0, 1e-12);
  EXPECT_EQ(drive.press("m").head.direction.deg(), 0.0);
}

TEST(TeleopDriver, MotionIsAskedForUntilItRuns) {
  Drive drive;
  EXPECT_EQ(drive.press("1").motion, MotionKind::kickForward);
  EXPECT_EQ(drive.next().motion, MotionKind::kickForward);
  drive.view->motion.running = MotionKind::kickForward;
  EXPECT_EQ(drive.next().motion, MotionKind::none);
  drive.view->motion.running = MotionKind::none;
  EXPECT_EQ(drive.next().motion, MotionKind::none);
}

TEST(TeleopDriver, SecondMotionWaitsForTheFirst) {
  Drive drive;
  drive.view->motion.running = MotionKind::cheer;
  EXPECT_EQ(drive.press("1").motion, MotionKind::none);
  drive.view->motion.running = MotionKind::none;
  EXPECT_EQ(drive.next().motion, MotionKind::kickForward);
}

TEST(TeleopDriver, MotionThatNeverStartsIsGivenUp) {
  Drive drive;
  drive.press("1");
  for (int i = 0; i < 100; ++i) drive.next();
  EXPECT_EQ(drive.next().motion, MotionKind::none);
}

TEST(TeleopDriver, GrabbedBallIsHeldUntilItIsReleased) {
  Drive drive;
  drive.press("w");
  Command command = drive.press("g");
  EXPECT_EQ(command.motion, MotionKind::grab);
  EXPECT_EQ(command.walk.forward, 0.0);
  drive.view->motion.running = MotionKind::grab;
  drive.next();
  drive.view->motion.running = MotionKind::none;
  command = drive.press("a");
  EXPECT_EQ(command.walk.kind, WalkKind::dribble);
  EXPECT_TRUE(command.mouthOpen);
  EXPECT_GT(command.walk.turn, 0.0);
  EXPECT_TRUE(drive.press("r").mouthOpen);  // until the release runs
  drive.view->motion.running = MotionKind::release;
  EXPECT_FALSE(drive.next().mouthOpen);
}

TEST(TeleopDriver, FallenRobotGetsUpFromTheSideItLiesOn) {
  Drive drive;
  EXPECT_EQ(drive.press("u").motion, MotionKind::none);  // it stands
  drive.view->motion.feeling.fallen = FallSide::left;
  EXPECT_EQ(drive.next().motion, MotionKind::none);
  const Command command = drive.press("wu");
  EXPECT_EQ(command.motion, MotionKind::getUpLeft);
  EXPECT_EQ(command.walk.forward, 0.0);
}

TEST(TeleopDriver, OnlyXQuits) {
  Drive drive;
  drive.press("wasd?X");
  EXPECT_FALSE(drive.driver.hasQuit());
  drive.press("x");
  EXPECT_TRUE(drive.driver.hasQuit());
}

TEST(TeleopStatus, LineTellsWhatIsDoneSeenAndFelt) {
  Drive drive;
  drive.view->time = TimeUs::fromSeconds(12.3);
  drive.press("ws");
  EXPECT_EQ(statusLine(*drive.view), "  12.3 s  stands  no ball  head  down 20 deg");
  drive.view->ball.present = true;
  drive.view->ball.distance = 85.0;
  drive.view->ball.heading = Angle::deg(-12.0);
  drive.press("wwd1m");
  EXPECT_EQ(statusLine(*drive.view),
            "  12.3 s  kick asked for  ahead 10 cm/s  turn right 20 deg/s"
            "  ball 85 cm 12 deg right  head  down 20 deg");
  drive.view->motion.running = MotionKind::kickForward;
  drive.view->motion.secondsLeft = 0.25;
  drive.view->motion.feeling.fallen = FallSide::back;
  drive.view->motion.feeling.ballHeld = true;
  EXPECT_EQ(statusLine(*drive.view).substr(0, 36), "  12.3 s  FALLEN on its back  kick 0");
  EXPECT_NE(statusLine(*drive.view).find("ball HELD"), std::string::npos);
}

}  // namespace
}  // namespace kelpie::teleop

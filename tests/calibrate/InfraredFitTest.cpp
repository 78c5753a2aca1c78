// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tools/calibrate/infrared/InfraredFit.h"

namespace kelpie::calibrate {
namespace {

const HeadPose kBall{{-52.0, 0.0, 45.0}, true};

HeadPose looking(double neck) { return {{neck, 0.0, 0.0}, false}; }

// Seconds of frames in one pose, from where the moments before end.
void hold(const HeadPose& pose, double reading, double seconds, std::vector<CarpetMoment>& all) {
  const double from = all.empty() ? 0.0 : all.back().seconds + 1.0 / 30.0;
  for (double s = 0.0; s < seconds; s += 1.0 / 30.0) all.push_back({from + s, true, pose, reading});
}

// What robots read whose sensors give `gain` times the distance and `offset` cm more.
CarpetLog logOf(double gain, double offset) {
  CarpetLog log;
  const std::vector<std::pair<HeadPose, double>> distances{
      {kBall, 28.0}, {looking(-30.0), 11.0}, {looking(-20.0), 18.0}, {looking(-10.0), 27.0}};
  for (const auto& [pose, distance] : distances)
    log.poses.push_back({pose, 40, gain * distance + offset});
  return log;
}

TEST(CarpetReadings, AreTheMeanOfAPoseFromHalfASecondOn) {
  std::vector<CarpetMoment> moments;
  hold(kBall, 40.0, 0.49, moments);  // the head is on its way
  hold(kBall, 25.0, 1.0, moments);
  const auto poses = carpetReadings(moments);
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_TRUE(poses[0].pose == kBall);
  EXPECT_NEAR(poses[0].mean, 25.0, 1e-9);
  EXPECT_NEAR(static_cast<double>(poses[0].count), 30.0, 2.0);
}

TEST(CarpetReadings, OfAPoseThatIsHeldTwiceAreOne) {
  std::vector<CarpetMoment> moments;
  for (const double reading : {24.0, 26.0}) {
    hold(kBall, reading, 2.0, moments);
    hold(looking(-10.0), 30.0, 2.0, moments);
  }
  const auto poses = carpetReadings(moments);
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_NEAR(poses[0].mean, 25.0, 0.05);
}

TEST(CarpetReadings, TooFewThoseOfAWalkAndThoseAtAnEndOfTheRangeAreNone) {
  std::vector<CarpetMoment> moments;
  hold(looking(-10.0), 30.0, 0.8, moments);
  hold(looking(-20.0), 50.0, 2.0, moments);
  hold(looking(-30.0), 5.0, 2.0, moments);
  const std::size_t walks = moments.size();
  hold(kBall, 25.0, 3.0, moments);
  for (std::size_t i = walks; i < moments.size(); ++i) moments[i].stands = false;
  EXPECT_TRUE(carpetReadings(moments).empty());
  EXPECT_TRUE(carpetReadings({}).empty());
}

TEST(CarpetMoment, IsOfARobotThatStandsAndHoldsItsHeadByJoints) {
  const auto input = std::make_unique<FrameInput>();
  input->motion.ready = true;
  input->lastCommand.head.neckTilt = Angle::deg(-52.0);
  input->lastCommand.head.headNod = Angle::deg(45.0);
  input->lastCommand.mouthOpen = true;
  input->sensors.headNearDistance = 23.5;
  const CarpetMoment moment = carpetMoment(*input);
  EXPECT_TRUE(moment.stands);
  EXPECT_TRUE(isBallStance(moment.pose));
  EXPECT_EQ(moment.reading, 23.5);
  input->lastCommand.walk.turn = 0.5;
  EXPECT_FALSE(carpetMoment(*input).stands);
  input->lastCommand.walk.turn = 0.0;
  input->lastCommand.head.aim = HeadAim::point;
  EXPECT_FALSE(carpetMoment(*input).stands);
  input->lastCommand.head.aim = HeadAim::joints;
  input->motion.feeling.lifted = true;
  EXPECT_FALSE(carpetMoment(*input).stands);
}

// Thesis 2006 section 6.4.4; the final's 20 cm is a carpet of 25 cm.
TEST(CarpetThreshold, IsFourFifthsOfWhatTheStanceWithABallReads) {
  CarpetLog log;
  log.poses = {{kBall, 30, 25.0}, {looking(-10.0), 30, 40.0}};
  const auto found = carpetThreshold(log);
  ASSERT_TRUE(found.ok());
  EXPECT_NEAR(found->carpet, 25.0, 1e-12);
  EXPECT_NEAR(found->threshold, 20.0, 1e-12);
  EXPECT_EQ(found->readings, 30U);
}

TEST(CarpetThreshold, IsOfTheBaseRobotsReadingWhateverRobotIsMeasured) {
  CarpetLog log;
  log.infrared = {1.25, -5.0, 20.0};
  log.poses = {{kBall, 30, 24.0}};
  EXPECT_NEAR(carpetThreshold(log)->threshold, 0.8 * 25.0, 1e-12);
}

TEST(CarpetThreshold, WithoutThatStanceIsAnErrorOfOneLine) {
  CarpetLog log;
  log.poses = {{looking(-52.0), 30, 25.0}};
  const auto found = carpetThreshold(log);
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().find("never stands as with a ball"), std::string::npos);
}

TEST(InfraredLine, MakesTwoRobotsThatDifferAgree) {
  const CarpetLog base = logOf(1.0, 0.0);
  const CarpetLog own = logOf(1.06, -0.8);
  const auto line = lineBetween(own, base);
  ASSERT_TRUE(line.ok()) << line.error();
  EXPECT_EQ(line->poses, 4U);
  for (std::size_t i = 0; i < own.poses.size(); ++i)
    EXPECT_NEAR(line->gain * own.poses[i].mean + line->offset, base.poses[i].mean, 1e-9);
  EXPECT_NEAR(line->rms, 0.0, 1e-9);
  EXPECT_NEAR(line->gain, 1.0 / 1.06, 1e-9);
}

TEST(InfraredLine, TellsWhatItLeaves) {
  const CarpetLog base = logOf(1.0, 0.0);
  CarpetLog own = base;
  own.poses[0].mean += 1.0;
  own.poses[3].mean -= 1.0;
  const auto line = lineBetween(own, base);
  ASSERT_TRUE(line.ok());
  EXPECT_GT(line->rms, 0.3);
  EXPECT_LT(line->rms, 1.0);
}

TEST(InfraredLine, NeedsTwoPosesInCommonAtDifferentDistances) {
  CarpetLog own = logOf(1.0, 0.0);
  own.poses.resize(1);
  EXPECT_EQ(lineBetween(own, logOf(1.0, 0.0)).error(),
            "holds its head in 1 of the base robot's poses, two are needed");
  CarpetLog level = logOf(1.0, 0.0);
  for (CarpetReadings& held : level.poses) held.mean = 25.0;
  const auto line = lineBetween(level, logOf(1.0, 0.0));
  ASSERT_FALSE(line.ok());
  EXPECT_NE(line.error().find("equally far"), std::string::npos);
}

}  // namespace
}  // namespace kelpie::calibrate

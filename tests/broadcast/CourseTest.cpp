// SPDX-License-Identifier: Apache-2.0
// Where everything is at any time, how the camera follows, and the words over it.
#include <gtest/gtest.h>

#include "tools/broadcast/Cameraman.h"
#include "tools/broadcast/Captions.h"
#include "tools/broadcast/Course.h"

namespace kelpie::broadcast {
namespace {

const Player kRed{TeamColour::red, 2};

sim::TruthFrame truth(double seconds, Point2<Field> robot, Point2<Field> ball) {
  sim::TruthFrame made;
  made.time = TimeUs{static_cast<std::int64_t>(1e6 * seconds)};
  sim::RobotTruth one;
  one.player = 2;
  one.pose = {robot, Angle::deg(90)};
  made.robots.push_back(one);
  made.ball = ball;
  return made;
}

sim::MatchEvent event(sim::EventKind kind, double seconds, Point2<Field> ball = {180, 545}) {
  sim::MatchEvent made;
  made.kind = kind;
  made.time = TimeUs{static_cast<std::int64_t>(1e6 * seconds)};
  made.ball = ball;
  return made;
}

TEST(Course, IsBetweenTwoTruths) {
  Course course;
  course.addTruth(truth(1.0, {100, 100}, {180, 200}));
  course.addTruth(truth(1.2, {104, 100}, {190, 200}));
  const Tableau tableau = course.at(1.1);
  ASSERT_EQ(tableau.actors.size(), 1U);
  EXPECT_NEAR(tableau.actors[0].pose.position.x, 102.0, 1e-6);
  EXPECT_NEAR(tableau.ball.x, 185.0, 1e-6);
}

TEST(Course, DoesNotSlideWhoIsCarried) {
  Course course;
  course.addTruth(truth(1.0, {100, 100}, {180, 200}));
  course.addTruth(truth(1.2, {300, 400}, {180, 200}));
  EXPECT_EQ(course.at(1.05).actors[0].pose.position.x, 100.0);
  EXPECT_EQ(course.at(1.15).actors[0].pose.position.x, 300.0);
}

TEST(Course, OfALogThatIsCutEndsWithIt) {
  Course course;
  course.addTruth(truth(1.0, {100, 100}, {180, 200}));
  EXPECT_EQ(course.at(1.5).actors.size(), 1U);
  EXPECT_TRUE(course.at(9.0).actors.empty());
  EXPECT_FALSE(course.at(9.0).ballThere);
}

TEST(Course, WithoutATruthIsWhereTheRobotBelievesToBe) {
  Course course;
  JointSample sample;
  sample.seconds = 1.0;
  sample.joints[Joint::headPan] = Angle::deg(30);
  course.addJoints(kRed, sample);
  course.addFrame(kRed, {1.0, {}, false});
  const auto world = std::make_unique<WorldModel>();
  world->pose = {{120, 130}, Angle::deg(45)};
  world->ball.present = true;
  world->ball.position = {150, 160};
  course.addBelief(kRed, 1.0, *world);
  const Tableau tableau = course.at(1.0);
  ASSERT_EQ(tableau.actors.size(), 1U);
  EXPECT_EQ(tableau.actors[0].pose.position.y, 130.0);
  EXPECT_NEAR(tableau.actors[0].joints[Joint::headPan].deg(), 30.0, 1e-9);
  EXPECT_TRUE(tableau.ballThere);
}

TEST(Course, SaysWhoHasTheBallBeforeItsChest) {
  Course course;
  course.addTruth(truth(1.0, {100, 100}, {101, 110}));
  const Tableau near = course.at(1.0);
  const Actor* holder = course.holderOf(near, 1.0);
  ASSERT_NE(holder, nullptr);
  EXPECT_EQ(ballWords(holder, true), "Red 2 has the ball");
  Course apart;
  apart.addTruth(truth(1.0, {100, 100}, {101, 190}));
  const Tableau far = apart.at(1.0);
  EXPECT_EQ(apart.holderOf(far, 1.0), nullptr);
  EXPECT_EQ(ballWords(nullptr, true), "Nobody has the ball");
}

TEST(Course, MakesUpStepsBetweenJointsThatAreFarApart) {
  Course course;
  for (int i = 0; i <= 60; ++i) course.addTruth(truth(i / 30.0, {100, 100 + i * 0.5}, {180, 200}));
  for (const double seconds : {0.5, 1.0, 1.5}) course.addJoints(kRed, {seconds, {}});
  const JointAngles at = course.at(1.25).actors[0].joints;
  EXPECT_GT(std::fabs(at[Joint::leftFrontRotator].deg()), 1.0);
  EXPECT_EQ(at[Joint::neckTilt].deg(), 0.0);
}

TEST(Course, TakesJointsThatAreCloseAsTheyAre) {
  Course course;
  for (int i = 0; i <= 60; ++i) {
    course.addTruth(truth(i / 30.0, {100, 100 + i * 0.5}, {180, 200}));
    course.addJoints(kRed, {i / 30.0, {}});
  }
  EXPECT_EQ(course.at(1.25).actors[0].joints[Joint::leftFrontRotator].deg(), 0.0);
}

// A ball that leaps from one end of the field to the other.
Course leapingBall() {
  Course course;
  for (int i = 0; i <= 600; ++i) {
    const double y = (i / 60) % 2 == 0 ? 60.0 : 480.0;
    course.addTruth(truth(i / 30.0, {180, 270}, {180, y}));
  }
  return course;
}

std::vector<double> timesUntil(double end) {
  std::vector<double> times;
  for (int i = 0; i / 15.0 < end; ++i) times.push_back(i / 15.0);
  return times;
}

TEST(Cameraman, NeverJerks) {
  const auto field = *body::fieldDescription("2006");
  const auto views = followPlay(leapingBall(), field, timesUntil(20.0), 16.0 / 9.0);
  for (std::size_t i = 1; i < views.size(); ++i) {
    EXPECT_LT(cv::norm(views[i].target - views[i - 1].target), 0.25) << i;
    EXPECT_LT(cv::norm(views[i].eye - views[i - 1].eye), 0.25) << i;
  }
}

TEST(Cameraman, KeepsABallThatRollsInThePicture) {
  const auto field = *body::fieldDescription("2006");
  Course course;
  for (int i = 0; i <= 300; ++i)
    course.addTruth(truth(i / 30.0, {100, 100}, {180, 40.0 + 1.5 * i}));
  const std::vector<double> times = timesUntil(10.0);
  const auto views = followPlay(course, field, times, 16.0 / 9.0);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Tableau tableau = course.at(times[i]);
    const auto seen =
        project(views[i], {0.01 * tableau.ball.x, 0.01 * tableau.ball.y, 0.04}, {1600, 900});
    ASSERT_TRUE(seen);
    EXPECT_TRUE(cv::Rect(0, 0, 1600, 900).contains(cv::Point(*seen))) << times[i];
  }
}

TEST(Cameraman, CutsToTheGoalWhenOneFalls) {
  const auto field = *body::fieldDescription("2006");
  Course course = leapingBall();
  course.addEvent(event(sim::EventKind::goal, 10.0));
  const std::vector<double> times = timesUntil(20.0);
  const auto views = followPlay(course, field, times, 16.0 / 9.0);
  const auto at = [&](double seconds) { return views[static_cast<std::size_t>(15 * seconds)]; };
  EXPECT_GT(at(10.0).eye[1], 4.0);
  EXPECT_LT(at(10.0).eye[2], 1.0);
  EXPECT_GT(cv::norm(at(10.0).eye - at(10.0 - kBeforeGoal - 0.2).eye), 0.5);
}

TEST(View, ProjectsWhatItLooksAtIntoTheMiddle) {
  const View view{{5.0, 1.0, 2.0}, {1.0, 2.0, 0.0}};
  const auto middle = project(view, view.target, {640, 480});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->x, 320.0, 1e-6);
  EXPECT_NEAR(middle->y, 240.0, 1e-6);
  EXPECT_FALSE(project(view, {9.0, 0.0, 4.0}, {640, 480}));
}

TEST(Captions, AGoalStaysOverWhatIsCalledAfterIt) {
  const std::vector<sim::MatchEvent> events = {event(sim::EventKind::goal, 10.0),
                                               event(sim::EventKind::ready, 10.1)};
  EXPECT_EQ(bannerAt(events, 9.9), "");
  EXPECT_EQ(bannerAt(events, 11.0), "Goal of red.");
  EXPECT_EQ(bannerAt(events, 20.0), "");
}

TEST(Captions, TheNewestCallStandsFirst) {
  const std::vector<sim::MatchEvent> events = {event(sim::EventKind::start, 0.0),
                                               event(sim::EventKind::out, 5.0),
                                               event(sim::EventKind::out, 9.0)};
  const auto calls = callsUntil(events, 6.0, 5);
  ASSERT_EQ(calls.size(), 2U);
  EXPECT_EQ(calls[0].words, "The ball is out.");
  EXPECT_EQ(callsUntil(events, 60.0, 1).size(), 1U);
}

}  // namespace
}  // namespace kelpie::broadcast

// SPDX-License-Identifier: Apache-2.0
// What is seen of the stage: things have their colours and stand where they are.
#include <gtest/gtest.h>

#include <cmath>

#include "robot/body/Legs.h"
#include "tools/broadcast/Gait.h"
#include "tools/broadcast/Stage.h"

namespace kelpie::broadcast {
namespace {

constexpr int kWide = 448;
constexpr int kHigh = 252;

bool isOrange(const cv::Vec3b& p) { return p[2] > 150 && p[1] > 40 && p[1] < 150 && p[0] < 70; }
bool isGreen(const cv::Vec3b& p) { return p[1] > 60 && p[1] > 2 * p[0] && p[1] > 2 * p[2]; }
bool isWhite(const cv::Vec3b& p) { return p[0] > 190 && p[1] > 190 && p[2] > 190; }
bool isBlue(const cv::Vec3b& p) { return p[0] > 90 && p[0] > p[1] + 50 && p[0] > 2 * p[2]; }
bool isYellow(const cv::Vec3b& p) { return p[2] > 120 && p[1] > 100 && p[0] < 70; }
bool isRed(const cv::Vec3b& p) { return p[2] > 90 && p[2] > 3 * p[1] && p[2] > 3 * p[0]; }

template <class Is>
int count(const cv::Mat& picture, Is is) {
  int found = 0;
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) found += is(picture.at<cv::Vec3b>(y, x)) ? 1 : 0;
  return found;
}

Actor actor(TeamColour team, int player, Pose2 pose) {
  Actor made{team, player, pose, {}, {}};
  made.joints = walkingJoints(made.stance, 0.0, 0.0);
  return made;
}

View wholeField() { return {{6.5, 2.7, 3.2}, {1.9, 2.7, 0.0}}; }

class StageTest : public testing::Test {
 protected:
  void SetUp() override {
    auto built =
        Stage::build(field_, {{TeamColour::red, 1}, {TeamColour::blue, 2}}, {kWide, kHigh});
    ASSERT_TRUE(built) << built.error();
    stage_ = std::make_unique<Stage>(std::move(*built));
  }
  cv::Mat shot(const Tableau& tableau, const View& view) {
    stage_->put(tableau);
    const auto picture = stage_->shoot(view);
    EXPECT_TRUE(picture) << picture.error();
    return picture ? *picture : cv::Mat();
  }
  static Tableau tableau() {
    Tableau made;
    made.actors = {actor(TeamColour::red, 1, {{120, 250}, Angle::deg(90)}),
                   actor(TeamColour::blue, 2, {{220, 330}, Angle::deg(-90)})};
    made.ball = {180, 200};
    made.ballThere = true;
    return made;
  }

  body::FieldDescription field_ = *body::fieldDescription("2006");
  std::unique_ptr<Stage> stage_;
};

TEST_F(StageTest, CarpetLinesGoalsUniformsAndBallHaveTheirColours) {
  const cv::Mat picture = shot(tableau(), wholeField());
  ASSERT_EQ(picture.size(), cv::Size(kWide, kHigh));
  EXPECT_GT(count(picture, isGreen), kWide * kHigh / 3);
  EXPECT_GT(count(picture, isWhite), 300);
  EXPECT_GT(count(picture, isBlue), 200);
  EXPECT_GT(count(picture, isYellow), 100);
  EXPECT_GT(count(picture, isRed), 20);
  EXPECT_GT(count(picture, isOrange), 8);
}

TEST_F(StageTest, TheBallIsSeenWhereItsPlaceIsProjected) {
  const View view{{3.4, 2.2, 1.0}, {1.8, 2.1, 0.0}};
  const cv::Mat picture = shot(tableau(), view);
  const auto where = project(view, {1.80, 2.00, 0.042}, picture.size());
  ASSERT_TRUE(where);
  const cv::Rect near(static_cast<int>(where->x) - 2, static_cast<int>(where->y) - 2, 5, 5);
  EXPECT_GE(count(picture(near), isOrange), 20);
}

TEST_F(StageTest, ARobotStandsWhereItsPoseIs) {
  Tableau one = tableau();
  one.actors.resize(1);
  const View view{{3.2, 2.4, 1.2}, {1.2, 2.4, 0.0}};
  const cv::Mat with = shot(one, view);
  const Point2<Field> back = fieldFromRobot(one.actors[0].pose, Point2<Robot>{0.0, -6.0});
  const auto where = project(view, {0.01 * back.x, 0.01 * back.y, 0.14}, with.size());
  ASSERT_TRUE(where);
  const cv::Rect near(static_cast<int>(where->x) - 12, static_cast<int>(where->y) - 12, 25, 25);
  EXPECT_GT(count(with(near), isRed), 40);
}

TEST_F(StageTest, WhoeverIsNotPutThereIsNotSeen) {
  Tableau nobody = tableau();
  nobody.actors.clear();
  nobody.ballThere = false;
  const cv::Mat picture = shot(nobody, {{3.4, 2.6, 1.0}, {1.6, 2.6, 0.0}});
  EXPECT_EQ(count(picture, isRed), 0);
  EXPECT_EQ(count(picture, isOrange), 0);
}

TEST_F(StageTest, TheSameTableauGivesTheSamePicture) {
  const cv::Mat once = shot(tableau(), wholeField());
  EXPECT_EQ(cv::norm(once, shot(tableau(), wholeField()), cv::NORM_INF), 0.0);
}

TEST(Gait, StandsOnStraightLegsBelowTheShoulders) {
  const Stance stance;
  const JointAngles joints = walkingJoints(stance, 3.0, 0.0);
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const auto foot =
        body::robotFromTorso(stance, body::footPosition(leg, body::legAngles(joints, leg)));
    EXPECT_NEAR(foot.z, 0.0, 0.5);
  }
}

TEST(Gait, LiftsTwoDiagonalFeetAtATime) {
  const Stance stance;
  const JointAngles joints = walkingJoints(stance, 9.0 / 4.0, 20.0);
  std::array<bool, kLegCount> up{};
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    up[i] =
        body::robotFromTorso(stance, body::footPosition(leg, body::legAngles(joints, leg))).z > 1.0;
  }
  EXPECT_EQ(up[index(LegId::leftFront)], up[index(LegId::rightHind)]);
  EXPECT_NE(up[index(LegId::leftFront)], up[index(LegId::rightFront)]);
}

}  // namespace
}  // namespace kelpie::broadcast

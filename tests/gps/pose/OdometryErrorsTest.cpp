// SPDX-License-Identifier: Apache-2.0
// Odometry that tells steps of another length, or a turn: found from the poses that sightings give.
#include <gtest/gtest.h>

#include <cmath>

#include "gps/Gaussian.h"
#include "gps/pose/OdometryErrors.h"
#include "gps/pose/PoseUpdate.h"
#include "robot/core/Random.h"

namespace kelpie::gps {
namespace {

// One mode of a robot that walks and is told its pose to 5 cm and 2 deg in every frame.
struct Walker {
  OdometryErrorsParams params;
  PoseState state;
  Pose2 truth{{100.0, 100.0}, Angle::deg(30.0)};
  Random random{3};

  Walker() {
    PoseMode mode;
    mode.weight = 1.0;
    mode.pose = truth;
    mode.covariance = {25, 0, 0, 0, 25, 0, 0, 0, 0.01};
    state.modes.push_back(mode);
    state.lost = false;
    state.odometry = startingErrors(params);
  }
  void frame(const Odometry& walked, const Odometry& told) {
    truth = moved(truth, walked);
    const Odometry believed = corrected(told, kFrameSeconds, state.odometry);
    predictAll(told, {believed, {0.05, 0.05, 1e-5}}, kFrameSeconds, params, state);
  }
  void see() {
    const Pose2 seen{
        truth.position + Point2<Field>{random.gaussian(0.0, 5.0), random.gaussian(0.0, 5.0)},
        truth.heading + Angle::deg(random.gaussian(0.0, 2.0))};
    const Vector3 information(1.0 / 25.0, 1.0 / 25.0, 800.0);
    state.modes[0] =
        gps::corrected(state.modes[0], PoseObservation{seen, information.asDiagonal()});
    learnErrors(params, state);
  }
  void walk(int frames, const Odometry& walked, const Odometry& told) {
    for (int i = 0; i < frames; ++i) {
      frame(walked, told);
      see();
    }
  }
  double sd(std::size_t k) const { return std::sqrt(state.odometry.covariance[4 * k]); }
};

TEST(OdometryErrors, AWayThatIsShorterThanToldIsFoundWithinItsBelievedDoubt) {
  Walker robot;
  robot.walk(200, {0.7, 0.0, {}, {}}, {0.9, 0.0, {}, {}});
  EXPECT_NEAR(robot.state.odometry.mean[0], 0.7 / 0.9 - 1.0, 2.5 * robot.sd(0));
  EXPECT_LT(robot.sd(0), 0.07);
}

TEST(OdometryErrors, ATurnThatIsNotToldIsFoundWithinFourSeconds) {
  Walker robot;
  const Angle turn = Angle::deg(-0.4);
  robot.walk(120, {0.7, 0.0, turn, {}}, {0.7, 0.0, {}, {}});
  EXPECT_NEAR(robot.state.odometry.mean[2], turn.rad() / kFrameSeconds, 0.04);
}

TEST(OdometryErrors, OfStepsAsideSayNothingOfThoseAhead) {
  Walker robot;
  robot.walk(200, {0.0, 0.6, {}, {}}, {0.0, 0.8, {}, {}});
  EXPECT_LT(robot.state.odometry.mean[1], -0.1);
  EXPECT_NEAR(robot.sd(0), robot.params.scaleSd, 1e-3);
}

TEST(OdometryErrors, ThatAreUnknownWidenTheModeAsItsWayGrows) {
  Walker robot;
  const double before = covarianceOf(robot.state.modes[0]).trace();
  for (int i = 0; i < 100; ++i) robot.frame({1.0, 0.0, {}, {}}, {1.0, 0.0, {}, {}});
  const double grown = covarianceOf(robot.state.modes[0]).trace() - before;
  EXPECT_GT(grown, maths::square(100.0 * robot.params.scaleSd));
}

TEST(OdometryErrors, AStandingRobotHasNone) {
  Walker robot;
  robot.state.odometry.mean = {0.2, 0.2, 0.2};
  const Odometry still = corrected({}, kFrameSeconds, robot.state.odometry);
  EXPECT_EQ(still.turn.rad(), 0.0);
  EXPECT_EQ(still.forward, 0.0);
}

TEST(OdometryErrors, APoseElsewhereTeachesNothing) {
  Walker robot;
  robot.walk(50, {0.7, 0.0, {}, {}}, {0.7, 0.0, {}, {}});
  const auto before = robot.state.odometry.mean;
  robot.frame({0.7, 0.0, {}, {}}, {0.7, 0.0, {}, {}});
  robot.state.modes[0].pose.position = {20.0, 300.0};
  robot.state.modes[0].covariance[0] *= 2.0;
  learnErrors(robot.params, robot.state);
  EXPECT_EQ(robot.state.odometry.mean, before);
}

TEST(OdometryErrors, FramesWithoutALandmarkTeachNothing) {
  Walker robot;
  robot.state.secondsSinceLandmark = 1.0;
  robot.walk(100, {0.7, 0.0, {}, {}}, {0.9, 0.0, {}, {}});
  EXPECT_EQ(robot.state.odometry.mean[0], 0.0);
  EXPECT_GE(robot.sd(0), robot.params.scaleSd);
}

TEST(OdometryErrors, NotUsedTheyLeaveTheOdometryAsItIs) {
  Walker robot;
  robot.params.use = false;
  robot.state.odometry = startingErrors(robot.params);
  robot.walk(100, {0.7, 0.0, {}, {}}, {0.9, 0.0, {}, {}});
  EXPECT_EQ(robot.state.odometry.mean[0], 0.0);
}

}  // namespace
}  // namespace kelpie::gps

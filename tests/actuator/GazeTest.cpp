// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "actuator/motion/Gaze.h"
#include "robot/body/Camera.h"
#include "robot/core/Random.h"

namespace kelpie::actuator {
namespace {

const Stance kStance{9.5, Angle::deg(12.0), {}};

JointAngles jointsOf(const HeadRequest& request) {
  JointAngles joints;
  joints[Joint::neckTilt] = request.neckTilt;
  joints[Joint::headPan] = request.headPan;
  joints[Joint::headNod] = request.headNod;
  return joints;
}

TEST(Gaze, APointThatIsLookedAtIsInTheMiddleOfTheImage) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    HeadRequest request;
    request.aim = HeadAim::point;
    request.target = {random.uniform(-100, 100), random.uniform(25, 300), random.uniform(0, 60)};
    const JointAngles joints = jointsOf(asJoints(request, kStance));
    const auto pixel = body::project(body::cameraPose(joints, kStance), request.target);
    ASSERT_TRUE(pixel.has_value());
    EXPECT_NEAR(pixel->x, body::kNominalLens.principalX, 0.7);
    EXPECT_NEAR(pixel->y, body::kNominalLens.principalY, 0.7);
  }
}

TEST(Gaze, ADirectionIsWhereTheCamerasAxisPoints) {
  for (const double direction : {-60.0, 0.0, 35.0})
    for (const double elevation : {-40.0, -10.0, 0.0, 20.0}) {
      HeadRequest request;
      request.aim = HeadAim::direction;
      request.direction = Angle::deg(direction);
      request.elevation = Angle::deg(elevation);
      const auto camera = body::cameraPose(jointsOf(asJoints(request, kStance)), kStance);
      EXPECT_NEAR(Angle::rad(maths::asin(camera.axes[8])).deg(), elevation, 1e-6);
      EXPECT_NEAR(Angle::rad(maths::atan2(-camera.axes[2], camera.axes[5])).deg(), direction, 1e-6);
    }
}

TEST(Gaze, JointsThatAreAskedForStayAsTheyAre) {
  HeadRequest request;
  request.neckTilt = Angle::deg(-70);
  request.headPan = Angle::deg(12);
  request.headNod = Angle::deg(33);
  const HeadRequest same = asJoints(request, kStance);
  EXPECT_EQ(same.neckTilt.rad(), request.neckTilt.rad());
  EXPECT_EQ(same.headPan.rad(), request.headPan.rad());
  EXPECT_EQ(same.headNod.rad(), request.headNod.rad());
}

TEST(Gaze, TheNeckStaysAboveABallAtTheFeet) {
  HeadRequest request;
  request.aim = HeadAim::point;
  request.target = {0.0, 12.0, 4.2};
  EXPECT_GE(asJoints(request, kStance).neckTilt.deg(), -32.0 - 1e-9);
}

}  // namespace
}  // namespace kelpie::actuator

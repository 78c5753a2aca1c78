// SPDX-License-Identifier: Apache-2.0
// The physical ERS-7: its lengths, how it stands, walks and falls, the ball, and that nothing goes
// wrong silently.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include "robot/body/Camera.h"
#include "robot/core/Random.h"
#include "tools/sim/bodies/WalkingBody.h"
#include "tools/sim/physics/PhysicalBodies.h"
#include "tools/sim/physics/Variation.h"

namespace kelpie::sim {
namespace {

const body::FieldDescription& field2006() {
  static const body::FieldDescription field = *body::fieldDescription("2006");
  return field;
}

// One robot in the middle of its half, the ball far away.
Physics oneRobot() {
  auto built = Physics::build(field2006(), {PhysicsParams{}}, {});
  Physics physics = std::move(*built);
  physics.putBall({{20.0, 20.0}, {}});
  physics.putRobot(0, {{180.0, 200.0}, Angle::deg(90.0)}, startingPose());
  return physics;
}

JointAngles anyPose(Random& random) {
  JointAngles joints;
  for (std::size_t j = 0; j < kServoCount; ++j) {
    const body::JointRange range = body::kJointRanges[j];
    joints.angle[j] = Angle::deg(random.uniform(range.min, range.max));
  }
  return body::withinLimits(joints);
}

// How far along x a ball comes that is rolled at what stands there.
double furthestOf(Physics& physics, const Ball& ball) {
  physics.putBall(ball);
  double furthest = ball.position.x;
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(physics.tick());
    furthest = std::fmax(furthest, physics.ball().position.x);
  }
  return furthest;
}

TEST(PhysicalWorld, ABallStopsAtWhatStandsOnTheFieldNow) {
  Physics physics = oneRobot();
  const Ball ball{{50.0, 400.0}, {120.0, 0.0}};
  const double free = furthestOf(physics, ball);
  const Obstacle wall{{90.0, 350.0}, {90.0, 450.0}, 1.0};
  const Obstacle post{{80.0, 400.0}, {80.0, 400.0}, 2.0};
  ASSERT_TRUE(physics.setObstacles({wall}));
  EXPECT_NEAR(furthestOf(physics, ball), 90.0 - 1.0 - body::kBallRadius, 0.7);
  ASSERT_TRUE(physics.setObstacles({wall, post}));
  EXPECT_NEAR(furthestOf(physics, ball), 80.0 - 2.0 - body::kBallRadius, 0.7);
  ASSERT_TRUE(physics.setObstacles({}));
  EXPECT_NEAR(furthestOf(physics, ball), free, 0.1);
  EXPECT_GT(free, 120.0);
}

TEST(PhysicalBody, EveryPawIsWhereTheKinematicsHaveIt) {
  Physics physics = oneRobot();
  Random random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const JointAngles joints = anyPose(random);
    physics.putRobot(0, {{180.0, 200.0}, Angle::deg(90.0)}, joints);
    ASSERT_TRUE(physics.engine().settle());
    const mjData& data = physics.engine().data();
    const int trunk = physics.robot(0).trunk();
    for (std::size_t i = 0; i < kLegCount; ++i) {
      const auto leg = static_cast<LegId>(i);
      const Point3<Torso> foot = body::footPosition(leg, body::legAngles(joints, leg));
      const int lower = physics.engine().body("r0_lower" + std::to_string(i));
      const double length = body::isFront(leg) ? body::kLowerLegFront : body::kLowerLegHind;
      std::array<double, 3> tip{};
      for (std::size_t k = 0; k < 3; ++k)
        tip[k] = data.xpos[3 * static_cast<std::size_t>(lower) + k] -
                 0.01 * length * data.xmat[9 * static_cast<std::size_t>(lower) + 3 * k + 2] -
                 data.xpos[3 * static_cast<std::size_t>(trunk) + k];
      const mjtNum* r = data.xmat + 9 * trunk;
      EXPECT_NEAR(100.0 * (r[0] * tip[0] + r[3] * tip[1] + r[6] * tip[2]), foot.x, 1e-6);
      EXPECT_NEAR(100.0 * (r[1] * tip[0] + r[4] * tip[1] + r[7] * tip[2]), foot.y, 1e-6);
      EXPECT_NEAR(100.0 * (r[2] * tip[0] + r[5] * tip[1] + r[8] * tip[2]), foot.z, 1e-6);
    }
  }
}

TEST(PhysicalBody, TheHeadsAxisIsWhereTheCamerasChainHasIt) {
  Physics physics = oneRobot();
  Random random(6);
  const Pose2 pose{{180.0, 200.0}, Angle::deg(30.0)};
  for (int trial = 0; trial < 20; ++trial) {
    physics.putRobot(0, pose, anyPose(random));
    ASSERT_TRUE(physics.engine().settle());
    const BodyPlace place = physics.robot(0).bodyPlace(physics.engine());
    EXPECT_NEAR(distance(place.pose.position, pose.position), 0.0, 1e-6);
    EXPECT_NEAR((place.pose.heading - pose.heading).deg(), 0.0, 1e-9);
    const CameraPose camera = trueCamera(place);
    const auto& a = camera.axes;  // the camera looks along its z and is below and ahead of the axis
    const Point3<Robot> axis{
        camera.position.x - body::kFaceLength * a[2] - body::kCameraDrop * a[1],
        camera.position.y - body::kFaceLength * a[5] - body::kCameraDrop * a[4],
        camera.position.z - body::kFaceLength * a[8] - body::kCameraDrop * a[7]};
    const Point2<Field> over = fieldFromRobot(place.pose, {axis.x, axis.y});
    const mjtNum* head = physics.engine().data().xpos + 3 * physics.engine().body("r0_head");
    EXPECT_NEAR(100.0 * head[0], over.x, 1e-6);
    EXPECT_NEAR(100.0 * head[1], over.y, 1e-6);
    EXPECT_NEAR(100.0 * head[2], axis.z, 1e-6);
  }
}

TEST(PhysicalBody, StandsOnFourPawsAndFeelsGravity) {
  WalkingBody body(1, {}, BodyKind::physical);
  const Pose2 before = body.pose();
  for (int i = 0; i < 90; ++i) body.step({});
  EXPECT_LT(distance(body.pose().position, before.position), 0.3);
  const SensorFrame& felt = body.world().sensors(0).back();
  EXPECT_TRUE(felt.paw[1] && felt.paw[3]);  // in front it may stand on its cowls
  EXPECT_NEAR(std::hypot(felt.acceleration[0], felt.acceleration[2]), 981.0, 60.0);
  EXPECT_LT(felt.acceleration[0], -100.0);  // the nose is down by 10 deg
}

TEST(PhysicalBody, WalksAheadFasterThanTwentyCentimetresASecond) {
  WalkingBody body(1, {}, BodyKind::physical);
  Command command;
  command.walk.forward = 33.0;
  for (int i = 0; i < 60; ++i) body.step(command);
  const Pose2 before = body.pose();
  for (int i = 0; i < 94; ++i) body.step(command);
  EXPECT_GT(robotFromField(before, body.pose().position).y, 20.0 * 94 * 0.032);
}

TEST(PhysicalBody, TheSameCommandsGiveTheSameBits) {
  const auto walked = [] {
    WalkingBody body(7, {}, BodyKind::physical);
    Command command;
    command.walk = {25.0, 5.0, 0.5};
    for (int i = 0; i < 60; ++i) body.step(command);
    return body.pose();
  };
  const Pose2 one = walked();
  const Pose2 other = walked();
  EXPECT_EQ(one.position.x, other.position.x);
  EXPECT_EQ(one.position.y, other.position.y);
  EXPECT_EQ(one.heading.rad(), other.heading.rad());
}

TEST(PhysicalBody, PushedOverItLiesOnItsSideAndGravitySaysSo) {
  Physics physics = oneRobot();
  const int trunk = physics.robot(0).trunk();
  for (int tick = 0; tick < 250; ++tick) {
    physics.engine().data().xfrc_applied[6 * trunk] = tick < 40 ? 40.0 : 0.0;
    ASSERT_TRUE(physics.tick());
  }
  const BodyPlace place = physics.robot(0).bodyPlace(physics.engine());
  EXPECT_GT(std::fabs(place.lean.roll.deg()), 45.0);
  const auto a = physics.robot(0).feeling({}, physics.engine()).acceleration;
  EXPECT_GT(std::fabs(a[1]), 700.0);
}

// Against its turning, whichever way up it is; once a hand made it spin until the physics failed.
TEST(PhysicalBody, AHandHoldsStillWhatLiesOnItsBack) {
  PhysicalStart start;
  start.pose = {{180.0, 200.0}, Angle::deg(90.0)};
  const auto built = PhysicalBodies::build(field2006(), {start}, {}, {});
  const std::unique_ptr<PhysicalBodies>& bodies = *built;
  bodies->putBall({{20.0, 20.0}, {}});
  bodies->hold(0, 1.0);
  Engine& engine = bodies->physics().engine();
  const int joint = engine.model().body_jntadr[bodies->physics().robot(0).trunk()];
  mjtNum* q = engine.data().qpos + engine.model().jnt_qposadr[joint];
  const std::array<mjtNum, 4> half{0.0, 0.0, 1.0, 0.0};  // of a roll, from a heading of 90 deg
  std::copy(half.begin(), half.end(), q + 3);
  mjtNum* v = engine.data().qvel + engine.model().jnt_dofadr[joint];
  v[5] = 3.0;
  for (int tick = 0; tick < 500; ++tick) ASSERT_TRUE(bodies->tick());
  EXPECT_LT(std::hypot(v[3], v[4], v[5]), 0.5);
}

TEST(PhysicalBody, VariedModelsDifferByTheirSeedOnly) {
  const PhysicsParams one = varied({}, 3);
  EXPECT_EQ(one.contact.carpet, varied({}, 3).contact.carpet);
  EXPECT_NE(one.contact.carpet, varied({}, 4).contact.carpet);
  EXPECT_NEAR(one.servo.leg.stall / one.servo.leg.kp, Servo{}.stall / Servo{}.kp, 1e-12);
}

TEST(PhysicalBall, RollsAsFarAsItsResistanceSays) {
  Physics physics = oneRobot();
  physics.putRobot(0, {{20.0, 500.0}, Angle::deg(90.0)}, startingPose());
  physics.putBall({{60.0, 100.0}, {100.0, 0.0}});
  for (int tick = 0; tick < 1000; ++tick) ASSERT_TRUE(physics.tick());
  // v' = -(k v + f): 1 m/s at k 0.76/s and f 0.06 m/s2 rolls 1.044 m.
  EXPECT_NEAR(physics.ball().position.x - 60.0, 104.4, 1.5);
  EXPECT_NEAR(physics.ball().position.y, 100.0, 0.1);
  EXPECT_LT(physics.ball().velocity.norm(), 0.3);
}

TEST(PhysicalBall, WhoPushesItIsReportedAndNobodyElse) {
  auto built = Physics::build(field2006(), {PhysicsParams{}, PhysicsParams{}}, {});
  Physics physics = std::move(*built);
  physics.putRobot(0, {{60.0, 200.0}, Angle::deg(90.0)}, startingPose());
  physics.putRobot(1, {{180.0, 200.0}, Angle::deg(90.0)}, startingPose());
  physics.putBall({{187.0, 240.0}, {0.0, -100.0}});  // at a paw
  ASSERT_TRUE(physics.tick());
  EXPECT_FALSE(physics.ballToucher());
  std::optional<std::size_t> toucher;
  for (int tick = 0; tick < 100 && !toucher; ++tick) {
    ASSERT_TRUE(physics.tick());
    toucher = physics.ballToucher();
  }
  EXPECT_EQ(toucher, std::optional<std::size_t>(1));
}

TEST(PhysicalBall, StaysInTheGoal) {
  Physics physics = oneRobot();
  physics.putBall({{180.0, 500.0}, {0.0, 120.0}});
  for (int tick = 0; tick < 500; ++tick) ASSERT_TRUE(physics.tick());
  EXPECT_GT(physics.ball().position.y, 540.0);
  EXPECT_LT(physics.ball().position.y, 570.0);
}

TEST(Engine, ANumberThatIsNotFiniteEndsTheMatchInOneLineThatNamesTheBody) {
  Physics physics = oneRobot();
  ASSERT_TRUE(physics.tick());
  physics.engine().data().qvel[8] = std::numeric_limits<double>::quiet_NaN();
  const Status ticked = physics.tick();
  ASSERT_FALSE(ticked);
  EXPECT_NE(ticked.error().find("r0_trunk"), std::string::npos) << ticked.error();
  EXPECT_EQ(ticked.error().find('\n'), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists("MUJOCO_LOG.TXT"));
}

TEST(Engine, AWrongDescriptionIsOneLine) {
  const auto engine = Engine::load("<mujoco><worldbody><body></worldbody></mujoco>");
  ASSERT_FALSE(engine);
  EXPECT_NE(engine.error().find("the physical world"), std::string::npos);
}

}  // namespace
}  // namespace kelpie::sim

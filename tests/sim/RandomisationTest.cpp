// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "robot/body/Camera.h"
#include "robot/core/fields/FieldCheck.h"
#include "tools/sim/bodies/KinematicBodies.h"
#include "tools/sim/bodies/Randomisation.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {
namespace {

RandomisedRobot drawnWith(const std::vector<std::string>& only, std::uint64_t match = 5) {
  return drawRandomisedRobot(randomisationParams(3, only), match, 0);
}

bool same(const RandomisedRobot& a, const RandomisedRobot& b) {
  return !firstDifference(a, b, nullptr);
}

TEST(Randomisation, TheNominalWorldHasNoDifference) {
  EXPECT_TRUE(same(drawRandomisedRobot({}, 5, 0), {}));
  EXPECT_TRUE(drawRandomisedRobot({}, 5, 0).body.lean.level());
}

TEST(Randomisation, EveryKindAloneIsAPartOfTheWhole) {
  for (const std::string& kind : randomisedKinds()) {
    bool differs = false;
    for (std::uint64_t match = 5; match < 13; ++match)
      differs = differs || firstDifference(drawRandomised(randomisationParams(3, {kind}), match, 1),
                                           drawRandomised({}, match, 1), nullptr);
    EXPECT_TRUE(differs) << kind;
  }
  RandomisedRobot lens;
  lens.lens = drawnWith({}).lens;
  EXPECT_TRUE(same(drawnWith({"lens"}), lens));
}

TEST(Randomisation, EveryMatchAndRobotIsDrawnAnewAndRepeats) {
  EXPECT_TRUE(same(drawnWith({}), drawnWith({})));
  EXPECT_FALSE(same(drawnWith({}), drawnWith({}, 6)));
  EXPECT_FALSE(same(drawnWith({}), drawRandomisedRobot(randomisationParams(3, {}), 5, 1)));
  EXPECT_FALSE(same(drawnWith({}), drawRandomisedRobot(randomisationParams(4, {}), 5, 0)));
}

TEST(Randomisation, LeansHaveTheirSpread) {
  double tilt2 = 0.0;
  double roll2 = 0.0;
  constexpr int kMatches = 2000;
  for (std::uint64_t match = 0; match < kMatches; ++match) {
    const Lean lean = drawnWith({"body"}, match).body.lean;
    tilt2 += maths::square(lean.tilt.deg()) / kMatches;
    roll2 += maths::square(lean.roll.deg()) / kMatches;
  }
  EXPECT_NEAR(std::sqrt(tilt2), 1.5, 0.1);
  EXPECT_NEAR(std::sqrt(roll2), 1.5, 0.1);
}

// Thesis 2006 section 6.4.4: NUbots' robots read 20 to 25 cm where the carpet is.
TEST(Randomisation, NosesReadTheSameCarpetAsTwentyToTwentyFiveCentimetres) {
  double low = 50.0;
  double high = 0.0;
  for (std::uint64_t match = 0; match < 1000; ++match) {
    const NoseSensor nose = drawnWith({"infrared"}, match).nose;
    const double carpet = nose.gain * 22.5 + nose.offset;
    low = std::fmin(low, carpet);
    high = std::fmax(high, carpet);
  }
  EXPECT_NEAR(low, 20.0, 0.5);
  EXPECT_NEAR(high, 25.0, 0.5);
}

BodyPlace looking() {
  BodyPlace place;
  place.stance = {10.0, Angle::deg(14.0), {}};
  place.joints[Joint::neckTilt] = Angle::deg(-10.0);
  place.joints[Joint::headPan] = Angle::deg(30.0);
  return place;
}

TEST(Lean, TiltTurnsTheCameraAsTheStanceWould) {
  BodyPlace place = looking();
  place.lean.tilt = Angle::deg(2.0);
  const CameraPose leaned = trueCamera(place);
  const CameraPose stance = body::cameraPose(place.joints, {10.0, Angle::deg(16.0), {}});
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(leaned.axes[i], stance.axes[i], 1e-9);
  EXPECT_NEAR(leaned.position.z, stance.position.z, 0.05);
}

TEST(Lean, RollLiftsTheLeftSide) {
  BodyPlace place = looking();
  place.lean.roll = Angle::deg(2.0);
  EXPECT_NEAR(leanedVector(place.lean, {-1.0, 0.0, 0.0}).z, std::sin(2.0 * maths::kPi / 180), 1e-9);
  // A camera that looks to the left looks up by it.
  place.joints = {};
  place.stance.bodyTilt = Angle();
  place.joints[Joint::headPan] = Angle::deg(90.0);
  EXPECT_NEAR(trueCamera(place).axes[8], std::sin(2.0 * maths::kPi / 180), 1e-9);
}

JointAngles tiltedBy(double deg) {
  JointAngles joints;
  joints[Joint::neckTilt] = joints[Joint::headPan] = Angle::deg(deg);
  return joints;
}

TEST(Backlash, TheHeadStaysBehindByHalfThePlay) {
  Backlash neck({Angle::deg(2.0), Angle::deg(3.0), Angle()});
  double angle = 0.0;
  for (int i = 0; i < 100; ++i) neck.step(tiltedBy(angle += 0.4));
  EXPECT_NEAR(neck.step(tiltedBy(angle))[Joint::headPan].deg(), angle - 1.5, 1e-9);
  for (int i = 0; i < 100; ++i) neck.step(tiltedBy(angle -= 0.4));
  const JointAngles after = neck.step(tiltedBy(angle -= 0.4));
  EXPECT_NEAR(after[Joint::headPan].deg(), angle + 1.5, 1e-9);
  EXPECT_NEAR(after[Joint::neckTilt].deg(), angle + 1.0, 1e-9);
}

TEST(Backlash, AHeadThatRestsHangsForwardAndItsPanStays) {
  Backlash neck({Angle::deg(2.0), Angle::deg(3.0), Angle::deg(1.0)});
  JointAngles head;
  for (int i = 0; i < 100; ++i) head = neck.step(tiltedBy(-20.0));
  EXPECT_NEAR(head[Joint::neckTilt].deg(), -21.0, 1e-9);
  EXPECT_NEAR(head[Joint::headPan].deg(), -20.0, 1e-9);
  EXPECT_NEAR(head[Joint::headNod].deg(), -0.5, 1e-9);
}

World worldWith(const RandomisationParams& randomised) {
  const body::FieldDescription field = *body::fieldDescription("2006");
  WorldParams params;
  params.randomised = randomised;
  World world(params, field, *scenario("empty-goal", field, {{TeamColour::red, 1}}, 3), 3);
  for (int i = 0; i < 40; ++i) {
    world.shove(0, {}, Angle::deg(0.5));
    world.tick();
  }
  return world;
}

// That kind alone, with the share of robots that have it, or the shortest of it, at its end.
RandomisationParams certain(const char* kind) {
  RandomisationParams params = randomisationParams(1, {kind});
  params.globalShutter = params.lagging = 1.0;
  return params;
}

TEST(Randomisation, ALateImageIsThatOfBefore) {
  const World like = worldWith({});
  const World late = worldWith(certain("lag"));
  const double lag = late.randomised().robots[0].lag;
  ASSERT_GT(lag, 0.1);
  const TimeUs end = like.time();
  const auto stale = late.cameras(0, end);
  const auto before = like.cameras(0, {end.us - std::lround(lag * kFrameSeconds * 1e6)});
  for (const std::size_t x : {0U, 100U, 207U}) {
    EXPECT_NEAR(stale[x].forward.x, before[x].forward.x, 1e-6);
    EXPECT_NEAR(stale[x].position.x, before[x].position.x, 1e-4);
  }
}

TEST(Randomisation, ImagesAndJointsAreUpToTwoFramesOldAndLightAndNoiseFarFromNominal) {
  double lag = 0.0, joints = 0.0, noise = 0.0, dark = 9.0, bright = 0.0, turn = 0.0, stride = 0.0;
  for (std::uint64_t match = 0; match < 1000; ++match) {
    const RandomisedRobot robot = drawnWith({}, match);
    const double light = drawRandomisedVenue(randomisationParams(3, {}), match).brightness;
    lag = std::fmax(lag, robot.lag);
    joints = std::fmax(joints, robot.jointsLag);
    noise = std::fmax(noise, robot.noise);
    dark = std::fmin(dark, light);
    bright = std::fmax(bright, light);
    turn = std::fmax(turn, std::fabs(robot.body.stride.turn.deg()));
    stride = std::fmax(stride, std::fabs(robot.body.stride.share - 1.0));
  }
  EXPECT_NEAR(lag, 2.0, 0.05);
  EXPECT_NEAR(joints, 2.0, 0.05);
  EXPECT_NEAR(noise, 10.0, 0.1);
  EXPECT_NEAR(dark, 0.5, 0.01);
  EXPECT_NEAR(bright, 1.5, 0.01);
  EXPECT_NEAR(turn, 0.3, 0.01);
  EXPECT_NEAR(stride, 0.25, 0.01);
}

JointAngles pannedBy(double rad) {
  JointAngles joints;
  joints[Joint::headPan] = Angle::rad(rad);
  return joints;
}

TEST(LateJoints, TellWhereTheyWereSoManyTicksAgo) {
  LateJoints late(2.0);  // 8.3 ticks
  LateJoints prompt(0.0);
  for (int tick = 0; tick < 40; ++tick) {
    EXPECT_EQ(prompt.tell(pannedBy(0.01 * tick))[Joint::headPan].rad(), 0.01 * tick);
    EXPECT_NEAR(late.tell(pannedBy(0.01 * tick))[Joint::headPan].rad(),
                0.01 * std::max(0, tick - 8), 1e-12);
  }
}

std::unique_ptr<Image> imageWith(const RobotCamera& robot) {
  CameraParams params = idealCamera();
  params.artefacts.noise = true;
  params.artefacts.noiseSdY = params.artefacts.noiseSdChroma = 0.0;
  Scene scene;
  scene.ceiling = scene.floor = {120, 150, 100};
  auto image = std::make_unique<Image>();
  Random random(1);
  Camera(params, robot).render(scene, {}, random, *image);
  return image;
}

TEST(Randomisation, LessLightIsLessOfEveryChannelAndLeavesGreyGrey) {
  RobotCamera dark;
  dark.light = 0.5;
  const auto image = imageWith(dark);
  EXPECT_EQ(image->y[0], 60);
  EXPECT_EQ(image->cr[0], 139);
  EXPECT_EQ(image->cb[0], 114);
}

TEST(Randomisation, ARobotsOwnNoiseIsInEveryChannel) {
  RobotCamera noisy;
  noisy.noise = 10.0;
  const auto image = imageWith(noisy);
  double square = 0.0;
  for (const std::uint8_t cr : image->cr) square += maths::square(cr - 150.0) / kImagePixels;
  EXPECT_NEAR(std::sqrt(square), 10.0, 0.5);
}

TEST(Randomisation, AColumnsCameraIsThatOfItsOwnTime) {
  constexpr double kHundredthOfAPixel = 0.01 / 192.0;
  const World world = worldWith({});
  const TimeUs end = world.time();
  const auto columns = world.cameras(0, end);
  for (std::size_t x = 0; x < kImageWidth; ++x) {
    const double us = static_cast<double>(end.us) - kExposureUs * (1.0 - exposedAt(x, 1.0));
    const BodyPlace place = world.past().place(0, us / kTickUs);
    const FieldPoint3 is = columns[x].forward;
    const FieldPoint3 off = fieldCamera(place.pose, trueCamera(place)).forward - is;
    EXPECT_LT(std::fabs(off.x) + std::fabs(off.y) + std::fabs(off.z), kHundredthOfAPixel) << x;
  }
}

TEST(Randomisation, AGlobalShutterExposesAllColumnsInTheMiddle) {
  const World like = worldWith({});
  const World global = worldWith(certain("shutter"));
  const auto columns = global.cameras(0, global.time());
  EXPECT_EQ(columns[0].forward.x, columns[207].forward.x);
  EXPECT_NE(like.cameras(0, like.time())[0].forward.x, like.cameras(0, like.time())[207].forward.x);
}

TEST(Randomisation, AWorldWithItsLensShowsPointsWhereTheLensHasThem) {
  const World world = worldWith(randomisationParams(1, {"lens"}));
  const FieldCamera camera = world.cameras(0, world.time())[104];
  ASSERT_NE(camera.lens.focal, Lens{}.focal);
  Scene scene;
  scene.ceiling = scene.floor = {0, 128, 128};
  const FieldPoint3 f = camera.forward;
  const FieldPoint3 r = camera.right;
  const FieldPoint3 ball{camera.position.x + 100 * f.x + 40 * r.x,
                         camera.position.y + 100 * f.y + 40 * r.y,
                         camera.position.z + 100 * f.z + 40 * r.z};
  scene.balls.push_back({ball, 0.8, {200, 128, 128}});
  ColumnCameras columns;
  columns.fill(camera);
  Random random(1);
  const auto image = std::make_unique<Image>();
  Camera(idealCamera(), {}).render(scene, columns, random, *image);
  const PixelPoint there = *pixelIn(camera, ball);
  EXPECT_NEAR(there.x, 104.0 + 0.4 * camera.lens.focal, 1e-6);
  EXPECT_GT(image->pixel(static_cast<int>(there.x), static_cast<int>(there.y)).y, 100);
}

// Of a physical robot that has begun to walk off its starting pose.
JointAngles legsAfter(const RandomisationParams& randomised) {
  const body::FieldDescription field = *body::fieldDescription("2006");
  WorldParams params;
  params.fast = false;
  params.randomised = randomised;
  World world(params, field, *scenario("empty-goal", field, {{TeamColour::red, 1}}, 3), 3);
  host::AgentReply reply;
  reply.motorPower = true;
  reply.gains = (1U << kJointCount) - 1;
  world.bodies().command(0, reply);
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(world.tick().ok());
  return world.bodies().place(0).joints;
}

TEST(Randomisation, PhysicalRobotsMoveAsTheirOwnServosMassAndFriction) {
  const JointAngles like = legsAfter({});
  const auto differ = [&like](const JointAngles& legs) {
    return legs[Joint::leftHindKnee] != like[Joint::leftHindKnee];
  };
  EXPECT_TRUE(differ(legsAfter(randomisationParams(1, {"physics"}))));
  EXPECT_FALSE(differ(legsAfter(randomisationParams(1, {"tape"}))));
}

TEST(Randomisation, TheAccelerometerFeelsTheLeanAndItsBias) {
  BodyFaults faults;
  faults.lean = {Angle::deg(1.0), Angle::deg(2.0)};
  faults.accelerationBias = {3.0, 4.0, 5.0};
  const auto felt = accelerationAtRest({10.0, Angle::deg(14.0), {}}, faults);
  EXPECT_NEAR(felt[0],
              -981.0 * std::sin(15 * maths::kPi / 180) * std::cos(2 * maths::kPi / 180) + 3, 1e-6);
  EXPECT_NEAR(felt[1], 981.0 * std::sin(2 * maths::kPi / 180) + 4, 1e-6);
}

}  // namespace
}  // namespace kelpie::sim

// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/body/Camera.h"
#include "robot/core/Random.h"
#include "tests/viewer/Turning.h"
#include "tools/viewer/CameraMessages.h"
#include "tools/viewer/Frames.h"

namespace kelpie::viewer {
namespace {

constexpr double kTiny = 1e-12;

void expectNear(const Vec& is, const Vec& should) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(is[i], should[i], kTiny) << "axis " << i;
}

Vec column(const std::array<double, 9>& axes, std::size_t n) {
  return {axes[n], axes[3 + n], axes[6 + n]};
}

TEST(Frames, ABodyThatHeads90DegLooksAlongTheFieldAndHasItsLeftAtMinusX) {
  const foxglove::Pose pose = poseOf({{120.0, 250.0}, Angle::deg(90.0)});
  EXPECT_EQ(pose.position().x(), 1.2);
  EXPECT_EQ(pose.position().y(), 2.5);
  expectNear(turnedBy(pose.orientation(), {1.0, 0.0, 0.0}), {0.0, 1.0, 0.0});
  expectNear(turnedBy(pose.orientation(), {0.0, 1.0, 0.0}), {-1.0, 0.0, 0.0});
  EXPECT_NEAR(pose.orientation().z(), 0.7071067811865476, kTiny);
}

TEST(Frames, APointAheadOfTheRobotLiesAheadOfItsBody) {
  const foxglove::Vector3 p = inBody(Point3<Robot>{-30.0, 100.0, 5.0});  // to the left, ahead
  EXPECT_DOUBLE_EQ(p.x(), 1.0);
  EXPECT_DOUBLE_EQ(p.y(), 0.3);
  EXPECT_DOUBLE_EQ(p.z(), 0.05);
}

TEST(Frames, TheRobotFrameAndTheBodyPutAPointInTheSamePlaceOfTheField) {
  const Pose2 pose{{100.0, 200.0}, Angle::deg(37.0)};
  const Point2<Robot> seen{-20.0, 80.0};
  const Point2<Field> place = fieldFromRobot(pose, seen);
  const auto transform = bodyTransform({}, "red1/true", pose);
  const foxglove::Vector3 p = inBody(seen);
  expectNear(inChild(transform, {0.01 * place.x, 0.01 * place.y, 0.0}), {p.x(), p.y(), p.z()});
}

// The columns of a random rotation, from three turns.
std::array<double, 9> randomAxes(Random& random) {
  const auto turn = [&] { return Angle::deg(random.uniform(-180.0, 180.0)).sinCos(); };
  const auto a = turn();
  const auto b = turn();
  const auto c = turn();
  return {a.cos * b.cos,
          a.cos * b.sin * c.sin - a.sin * c.cos,
          a.cos * b.sin * c.cos + a.sin * c.sin,
          a.sin * b.cos,
          a.sin * b.sin * c.sin + a.cos * c.cos,
          a.sin * b.sin * c.cos - a.cos * c.sin,
          -b.sin,
          b.cos * c.sin,
          b.cos * c.cos};
}

void expectTurns(const foxglove::Quaternion& q, const std::array<double, 9>& axes) {
  EXPECT_NEAR(normOf(q), 1.0, kTiny);
  expectNear(turnedBy(q, {1.0, 0.0, 0.0}), column(axes, 0));
  expectNear(turnedBy(q, {0.0, 1.0, 0.0}), column(axes, 1));
  expectNear(turnedBy(q, {0.0, 0.0, 1.0}), column(axes, 2));
}

TEST(Frames, AQuaternionTurnsEachAxisToItsColumnAndHasTheNormOne) {
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const auto axes = randomAxes(random);
    expectTurns(rotationOf(axes), axes);
  }
}

TEST(Frames, HalfATurnAboutAnyAxisIsATurn) {
  for (const auto& axes : {std::array<double, 9>{1, 0, 0, 0, -1, 0, 0, 0, -1},
                           std::array<double, 9>{-1, 0, 0, 0, 1, 0, 0, 0, -1},
                           std::array<double, 9>{-1, 0, 0, 0, -1, 0, 0, 0, 1}})
    expectTurns(rotationOf(axes), axes);
}

// The well-known rotation from a body to the optical frame of a camera that looks ahead.
TEST(Frames, ACameraThatLooksAheadHasTheRotationOfAnOpticalFrame) {
  CameraPose camera;
  camera.axes = {1, 0, 0, 0, 0, 1, 0, -1, 0};  // right, down, ahead
  const foxglove::Quaternion q = cameraTransform({}, "red1", camera).rotation();
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  EXPECT_NEAR(sign * q.x(), -0.5, kTiny);
  EXPECT_NEAR(sign * q.y(), 0.5, kTiny);
  EXPECT_NEAR(sign * q.z(), -0.5, kTiny);
  EXPECT_NEAR(sign * q.w(), 0.5, kTiny);
}

// A viewer's way to the pixel: transform, division, distortion, matrix.
PixelPoint pixelByViewer(const foxglove::FrameTransform& transform,
                         const foxglove::CameraCalibration& camera, const foxglove::Vector3& p) {
  const Vec ray = inChild(transform, {p.x(), p.y(), p.z()});
  const double x = ray[0] / ray[2];
  const double y = ray[1] / ray[2];
  const double r2 = x * x + y * y;
  const double stretch = 1.0 + r2 * (camera.d(0) + r2 * (camera.d(1) + r2 * camera.d(4)));
  return {camera.k(0) * stretch * x + camera.k(2), camera.k(4) * stretch * y + camera.k(5)};
}

TEST(Frames, AViewerSeesAPointWhereTheRobotsCameraDoes) {
  JointAngles joints;
  joints[Joint::neckTilt] = Angle::deg(-30.0);
  joints[Joint::headPan] = Angle::deg(25.0);
  joints[Joint::headNod] = Angle::deg(5.0);
  for (const double edge : {0.0, 0.05}) {
    CameraPose camera = body::cameraPose(joints, {10.0, Angle::deg(14.0), {}});
    camera.lens.edgeTerm = edge;
    for (const Point3<Robot>& p :
         {Point3<Robot>{-20.0, 60.0, 0.0}, Point3<Robot>{-60.0, 90.0, 10.0},
          Point3<Robot>{0.0, 50.0, 4.2}}) {
      const auto should = body::project(camera, p);
      ASSERT_TRUE(should);
      const PixelPoint is = pixelByViewer(cameraTransform({}, "red1", camera),
                                          calibrationOf({}, "red1", camera.lens), inBody(p));
      EXPECT_NEAR(is.x, should->x, 0.01);
      EXPECT_NEAR(is.y, should->y, 0.01);
    }
  }
}

TEST(Frames, TheBlueTeamsFieldIsTheMapTurnedByHalfATurn) {
  const MapFrame map(*body::fieldDescription("2006"), TeamColour::blue);
  const Pose2 pose = map.pose({{100.0, 200.0}, Angle::deg(90.0)});
  EXPECT_DOUBLE_EQ(pose.position.x, 260.0);
  EXPECT_DOUBLE_EQ(pose.position.y, 340.0);
  EXPECT_NEAR(pose.heading.deg(), -90.0, 1e-9);
  EXPECT_EQ(map.direction({3.0, -4.0}).y, 4.0);
}

TEST(Frames, AStampIsSecondsAndTheRestInNanoseconds) {
  const auto stamp = stampOf({1150279200017123});
  EXPECT_EQ(stamp.seconds(), 1150279200);
  EXPECT_EQ(stamp.nanos(), 17123000);
}

}  // namespace
}  // namespace kelpie::viewer

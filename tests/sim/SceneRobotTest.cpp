// SPDX-License-Identifier: Apache-2.0
// How other robots look: the gloss of red uniforms (checklist B-2.2.1.1).
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "robot/body/Camera.h"
#include "tools/sim/camera/Camera.h"
#include "vision/pixels/ClassPicture.h"

namespace kelpie::sim {
namespace {

using vision::ColourClass;

const Pose2 kSelf{{180.0, 200.0}, Angle::deg(90.0)};

// A robot 60 cm ahead that shows its side.
RobotLook beside(TeamColour team, std::uint64_t shine) {
  return {{{186.0, 265.0}, Angle::deg(0.0)}, 10.0, team, shine};
}

struct Counts {
  std::array<int, vision::kColourClassCount> pixels{};
  int operator[](ColourClass c) const { return pixels[vision::index(c)]; }
};

Counts seen(const RobotLook& robot, const ShineParams& shine) {
  Scene scene = fieldScene(*body::fieldDescription("2006"), 0);
  scene.beacons.clear();
  scene.fixtures.clear();
  setRobots(scene, {robot}, shine);
  ColumnCameras columns;
  JointAngles joints;
  joints[Joint::neckTilt] = Angle::deg(-5.0);
  columns.fill(fieldCamera(kSelf, body::cameraPose(joints, {10.0, Angle::deg(14.25), {}})));
  Random random(1);
  const auto image = std::make_unique<Image>();
  Camera(idealCamera(), {}).render(scene, columns, random, *image);
  auto calibration = std::make_unique<vision::VisionCalibration>(vision::nominalCalibration());
  calibration->ring = vision::buildRingTable({}, {});
  const auto plane = std::make_unique<vision::ClassPlane>();
  classifyWhole(*image, *calibration, *plane);
  Counts counts;
  for (const std::uint8_t c : *plane) ++counts.pixels[c];
  return counts;
}

ShineParams off() {
  ShineParams params;
  params.on = false;
  return params;
}

TEST(SceneRobot, ARedUniformIsTakenForYellowAndPinkAtItsEdges) {
  const Counts matt = seen(beside(TeamColour::red, 3), off());
  EXPECT_GT(matt[ColourClass::robotRed], 300);
  EXPECT_EQ(matt[ColourClass::yellow], 0);
  EXPECT_EQ(matt[ColourClass::pink], 0);
  for (std::uint64_t robot = 1; robot <= 10; ++robot) {
    const Counts glossy = seen(beside(TeamColour::red, robot), {});
    EXPECT_GT(glossy[ColourClass::yellow], 5);
    EXPECT_GT(glossy[ColourClass::pink], 5);
    EXPECT_GT(glossy[ColourClass::robotRed], matt[ColourClass::robotRed] / 2);
  }
}

TEST(SceneRobot, ABlueUniformIsNot) {
  const Counts blue = seen(beside(TeamColour::blue, 3), {});
  EXPECT_GT(blue[ColourClass::robotBlue], 300);
  EXPECT_EQ(blue[ColourClass::yellow] + blue[ColourClass::pink], 0);
}

TEST(SceneRobot, WiderGlossIsMoreOfItAndWithoutStrengthThereIsNone) {
  const auto glossy = [](double width, double strength) {
    ShineParams params;
    params.width = width;
    params.strength = strength;
    const Counts counts = seen(beside(TeamColour::red, 6), params);
    return counts[ColourClass::yellow] + counts[ColourClass::pink];
  };
  EXPECT_GT(glossy(1.0, 0.85), 1.4 * glossy(0.5, 0.85));
  EXPECT_EQ(glossy(1.0, 0.0), 0);
}

std::vector<Quad> uniformOf(std::uint64_t robot) {
  Scene scene;
  setRobots(scene, {beside(TeamColour::red, robot)}, {});
  std::vector<Quad> patches = scene.robots[0].quads;
  patches.erase(std::remove_if(patches.begin(), patches.end(),
                               [](const Quad& quad) { return quad.depthBias <= 0.0; }),
                patches.end());
  return patches;
}

TEST(SceneRobot, WhereAUniformShinesComesFromTheRobotsSeed) {
  const auto one = uniformOf(3);
  const auto same = uniformOf(3);
  const auto other = uniformOf(4);
  ASSERT_EQ(one.size(), same.size());
  ASSERT_GT(one.size(), 30U);
  const auto differs = [](const Quad& a, const Quad& b) {
    return a.corner[0].x != b.corner[0].x || a.colour.cb != b.colour.cb;
  };
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_FALSE(differs(one[i], same[i]));
  bool different = one.size() != other.size();
  for (std::size_t i = 0; !different && i < one.size(); ++i) different = differs(one[i], other[i]);
  EXPECT_TRUE(different);
}

}  // namespace
}  // namespace kelpie::sim

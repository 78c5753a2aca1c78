// SPDX-License-Identifier: Apache-2.0
// Where a robot's legs are, and when it sees them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "robot/body/Camera.h"
#include "robot/body/Ers7.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/sim/camera/Camera.h"

namespace kelpie::sim {
namespace {

constexpr Colour kPaint{128.0F, 20.0F, 220.0F};  // of no other thing

BodyPlace placed(double tilt, double pan, double nod) {
  BodyPlace place;
  place.pose = {{180.0, 270.0}, Angle::deg(35.0)};
  place.stance = {10.0, Angle::deg(14.25), {}};
  place.joints[Joint::neckTilt] = Angle::deg(tilt);
  place.joints[Joint::headPan] = Angle::deg(pan);
  place.joints[Joint::headNod] = Angle::deg(nod);
  setFrontFeet(place.joints, place.stance, {Point2<Robot>{-9.5, 4.0}, {9.5, 0.0}});
  return place;
}

std::unique_ptr<Image> rendered(const BodyPlace& place, const std::vector<Limb>& own) {
  Scene scene = fieldScene(*body::fieldDescription("2006"), 0);
  scene.own = own;
  ColumnCameras columns;
  columns.fill(fieldCamera(place.pose, body::cameraPose(place.joints, place.stance)));
  Random random(1);
  auto image = std::make_unique<Image>();
  Camera(idealCamera(), {}).render(scene, columns, random, *image);
  return image;
}

std::vector<Limb> painted(std::vector<Limb> limbs) {
  for (Limb& limb : limbs)
    for (Sphere& part : limb.part) part.colour = kPaint;
  return limbs;
}

int paintedPixels(const BodyPlace& place) {
  const auto image = rendered(place, painted(frontLegs(place)));
  int count = 0;
  for (std::size_t i = 0; i < kImagePixels; ++i)
    count += image->cr[i] < 60 && image->cb[i] > 170 ? 1 : 0;
  return count;
}

TEST(BodyShape, KneeIsALowerLegAwayFromTheFoot) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    for (const LegId leg : {LegId::leftFront, LegId::leftHind, LegId::rightFront}) {
      const body::LegAngles angles{Angle::deg(random.uniform(-60, 60)),
                                   Angle::deg(random.uniform(-5, 60)),
                                   Angle::deg(random.uniform(0, 90))};
      const Point3<Torso> d = body::footPosition(leg, angles) - kneePosition(leg, angles);
      const double length = leg == LegId::leftHind ? 8.314 : 7.736;
      EXPECT_NEAR(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), length, 1e-9);
    }
  }
}

TEST(BodyShape, FeetStandWhereTheyAreSetAndPawsAreOnTheGround) {
  const BodyPlace place = placed(0, 0, 0);
  const Feet feet = feetOf(place.joints, place.stance);
  const Point3<Robot> left = feet[index(LegId::leftFront)];
  EXPECT_NEAR(left.x, -9.5, 1e-6);
  EXPECT_NEAR(left.y, 4.0, 1e-6);
  EXPECT_NEAR(left.z, 0.0, 1e-6);
  const Sphere paw = frontLegs(place)[1].part.back();
  EXPECT_NEAR(paw.centre.z, paw.radius, 1e-6);
}

TEST(BodyShape, AnUpperLegIsAsLongAsRobotBodySays) {
  for (const std::size_t upper : {0U, 2U}) {
    const Limb limb = frontLegs(placed(0, 0, 0))[upper];
    const FieldPoint3 d = limb.part.back().centre - limb.part.front().centre;
    EXPECT_NEAR(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z),
                maths::hypot(maths::hypot(body::kUpperLeg, body::kKneeForward), body::kKneeOut),
                1e-9);
  }
}

TEST(BodyShape, ALimbHidesAllThatItsSpheresHide) {
  const BodyPlace place = placed(-75, 45, -10);
  Scene scene;
  for (const Limb& limb : painted(frontLegs(place)))
    scene.balls.insert(scene.balls.end(), limb.part.begin(), limb.part.end());
  ColumnCameras columns;
  columns.fill(fieldCamera(place.pose, body::cameraPose(place.joints, place.stance)));
  Random random(1);
  const auto spheres = std::make_unique<Image>();
  Camera(idealCamera(), {}).render(scene, columns, random, *spheres);
  std::vector<Limb> legs = painted(frontLegs(place));
  const auto limbs = rendered(place, legs);
  for (Limb& limb : legs) std::reverse(limb.part.begin(), limb.part.end());
  const auto reversed = rendered(place, legs);
  int shown = 0;
  for (std::size_t i = 0; i < kImagePixels; ++i) {
    if (spheres->cb[i] < 215) continue;
    ++shown;
    EXPECT_GT(std::min(limbs->cb[i], reversed->cb[i]), 200) << i;
  }
  EXPECT_GT(shown, 8000);
}

TEST(BodyShape, AHeadFarDownAndToTheSideSeesItsOwnPaw) {
  EXPECT_GT(paintedPixels(placed(-75, 45, -10)), 8000);
  EXPECT_GT(paintedPixels(placed(-50, 45, -15)), 1500);
  const auto image = rendered(placed(-75, 45, -10), frontLegs(placed(-75, 45, -10)));
  const Yuv middle = image->pixel(120, 60);
  EXPECT_NEAR(middle.cr, colours::kGrey.cr, 1);  // not the carpet's green
  EXPECT_NEAR(middle.y, colours::kGrey.y, 15);
}

TEST(BodyShape, AHeadThatLooksAheadDoesNotSeeItself) {
  for (const double tilt : {-75.0, -40.0, -20.0, 0.0})
    EXPECT_EQ(paintedPixels(placed(tilt, 0, 0)), 0) << tilt;
  for (const double pan : {-88.0, -45.0, 45.0, 88.0})
    EXPECT_EQ(paintedPixels(placed(-20, pan, 0)), 0) << pan;
}

// The pixel of the paw's middle, by robot/body's own projection, shows the paw.
TEST(BodyShape, APawIsSeenWhereTheJointsPutIt) {
  Random random(4);
  int shown = 0;
  for (int i = 0; i < 3000 && shown < 40; ++i) {
    const BodyPlace place =
        placed(random.uniform(-75, -40), random.uniform(20, 70), random.uniform(-15, 10));
    const CameraPose camera = body::cameraPose(place.joints, place.stance);
    const Point3<Robot> foot = feetOf(place.joints, place.stance)[index(LegId::leftFront)];
    const double radius = frontLegs(place)[1].part.back().radius;
    const auto pixel = body::project(camera, foot + Point3<Robot>{0, 0, radius});
    if (!pixel || pixel->x < 2 || pixel->x > 205 || pixel->y < 2 || pixel->y > 157) continue;
    const auto image = rendered(place, painted(frontLegs(place)));
    const Yuv value = image->pixel(static_cast<int>(pixel->x), static_cast<int>(pixel->y));
    EXPECT_NEAR(value.cb, kPaint.cb, 2) << "pose " << i;
    ++shown;
  }
  EXPECT_EQ(shown, 40);
}

// How many painted pixels each column has.
std::array<int, kImageWidth> paintedIn(const BodyPlace& place, const ColumnCameras& columns) {
  Scene scene;
  scene.own = painted(frontLegs(place));
  Random random(1);
  const auto image = std::make_unique<Image>();
  Camera(idealCamera(), {}).render(scene, columns, random, *image);
  std::array<int, kImageWidth> count{};
  for (std::size_t i = 0; i < kImagePixels; ++i) count[i % kImageWidth] += image->cb[i] > 170;
  return count;
}

// What is asked of three columns only must not lose a leg: a head that turns by 400 deg/s against
// one that stands still as each column sees it. Two see with one camera, and the left border of the
// first is from the camera before: the second of them is asked.
TEST(BodyShape, NoLegIsLostWhileTheHeadTurnsFast) {
  int whole = 0;
  for (const double rate : {-400.0, 400.0})
    for (double middle = 10.0; middle < 80.0; middle += 10.0) {
      const BodyPlace place = placed(-65, middle, -10);
      ColumnCameras turning, still;
      for (std::size_t x = 0; x < turning.size(); ++x) {
        const double late = (static_cast<double>(x) + 0.5) / kImageWidth - 0.5;
        const BodyPlace now = placed(-65, middle + rate / 30.0 * late, -10);
        turning[x] = fieldCamera(now.pose, body::cameraPose(now.joints, now.stance));
      }
      const auto turned = paintedIn(place, turning);
      for (std::size_t x = 1; x < turning.size(); x += 22) {
        still.fill(mixed(turning[x - 1], turning[x], 0.5));
        EXPECT_EQ(turned[x], paintedIn(place, still)[x]) << rate << " about " << middle;
        whole += turned[x];
      }
    }
  EXPECT_GT(whole, 1000);
}

}  // namespace
}  // namespace kelpie::sim

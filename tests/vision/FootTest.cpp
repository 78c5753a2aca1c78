// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "robot/body/Camera.h"
#include "tests/vision/PaintedRobot.h"
#include "vision/Foot.h"

namespace kelpie::vision {
namespace {

// A painting with its classes, for asking about feet.
struct Look {
  Look(const Painting& painting, const CameraPose& camera) : body(bodyOf(camera)) {
    paint(painting, camera, *image);
    sampler.reset();
  }
  Foot foot(PixelPoint from) const {
    return nearestFoot(scene, {from, -4, 4, 3, ColourClass::none});
  }
  double behind(PixelPoint at) const { return carpetBehind(scene, at, 20); }
  std::unique_ptr<VisionState> state = stateForPaintings();
  std::unique_ptr<Image> image = std::make_unique<Image>();
  Sampler sampler{*image, state->tables, state->classes};
  BodyState body;
  FixedVector<FieldEdgePercept, 3> edges;
  Lattice lattice{horizonFrameOf(body.camera)};
  body::FieldDescription field = *body::fieldDescription("2006");
  Scene scene{sampler, state->blobs, body, edges, lattice.frame(), lattice, state->runs, field};
};

Painting wallAt(double y, Paint paint) {
  Painting p;
  p.walls.push_back({{-6, y}, {6, y}, 0, 20, paint});
  return p;
}

PixelPoint seenAt(const CameraPose& camera, Point3<Robot> point) {
  return body::project(camera, point).value_or(PixelPoint{});
}

TEST(Foot, OfAWallIsWhereItStands) {
  for (const double y : {60.0, 120.0, 200.0}) {
    for (const double roll : {0.0, 50.0, -80.0}) {
      const CameraPose camera = cameraAt(17, 0, -8, roll);
      const Look look(wallAt(y, kWhitePaint), camera);
      const Foot foot = look.foot(seenAt(camera, {0, y, 10}));
      ASSERT_EQ(foot.end, FootEnd::carpet) << y << " " << roll;
      EXPECT_NEAR(foot.distance, y - 8, 1.0 + 0.03 * y) << roll;
    }
  }
}

TEST(Foot, BelowTheImageIsAtItsBorder) {
  const CameraPose camera = cameraAt(17, 0, 5);
  const Look look(wallAt(40, kWhitePaint), camera);
  EXPECT_EQ(look.foot(seenAt(camera, {0, 40, 14})).end, FootEnd::imageBorder);
}

TEST(Foot, BehindABallIsHidden) {
  const CameraPose camera = cameraAt(17, 0, -8);
  Painting p = wallAt(120, kWhitePaint);
  p.balls.push_back({0, 75});
  EXPECT_EQ(Look(p, camera).foot(seenAt(camera, {0, 120, 10})).end, FootEnd::hidden);
}

TEST(Foot, WhiteLineNearTheCarpetsEndDoesNotMoveIt) {
  const CameraPose camera = cameraAt(17, 0, -8);
  Painting p = wallAt(180, kFloorPaint);
  p.carpetEnd = 150;
  p.lineAt = 130;
  const Foot foot = Look(p, camera).foot(seenAt(camera, {0, 180, 12}));
  EXPECT_NEAR(foot.distance, 142, 6);
}

TEST(Foot, CarpetGoesOnBehindAThingInsideTheField) {
  const CameraPose camera = cameraAt(17, 0, -8);
  Painting p = wallAt(120, kWhitePaint);
  p.carpetEnd = 200;
  EXPECT_GT(Look(p, camera).behind(seenAt(camera, {0, 120, 0})), 6.0);
}

TEST(Foot, CarpetDoesNotGoOnBehindWhatStandsBeyondIt) {
  for (const double roll : {0.0, 20.0}) {
    const CameraPose camera = cameraAt(17, 0, -8, roll);
    Painting p = wallAt(180, kWhitePaint);
    p.carpetEnd = 150;
    EXPECT_LT(Look(p, camera).behind(seenAt(camera, {0, 150, 0})), 1.2) << roll;
  }
}

}  // namespace
}  // namespace kelpie::vision

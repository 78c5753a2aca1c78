// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "robot/body/Camera.h"
#include "tools/sim/camera/Camera.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {
namespace {

const Pose2 kPose{{170.0, 200.0}, Angle::deg(70.0)};

ColumnCameras still(const Pose2& pose, const CameraPose& camera) {
  ColumnCameras columns;
  columns.fill(fieldCamera(pose, camera));
  return columns;
}

CameraPose headAt(double tilt, double pan, double nod) {
  JointAngles joints;
  joints[Joint::neckTilt] = Angle::deg(tilt);
  joints[Joint::headPan] = Angle::deg(pan);
  joints[Joint::headNod] = Angle::deg(nod);
  return body::cameraPose(joints, {10.0, Angle::deg(14.25), {}});
}

Scene match() {
  Scene scene = fieldScene(*body::fieldDescription("2006"), 7);
  setBall(scene, {190.0, 290.0});
  setRobots(scene, {{{{250.0, 330.0}, Angle::deg(30.0)}, 10.0, TeamColour::blue}});
  return scene;
}

std::unique_ptr<Image> rendered(const Scene& scene, const ColumnCameras& columns,
                                const CameraParams& params, std::uint64_t seed = 3) {
  Random random(seed);
  const auto camera = std::make_unique<Camera>(params, randomCamera(random, {}));
  auto image = std::make_unique<Image>();
  camera->render(scene, columns, random, *image);
  return image;
}

std::uint64_t hashOf(const Image& image) {
  std::uint64_t hash = 1469598103934665603ULL;
  for (const Image::Plane* plane : {&image.y, &image.cr, &image.cb}) {
    for (const std::uint8_t byte : *plane) hash = (hash ^ byte) * 1099511628211ULL;
  }
  return hash;
}

// Centre of everything brighter than the dark floor.
PixelPoint brightCentre(const Image& image, double floor) {
  double sum = 0.0;
  PixelPoint centre;
  for (int y = 0; y < kImageHeight; ++y) {
    for (int x = 0; x < kImageWidth; ++x) {
      const double weight = image.pixel(x, y).y - floor;
      sum += weight;
      centre.x += weight * (x + 0.5);
      centre.y += weight * (y + 0.5);
    }
  }
  return {centre.x / sum, centre.y / sum};
}

TEST(Camera, SameSeedGivesSameBytes) {
  const Scene scene = match();
  const ColumnCameras columns = still(kPose, headAt(-10, 20, 5));
  const auto a = rendered(scene, columns, {}, 3);
  const auto b = rendered(scene, columns, {}, 3);
  const auto c = rendered(scene, columns, {}, 4);
  EXPECT_EQ(hashOf(*a), hashOf(*b));
  EXPECT_NE(hashOf(*a), hashOf(*c));
}

TEST(Camera, MarkerIsAtTheProjectedPixel) {
  Random random(11);
  int seen = 0;
  for (int i = 0; i < 400 && seen < 100; ++i) {
    const CameraPose camera =
        headAt(random.uniform(-40, 0), random.uniform(-80, 80), random.uniform(-10, 30));
    const PixelPoint aim{random.uniform(20, 188), random.uniform(15, 145)};
    const auto place = body::groundPoint(camera, aim);
    if (!place || place->norm() > 150.0 || place->norm() < 30.0) continue;
    Scene scene;
    scene.ceiling = scene.floor = colours::kBlack;
    scene.carpet = {Point2<Field>{0, 0}, Point2<Field>{0, 0}};
    scene.markers.push_back(
        {fieldFromRobot(kPose, *place), 0.02 * place->norm(), {235, 128, 128}, 0});
    const auto image = rendered(scene, still(kPose, camera), idealCamera());
    const PixelPoint centre = brightCentre(*image, static_cast<double>(colours::kBlack.y));
    EXPECT_LT(maths::hypot(centre.x - aim.x, centre.y - aim.y), 0.3) << "pose " << i;
    ++seen;
  }
  EXPECT_EQ(seen, 100);
}

TEST(Camera, BallHasTheSizeOfItsDistance) {
  const CameraPose camera = headAt(0, 0, 0);
  Scene scene;
  scene.ceiling = scene.floor = {0, 128, 128};
  const Point2<Robot> place{0.0, 100.0};
  setBall(scene, fieldFromRobot(kPose, place));
  scene.balls[0].colour = {200, 128, 128};
  const auto image = rendered(scene, still(kPose, camera), idealCamera());
  int wide = 0;
  const PixelPoint centre = *body::project(camera, {0.0, 100.0, body::kBallRadius});
  for (int x = 0; x < kImageWidth; ++x) {
    wide += image->pixel(x, static_cast<int>(centre.y)).y > 90 ? 1 : 0;
  }
  const Point3<Robot> d = Point3<Robot>{0.0, 100.0, body::kBallRadius} - camera.position;
  const double away = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  const double expected = 2.0 * 192.0 * 4.2 / std::sqrt(away * away - 4.2 * 4.2);
  EXPECT_NEAR(wide, expected, 1.2);
}

TEST(Camera, BeaconBandsAreInTheirOrder) {
  Scene scene = fieldScene(*body::fieldDescription("2006"), 0);
  // Left far beacon of the red team, blue above pink, seen from 150 cm.
  const Pose2 pose{{135.0, 405.0}, Angle::deg(180.0)};
  const CameraPose camera = headAt(0, 0, 12);
  const auto image = rendered(scene, still(pose, camera), idealCamera());
  const auto colourAt = [&](double height) {
    const Point2<Robot> at = robotFromField(pose, {-10.0, 405.0});
    const auto p = body::project(camera, {at.x, at.y, height});
    return image->pixel(static_cast<int>(p->x), static_cast<int>(p->y));
  };
  EXPECT_NEAR(colourAt(35).cb, colours::kBlue.cb, 3);
  EXPECT_NEAR(colourAt(25).cr, colours::kPink.cr, 3);
  EXPECT_GT(colourAt(15).y, 170);
  EXPECT_GT(colourAt(5).y, 170);
}

TEST(Camera, PanDuringExposureMovesColumnsApart) {
  Scene scene;
  scene.ceiling = scene.floor = colours::kBlack;
  const Point2<Robot> place = *body::groundPoint(headAt(-30, 0, 0), {104, 80});
  scene.markers.push_back({fieldFromRobot(kPose, place), 2.0, {235, 128, 128}, 0});
  ColumnCameras columns;
  for (std::size_t x = 0; x < columns.size(); ++x) {
    const double degrees = -6.0 + 12.0 * (static_cast<double>(x) + 0.5) / kImageWidth;
    columns[x] = fieldCamera(kPose, headAt(-30, degrees, 0));
  }
  const auto moving = rendered(scene, columns, idealCamera());
  const PixelPoint centre = brightCentre(*moving, static_cast<double>(colours::kBlack.y));
  EXPECT_NEAR(centre.x, 104.0, 0.5);  // the middle column has the middle pan
  int wide = 0;
  const auto rest = rendered(scene, still(kPose, headAt(-30, 0, 0)), idealCamera());
  for (int x = 0; x < kImageWidth; ++x) {
    wide += moving->pixel(x, 80).y > 120 ? 1 : 0;
    wide -= rest->pixel(x, 80).y > 120 ? 1 : 0;
  }
  EXPECT_GT(wide, 2);  // the head follows the marker, which smears it
}

// Where it shares columns and halves few: a noise of 2.5 levels lies over it.
TEST(Camera, FewPixelsAreThreeLevelsOffThoseOfColumnsInManyParts) {
  CameraParams few;
  few.artefacts.noise = false;
  CameraParams many = few;
  many.splits = 4;
  many.maxSlope = 0.0;
  int off = 0;
  for (const double pan : {-40.0, 0.0, 40.0}) {
    const ColumnCameras columns = still(kPose, headAt(-10, pan, 5));
    const auto a = rendered(match(), columns, few);
    const auto b = rendered(match(), columns, many);
    for (std::size_t i = 0; i < kImagePixels; ++i) off += std::abs(a->y[i] - b->y[i]) > 3 ? 1 : 0;
  }
  EXPECT_LT(off, static_cast<int>(3 * kImagePixels / 200));
  EXPECT_GT(off, 0);  // else nothing was measured
}

}  // namespace
}  // namespace kelpie::sim

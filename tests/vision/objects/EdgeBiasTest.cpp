// SPDX-License-Identifier: Apache-2.0
// What a camera adds to measured sizes is taken away before they tell a distance.
#include <gtest/gtest.h>

#include "tests/vision/Painting.h"

namespace kelpie::vision {
namespace {

constexpr double kEye = 8.0;  // cm of the camera before the neck base (cameraAt)

// Of something of `size` cm at `way` cm from the camera, which looks `bias` px larger than it is.
double farther(double way, double size, double bias) {
  const double pixels = Lens{}.focalLength * size / way;
  return way * bias / (pixels - bias);
}

double distanceOf(LandmarkKind kind, const Seen& seen) {
  const auto* landmark = find(seen.percepts, kind);
  return landmark == nullptr ? 0.0 : landmark->distance;
}

TEST(EdgeBias, MovesABeaconAsFarAsItsBandsAreSmaller) {
  constexpr double kBands = 20.0;
  Painting p;
  p.carpetEnd = 200;
  p.beacons.push_back({{0.0, 200.0}, kBluePaint, kPinkPaint});
  VisionParams biased;
  biased.beacon.edgeBias = 2.0;
  const CameraPose camera = cameraAt(16, 0, 3);
  const auto kind = LandmarkKind::beaconBlueOnPink;
  const double before = distanceOf(kind, look(p, camera));
  EXPECT_NEAR(before, 200.0, 8.0);
  EXPECT_NEAR(distanceOf(kind, look(p, camera, biased)) - before,
              farther(before - kEye - 5.0, kBands, 2.0), 1.0);
}

// Its back wall is measured.
TEST(EdgeBias, MovesAGoalAsFarAsItsHeightIsSmaller) {
  const body::FieldDescription field;
  Painting p;
  p.carpetEnd = 330;
  addGoal(p, 0, 300, kYellowPaint);
  VisionParams biased;
  biased.goal.edgeBias = 2.0;
  const CameraPose camera = cameraAt(16, 0, -4);
  const double before = distanceOf(LandmarkKind::goalYellow, look(p, camera));
  EXPECT_NEAR(before, 300.0, 15.0);
  EXPECT_NEAR(distanceOf(LandmarkKind::goalYellow, look(p, camera, biased)) - before,
              farther(before + field.goalDepth - kEye, field.goalHeight, 2.0), 2.0);
}

TEST(EdgeBias, MovesABallByItsRadiusAndBlurBringsASmallOneNearer) {
  Painting p;
  p.balls.push_back({0.0, 200.0});
  VisionParams bySize;
  bySize.ball.directionSd = Angle::deg(20);  // else the ground tells most
  VisionParams biased = bySize;
  biased.ball.edgeBias = 1.0;
  VisionParams blurred = bySize;
  blurred.ball.blur = 2.0;
  const CameraPose camera = cameraAt(16, 0, -8);
  const double before = look(p, camera, bySize).percepts.ball.distance;
  EXPECT_NEAR(before, 200.0, 8.0);
  EXPECT_NEAR(look(p, camera, biased).percepts.ball.distance - before,
              farther(before - kEye, body::kBallRadius, 1.0), 8.0);
  // r' - 2^2 / (2 r') = r: at 4.2 px of radius r' is 4.63, a tenth more.
  const double nearer = look(p, camera, blurred).percepts.ball.distance;
  EXPECT_NEAR((nearer - kEye) / (before - kEye), 0.91, 0.02);
}

}  // namespace
}  // namespace kelpie::vision

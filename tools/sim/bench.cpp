// SPDX-License-Identifier: Apache-2.0
// sim_bench: how many images per second the camera renders on one core, everything switched on, in
// a match scene with ball, seven robots and a crowd, the head sweeping.
#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <memory>

#include "robot/body/Camera.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/sim/camera/Camera.h"

namespace kelpie::sim {
namespace {

constexpr int kImages = 600;

BodyPlace sweeping(double image) {
  BodyPlace place;
  const double whole = std::floor(image);
  place.pose = {{180.0 + 60.0 * maths::sin(whole * 0.02), 200.0}, Angle::deg(whole * 1.2)};
  place.stance = {10.0, Angle::deg(14.25), {}};
  place.joints[Joint::headPan] = Angle::deg(60.0 * maths::sin(image * 0.15));
  place.joints[Joint::neckTilt] = Angle::deg(-20.0 + 15.0 * maths::sin(image * 0.11));
  return place;
}

ColumnCameras sweep(int image) {
  ColumnCameras cameras;
  for (std::size_t x = 0; x < cameras.size(); ++x) {
    const BodyPlace place = sweeping(image + static_cast<double>(x) / kImageWidth);
    cameras[x] = fieldCamera(place.pose, body::cameraPose(place.joints, place.stance));
  }
  return cameras;
}

std::vector<RobotLook> players() {
  std::vector<RobotLook> looks;
  looks.reserve(7);
  for (int i = 0; i < 7; ++i) {
    looks.push_back({{{60.0 + 40.0 * i, 120.0 + 55.0 * i}, Angle::deg(50.0 * i)},
                     10.0,
                     i < 3 ? TeamColour::red : TeamColour::blue,
                     100U + static_cast<std::uint64_t>(i)});
  }
  return looks;
}

int run() {
  const auto field = body::fieldDescription("2006");
  if (!field) {
    fmt::print(stderr, "sim_bench: {}\n", field.error());
    return 1;
  }
  Random random(1);
  Scene scene = fieldScene(*field, 5);
  setBall(scene, {200, 260});
  const std::vector<RobotLook> looks = players();
  const auto camera = std::make_unique<Camera>(CameraParams{}, randomCamera(random, {}));
  const auto image = std::make_unique<Image>();
  std::uint64_t sum = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kImages; ++i) {
    setRobots(scene, looks);
    BodyPlace self = sweeping(i);
    setFrontFeet(self.joints, self.stance, {Point2<Robot>{-9.5, 2.0}, {9.5, 2.0}});
    scene.own = frontLegs(self);
    camera->render(scene, sweep(i), random, *image);
    sum += image->y[static_cast<std::size_t>(i)];
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  fmt::print("{} images in {:.2f} s: {:.0f} images/s (check {})\n", kImages, took.count(),
             kImages / took.count(), sum);
  return 0;
}

}  // namespace
}  // namespace kelpie::sim

int main() { return kelpie::sim::run(); }

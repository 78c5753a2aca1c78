// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/views/Visibility.h"

#include <algorithm>

#include "vision/pixels/Sampler.h"

namespace kelpie::experiments {
namespace {

// No object of the scene has less than Cr 95, so half of this one and half of another is below 60.
constexpr sim::Colour kUnique{128.0F, 0.0F, 128.0F};
constexpr int kHalf = 60;

sim::CameraParams plainCamera() {
  sim::CameraParams params = sim::idealCamera();
  params.splits = 1;
  return params;
}

void mark(sim::Solid& solid) {
  for (auto& quad : solid.quads) quad.colour = kUnique;
}

sim::Scene withoutMoving(const sim::Scene& scene) {
  sim::Scene bare = scene;
  bare.balls.clear();
  bare.robots.clear();
  bare.own.clear();
  return bare;
}

}  // namespace

Visibility::Visibility()
    : camera_(plainCamera(), {}), image_(std::make_unique<Image>()), random_(1) {}

Shown Visibility::shown(const sim::Scene& scene, const View& view) {
  camera_.render(scene, view.columns, random_, *image_);
  Shown result;
  result.box = {kImageWidth, kImageHeight, 0.0, 0.0};
  for (int y = vision::kUsableTop; y < vision::kUsableBottom; ++y)
    for (int x = vision::kUsableLeft; x < vision::kUsableRight; ++x) {
      if (image_->cr[Image::at(x, y)] >= kHalf) continue;
      ++result.pixels;
      result.box = {std::min(result.box.left, x * 1.0), std::min(result.box.top, y * 1.0),
                    std::max(result.box.right, x + 1.0), std::max(result.box.bottom, y + 1.0)};
    }
  return result;
}

Shown Visibility::ball(const View& view) {
  sim::Scene scene = view.scene;
  for (auto& ball : scene.balls) ball.colour = kUnique;
  return shown(scene, view);
}

Shown Visibility::beacon(const View& view, std::size_t index) {
  sim::Scene scene = view.scene;
  scene.beacons[index].band[2] = scene.beacons[index].band[3] = kUnique;
  return shown(scene, view);
}

Shown Visibility::goal(const View& view, std::size_t index) {
  sim::Scene scene = view.scene;
  mark(scene.fixtures[index]);
  return shown(scene, view);
}

Shown Visibility::uniform(const View& view, std::size_t index) {
  sim::Scene scene = view.scene;
  for (auto& quad : scene.robots[index].quads)
    if (quad.depthBias > 0.0) quad.colour = kUnique;
  return shown(scene, view);
}

Shown Visibility::ballAlone(const View& view) {
  sim::Scene scene = withoutMoving(view.scene);
  scene.balls = view.scene.balls;
  for (auto& ball : scene.balls) ball.colour = kUnique;
  return shown(scene, view);
}

Shown Visibility::beaconAlone(const View& view, std::size_t index) {
  sim::Scene scene = withoutMoving(view.scene);
  scene.beacons[index].band[2] = scene.beacons[index].band[3] = kUnique;
  return shown(scene, view);
}

Shown Visibility::goalAlone(const View& view, std::size_t index) {
  sim::Scene scene = withoutMoving(view.scene);
  mark(scene.fixtures[index]);
  return shown(scene, view);
}

Shown Visibility::robot(const View& view, std::size_t index) {
  sim::Scene scene = view.scene;
  mark(scene.robots[index]);
  return shown(scene, view);
}

Shown Visibility::robotAlone(const View& view, std::size_t index) {
  sim::Scene scene = withoutMoving(view.scene);
  scene.beacons.clear();
  scene.robots.push_back(view.scene.robots[index]);
  mark(scene.robots[0]);
  return shown(scene, view);
}

}  // namespace kelpie::experiments

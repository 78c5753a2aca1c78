// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/views/SeenRobots.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "vision/pixels/Sampler.h"

namespace kelpie::experiments {
namespace {

// No thing on a field has Cr near these.
constexpr float kBodyCr = 245.0F;
constexpr float kPatchCr = 10.0F;
constexpr double kTolerance = 25.0;
constexpr double kFirstCb = 20.0;
constexpr double kCbStep = 40.0;

struct Count {
  double body = 0.0;  // sr, in units of one pixel in the middle of the image
  double patch = 0.0;
  double patchPixels = 0.0;
  PixelBox box{1e9, 1e9, -1e9, -1e9};
};

sim::Scene recoloured(sim::Scene scene) {
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const auto cb = static_cast<float>(kFirstCb + kCbStep * static_cast<double>(i));
    for (sim::Quad& quad : scene.robots[i].quads)
      quad.colour = {128.0F, quad.depthBias > 0.0 ? kPatchCr : kBodyCr, cb};
  }
  return scene;
}

// Pixels away from the middle cover less of the view: the cube of the cosine to the axis.
double weightOf(const sim::Lens& lens, int px, int py) {
  const double dx = (px + 0.5 - lens.principalX) / lens.focal;
  const double dy = (py + 0.5 - lens.principalY) / lens.focal;
  const double cosine = 1.0 / std::sqrt(1.0 + dx * dx + dy * dy);
  return cosine * cosine * cosine;
}

Count countOf(const Image& image, const sim::Lens& lens, std::size_t robot) {
  const double cb = kFirstCb + kCbStep * static_cast<double>(robot);
  Count count;
  for (int py = vision::kUsableTop; py < vision::kUsableBottom; ++py) {
    for (int px = vision::kUsableLeft; px < vision::kUsableRight; ++px) {
      const Yuv c = image.pixel(px, py);
      const bool patch = std::fabs(c.cr - static_cast<double>(kPatchCr)) < kTolerance;
      const bool shell = std::fabs(c.cr - static_cast<double>(kBodyCr)) < kTolerance;
      if ((!patch && !shell) || std::fabs(c.cb - cb) > kTolerance * 0.75) continue;
      count.body += weightOf(lens, px, py);
      count.patchPixels += patch ? 1.0 : 0.0;
      count.box = {std::min(count.box.left, px + 0.0), std::min(count.box.top, py + 0.0),
                   std::max(count.box.right, px + 1.0), std::max(count.box.bottom, py + 1.0)};
    }
  }
  return count;
}

sim::FieldPoint3 unit(sim::FieldPoint3 v) {
  const double n = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {v.x / n, v.y / n, v.z / n};
}

sim::FieldPoint3 cross(sim::FieldPoint3 a, sim::FieldPoint3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The same place, turned so that the target is in the middle of the image.
sim::FieldCamera lookingAt(const sim::FieldCamera& from, sim::FieldPoint3 target) {
  sim::FieldCamera camera;
  camera.position = from.position;
  camera.lens = from.lens;
  camera.forward = unit(target - from.position);
  camera.right = unit(cross(camera.forward, {0.0, 0.0, 1.0}));
  camera.down = cross(camera.forward, camera.right);
  return camera;
}

Count rendered(const sim::Scene& scene, const sim::ColumnCameras& columns, std::size_t robot,
               Image& image) {
  sim::CameraParams params = sim::idealCamera();
  params.splits = 1;
  sim::Camera camera(params, {});
  Random random(1);
  camera.render(scene, columns, random, image);
  return countOf(image, columns[0].lens, robot);
}

// Of the robot alone, in the middle of the image.
Count inFullView(const View& view, const sim::Scene& marked, std::size_t robot, Image& image) {
  sim::Scene alone;
  alone.robots.resize(robot);
  alone.robots.push_back(marked.robots[robot]);
  sim::ColumnCameras columns;
  columns.fill(lookingAt(view.columns[kImageWidth / 2], marked.robots[robot].centre));
  return rendered(alone, columns, robot, image);
}

}  // namespace

std::vector<SeenRobot> seenRobots(const View& view) {
  std::vector<SeenRobot> seen;
  if (view.robots.empty()) return seen;
  const auto image = std::make_unique<Image>();
  const auto other = std::make_unique<Image>();
  const sim::Scene marked = recoloured(view.scene);
  rendered(marked, view.columns, 0, *image);
  for (std::size_t i = 0; i < view.robots.size(); ++i) {
    const Count shown = countOf(*image, view.columns[0].lens, i);
    if (shown.body <= 0.0) continue;
    const sim::RobotLook& look = view.robots[i];
    const Point2<Robot> middle = robotFromField(view.pose, fieldFromRobot(look.pose, {0.0, -4.0}));
    SeenRobot robot;
    robot.team = look.team;
    robot.distance = middle.norm();
    robot.heading = bearing(middle);
    robot.turned = look.pose.heading - view.pose.heading - robot.heading;
    robot.share = std::min(1.0, shown.body / inFullView(view, marked, i, *other).body);
    robot.patchPixels = shown.patchPixels;
    robot.box = shown.box;
    seen.push_back(robot);
  }
  return seen;
}

}  // namespace kelpie::experiments

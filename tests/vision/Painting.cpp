// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/Painting.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Random.h"
#include "vision/Vision.h"
#include "vision/colour/RingTable.h"

namespace kelpie::vision {
namespace {

struct Vec {
  double x, y, z;
};

struct Hit {
  double range = 1e9;
  Paint paint = kWallPaint;
};

void meet(Hit& hit, double range, Paint paint) {
  if (range > 1e-6 && range < hit.range) hit = {range, paint};
}

void castGround(const Painting& p, Vec o, Vec d, Hit& hit) {
  if (d.z >= 0.0) return;
  const double t = -o.z / d.z;
  const double y = o.y + t * d.y;
  if (y > p.carpetEnd + 300.0) return;
  const bool line = p.lineAt > 0.0 && std::fabs(y - p.lineAt) < 1.25;
  meet(hit, t, y > p.carpetEnd ? kFloorPaint : line ? kWhitePaint : p.carpet);
}

void castBall(const PaintedBall& b, Vec o, Vec d, Hit& hit) {
  const Vec c{b.x - o.x, b.y - o.y, b.z - o.z};
  const double along = c.x * d.x + c.y * d.y + c.z * d.z;
  const double off = c.x * c.x + c.y * c.y + c.z * c.z - along * along;
  if (off < b.radius * b.radius) meet(hit, along - std::sqrt(b.radius * b.radius - off), b.paint);
}

void castWall(const PaintedWall& w, Vec o, Vec d, Hit& hit) {
  const double ex = w.to.x - w.from.x;
  const double ey = w.to.y - w.from.y;
  const double cross = d.x * ey - d.y * ex;
  if (std::fabs(cross) < 1e-12) return;
  const double fx = w.from.x - o.x;
  const double fy = w.from.y - o.y;
  const double t = (fx * ey - fy * ex) / cross;
  const double s = (fx * d.y - fy * d.x) / cross;
  const double z = o.z + t * d.z;
  if (s >= 0.0 && s <= 1.0 && z >= w.low && z <= w.high) meet(hit, t, w.paint);
}

void castBeacon(const PaintedBeacon& b, Vec o, Vec d, Hit& hit) {
  const double a = d.x * d.x + d.y * d.y;
  const double cx = b.centre.x - o.x;
  const double cy = b.centre.y - o.y;
  const double half = cx * d.x + cy * d.y;
  const double root = half * half - a * (cx * cx + cy * cy - b.radius * b.radius);
  if (root < 0.0) return;
  const double t = (half - std::sqrt(root)) / a;
  const double band = (o.z + t * d.z - b.lift) / b.bandHeight;
  if (band < 0.0 || band > 4.0) return;
  meet(hit, t, band < 2.0 ? b.foot : band < 3.0 ? b.lower : b.upper);
}

Paint cast(const Painting& p, const CameraPose& camera, double px, double py) {
  const double cx = px - 104.0;
  const double cy = py - 80.0;
  const double n = std::sqrt(cx * cx + cy * cy + 192.0 * 192.0);
  const auto& a = camera.axes;
  const Vec d{(a[0] * cx + a[1] * cy + a[2] * 192.0) / n,
              (a[3] * cx + a[4] * cy + a[5] * 192.0) / n,
              (a[6] * cx + a[7] * cy + a[8] * 192.0) / n};
  const Vec o{camera.position.x, camera.position.y, camera.position.z};
  Hit hit;
  castGround(p, o, d, hit);
  for (const auto& ball : p.balls) castBall(ball, o, d, hit);
  for (const auto& wall : p.walls) castWall(wall, o, d, hit);
  for (const auto& beacon : p.beacons) castBeacon(beacon, o, d, hit);
  return hit.paint;
}

std::uint8_t byteOf(double v) {
  return static_cast<std::uint8_t>(std::min(255.0, std::max(0.0, std::round(v))));
}

// Four by four rays to a pixel.
Paint mixed(const Painting& p, const CameraPose& camera, int px, int py) {
  Paint sum{0, 0, 0};
  for (int i = 0; i < 16; ++i) {
    const int row = i / 4;
    const Paint c = cast(p, camera, px + (i % 4 + 0.5) / 4.0, py + (row + 0.5) / 4.0);
    sum = {sum.y + c.y / 16.0, sum.cr + c.cr / 16.0, sum.cb + c.cb / 16.0};
  }
  return sum;
}

}  // namespace

CameraPose cameraAt(double height, double left, double up, double roll) {
  const double k = std::acos(-1.0) / 180.0;
  const double sl = std::sin(left * k), cl = std::cos(left * k);
  const double su = std::sin(up * k), cu = std::cos(up * k);
  const double sr = std::sin(roll * k), cr = std::cos(roll * k);
  const Vec forward{-sl * cu, cl * cu, su};
  const Vec level{cl, sl, 0.0};
  const Vec down{-sl * su, cl * su, -cu};
  const Vec x{cr * level.x + sr * down.x, cr * level.y + sr * down.y, sr * down.z};
  const Vec y{cr * down.x - sr * level.x, cr * down.y - sr * level.y, cr * down.z};
  CameraPose pose;
  pose.position = {0.0, 8.0, height};
  pose.axes = {x.x, y.x, forward.x, x.y, y.y, forward.y, x.z, y.z, forward.z};
  return pose;
}

BodyState bodyOf(const CameraPose& camera) {
  BodyState body;
  body.camera = camera;
  const auto& a = camera.axes;
  const auto row = [&a](double px) { return 80.0 - (a[6] * (px - 104.0) + a[8] * 192.0) / a[7]; };
  body.horizon = {row(0.0), row(kImageWidth)};
  return body;
}

void paint(const Painting& painting, const CameraPose& camera, Image& image) {
  Random random(11);
  const RingModel ring = painting.ring ? ringModel2006() : RingModel{};
  for (int py = 0; py < kImageHeight; ++py) {
    for (int px = 0; px < kImageWidth; ++px) {
      const Paint c = mixed(painting, camera, px, py);
      const double d = std::hypot(px + 0.5 - 104.0, py + 0.5 - 80.0);
      const auto value = [&](std::size_t channel, double v) {
        const double noise = painting.noise > 0.0 ? random.gaussian(0.0, painting.noise) : 0.0;
        return byteOf(ringDistort(ring.channel[channel], v, d) + noise);
      };
      image.set(px, py, {value(0, c.y), value(1, c.cr), value(2, c.cb)});
    }
  }
}

std::unique_ptr<VisionState> stateForPaintings() {
  return std::make_unique<VisionState>(*loadCalibration("nominal", "2006"));
}

Seen look(const Painting& painting, const CameraPose& camera, const VisionParams& params) {
  Seen seen{{}, stateForPaintings()};
  const auto input = std::make_unique<FrameInput>();
  paint(painting, camera, input->image);
  seen.percepts = step({*input, bodyOf(camera)}, params, *seen.state);
  return seen;
}

const LandmarkPercept* find(const Percepts& percepts, LandmarkKind kind) {
  for (const auto& landmark : percepts.landmarks) {
    if (landmark.kind == kind) return &landmark;
  }
  return nullptr;
}

void addGoal(Painting& painting, double x, double y, Paint colour) {
  const Point2<Robot> left{x - 40.0, y};
  const Point2<Robot> right{x + 40.0, y};
  const Point2<Robot> backLeft{x - 40.0, y + 30.0};
  const Point2<Robot> backRight{x + 40.0, y + 30.0};
  painting.walls.push_back({left, backLeft, 0.0, 30.0, colour});
  painting.walls.push_back({backLeft, backRight, 0.0, 30.0, colour});
  painting.walls.push_back({backRight, right, 0.0, 30.0, colour});
}

}  // namespace kelpie::vision

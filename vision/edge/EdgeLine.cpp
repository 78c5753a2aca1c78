// SPDX-License-Identifier: Apache-2.0
#include "vision/edge/EdgeLine.h"

#include <cmath>

#include "robot/body/Camera.h"

namespace kelpie::vision {
namespace {

EdgeLine oriented(double nx, double ny, PixelPoint on, const HorizonFrame& frame) {
  const ImageDirection up = frame.up();
  const double side = nx * up.dx + ny * up.dy < 0.0 ? -1.0 : 1.0;
  return {side * nx, side * ny, side * (nx * on.x + ny * on.y), 0, 0, 0.0};
}

// Camera coordinates of the horizontal direction along a line on the ground, any length.
Point3<Camera> groundDirection(const EdgeLine& line, const HorizonFrame& frame) {
  const double beyond = line.distanceBeyond({frame.lens.principalX, frame.lens.principalY});
  const double nz = beyond / frame.lens.focalLength;
  const ImageDirection up = frame.up();
  const double uz = frame.middleAbove / frame.lens.focalLength;
  return {line.ny * uz - nz * up.dy, nz * up.dx - line.nx * uz, line.nx * up.dy - line.ny * up.dx};
}

// Mean and covariance.
struct Spread {
  PixelPoint mean;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  double min() const {  // the smaller variance of the two main directions
    const double half = 0.5 * (xx - yy);
    return 0.5 * (xx + yy) - std::sqrt(half * half + xy * xy);
  }
};

Spread spreadOf(const EdgeMoments& m) {
  const PixelPoint mean{m.x / m.n, m.y / m.n};
  return {mean, m.xx / m.n - mean.x * mean.x, m.xy / m.n - mean.x * mean.y,
          m.yy / m.n - mean.y * mean.y};
}

constexpr double kMinNorm = 1e-9;  // a shorter vector has no direction: all points are one

double dot(const Point3<Camera>& a, const Point3<Camera>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace

EdgeLine lineThrough(PixelPoint a, PixelPoint b, const HorizonFrame& frame) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double norm = std::sqrt(dx * dx + dy * dy);
  if (!(norm > kMinNorm)) return oriented(frame.up().dx, frame.up().dy, a, frame);
  return oriented(dy / norm, -dx / norm, a, frame);
}

EdgeLine lineOf(const EdgeMoments& m, const HorizonFrame& frame) {
  const Spread s = spreadOf(m);
  const double min = s.min();
  // The normal is the direction of least spread, (S - least I) n = 0; of its two rows the longer
  // one is far from 0/0.
  const double a = s.xx - min;
  const double b = s.yy - min;
  const double nx = a > b ? -s.xy : b;
  const double ny = a > b ? a : -s.xy;
  const double norm = std::sqrt(nx * nx + ny * ny);
  if (!(norm > kMinNorm)) return oriented(frame.up().dx, frame.up().dy, s.mean, frame);
  return oriented(nx / norm, ny / norm, s.mean, frame);
}

double EdgeMoments::leastSquares() const { return n * std::fmax(0.0, spreadOf(*this).min()); }

double groundCosine(const EdgeLine& a, const EdgeLine& b, const HorizonFrame& frame) {
  const Point3<Camera> p = groundDirection(a, frame);
  const Point3<Camera> q = groundDirection(b, frame);
  const double lengths = std::sqrt(dot(p, p) * dot(q, q));
  return lengths > 0.0 ? std::fabs(dot(p, q)) / lengths : 1.0;
}

}  // namespace kelpie::vision

// SPDX-License-Identifier: Apache-2.0
#include "vision/ball/ConeFit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "robot/body/Camera.h"
#include "robot/core/Maths.h"
#include "robot/core/ScratchVector.h"

namespace kelpie::vision {
namespace {

using Ray = std::array<double, 3>;
using Kept = std::uint32_t;  // a bit for each point
static_assert(kMaxEdgePoints < 32);

struct Outline {
  ScratchVector<Ray, kMaxEdgePoints> rays;
  const Lens& lens;
};

struct Fit {
  Cone cone;  // without its rms
  Kept kept = 0;
};

Kept bitOf(std::size_t point) { return Kept{1} << point; }

Ray rayOf(const Lens& lens, PixelPoint p) {
  const Point3<Camera> ray = body::pixelRay(lens, p);
  const double norm = std::sqrt(ray.x * ray.x + ray.y * ray.y + maths::square(ray.z));
  return {ray.x / norm, ray.y / norm, ray.z / norm};
}

double det(const Ray& a, const Ray& b, const Ray& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
         c[0] * (a[1] * b[2] - a[2] * b[1]);
}

// Solves sum(u u^T) n = sum(u) by Cramer's rule; false when the points do not span a cone.
bool solve(const Outline& outline, Kept kept, Ray& n) {
  std::array<Ray, 3> columns{};
  Ray right{};
  for (std::size_t i = 0; i < outline.rays.size(); ++i) {
    if ((kept & bitOf(i)) == 0) continue;
    const Ray& u = outline.rays[i];
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t r = 0; r <= c; ++r) columns[c][r] += u[r] * u[c];
      right[c] += u[c];
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t r = c + 1; r < 3; ++r) columns[c][r] = columns[r][c];
  constexpr double kMinDeterminant = 1e-12;
  const double whole = det(columns[0], columns[1], columns[2]);
  if (!(whole > kMinDeterminant)) return false;
  n = {det(right, columns[1], columns[2]) / whole, det(columns[0], right, columns[2]) / whole,
       det(columns[0], columns[1], right) / whole};
  return true;
}

Cone coneOf(const Ray& n, const Lens& lens) {
  constexpr double kMinForward = 0.1;  // of the axis: the ball is before the camera
  Cone cone;
  const double norm = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(norm > 1.0) || !(n[2] > kMinForward)) return cone;
  cone.valid = true;
  cone.axis = {n[0] / norm, n[1] / norm, n[2] / norm};
  cone.sinHalf = std::sqrt(1.0 - 1.0 / (norm * norm));
  cone.radius = lens.focalLength * cone.sinHalf * norm;
  cone.centre = body::pixelOf(lens, {n[0], n[1], n[2]});
  return cone;
}

// Distance of an edge point from the cone, in pixels at the middle of the image; outside positive.
double offCone(const Cone& cone, const Ray& u, double focalLength) {
  const double cosine = u[0] * cone.axis.x + u[1] * cone.axis.y + u[2] * cone.axis.z;
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  return focalLength * sine / cosine - cone.radius;
}

double rmsOf(const Outline& outline, const Fit& fit) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.rays.size(); ++i) {
    if ((fit.kept & bitOf(i)) == 0) continue;
    const double off = offCone(fit.cone, outline.rays[i], outline.lens.focalLength);
    sum += off * off;
  }
  return fit.cone.kept > 0 ? std::sqrt(sum / static_cast<double>(fit.cone.kept)) : 0.0;
}

// The points that offCone() puts near the cone, found by bounds of the cosine's square: a root and
// a quotient for each point of each round took 60,000 of an image's 3 million cycles.
Kept nearTo(const Outline& outline, const Cone& cone) {
  constexpr double kMinLimit = 0.8;     // px
  constexpr double kLimitShare = 0.07;  // of the radius
  const double limit = std::max(kMinLimit, kLimitShare * cone.radius);
  const double perFocalLength = 1.0 / outline.lens.focalLength;
  const double outer = 1.0 + maths::square((cone.radius + limit) * perFocalLength);
  const double inner = 1.0 + maths::square(std::max(0.0, cone.radius - limit) * perFocalLength);
  Kept near = 0;
  for (std::size_t i = 0; i < outline.rays.size(); ++i) {
    const Ray& u = outline.rays[i];
    const double cosine = u[0] * cone.axis.x + u[1] * cone.axis.y + u[2] * cone.axis.z;
    const double square = cosine * cosine;
    if (cosine > 0.0 && square * outer >= 1.0 && (inner == 1.0 || square * inner <= 1.0))
      near |= bitOf(i);
  }
  return near;
}

std::size_t countOf(Kept kept) {
  std::size_t count = 0;
  for (; kept != 0; kept &= kept - 1) ++count;
  return count;
}

// Fits the kept points, then whatever lies near that cone, until nothing changes. Nothing where
// fewer than `min` lie near the first one.
Fit refined(const Outline& outline, Kept kept, std::size_t min) {
  Fit fit;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    Ray n{};
    if (!solve(outline, kept, n)) return {};
    fit.cone = coneOf(n, outline.lens);
    if (!fit.cone.valid) return {};
    fit.kept = nearTo(outline, fit.cone);
    fit.cone.kept = countOf(fit.kept);
    if (fit.kept == kept) return fit;
    if (round == 0 && fit.cone.kept < min) return {};
    kept = fit.kept;
  }
  return fit;
}

// The cone through three points with the most others near it: for an outline that something hides
// in part, where the fit of all points lies between both outlines.
Fit bestOfTriples(const Outline& outline) {
  constexpr std::size_t kMin = 5;  // a triple with no two others near its cone is no outline
  constexpr std::array<std::size_t, 3> kGaps{2U, 3U, 5U};  // points, from one to the next
  Fit best;
  const std::size_t n = outline.rays.size();
  for (const std::size_t gap : kGaps) {
    if (2 * gap >= n) break;
    for (std::size_t i = 0; i < n; ++i) {
      const Kept triple = bitOf(i) | bitOf((i + gap) % n) | bitOf((i + 2 * gap) % n);
      const Fit fit = refined(outline, triple, kMin);
      if (fit.cone.valid && fit.cone.kept > best.cone.kept) best = fit;
    }
  }
  return best;
}

}  // namespace

Cone fitCone(const EdgePoints& points, const Lens& lens) {
  Outline outline{{}, lens};
  for (const PixelPoint p : points) outline.rays.push_back(rayOf(lens, p));
  Fit fit = refined(outline, bitOf(points.size()) - 1, 0);
  if (!fit.cone.valid || fit.cone.kept + 2 < points.size()) {
    const Fit other = bestOfTriples(outline);
    if (other.cone.kept > fit.cone.kept) fit = other;
  }
  fit.cone.rms = rmsOf(outline, fit);
  return fit.cone;
}

}  // namespace kelpie::vision

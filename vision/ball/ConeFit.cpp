// SPDX-License-Identifier: Apache-2.0
#include "vision/ball/ConeFit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/body/Camera.h"
#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

using Ray = std::array<double, 3>;
using Kept = std::array<bool, kMaxEdgePoints>;

struct Outline {
  FixedVector<Ray, kMaxEdgePoints> rays;
  const Lens& lens;
};

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
bool solve(const Outline& outline, const Kept& kept, Ray& n) {
  std::array<Ray, 3> columns{};
  Ray right{};
  for (std::size_t i = 0; i < outline.rays.size(); ++i) {
    if (!kept[i]) continue;
    const Ray& u = outline.rays[i];
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t r = 0; r <= c; ++r) columns[c][r] += u[r] * u[c];
      right[c] += u[c];
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t r = c + 1; r < 3; ++r) columns[c][r] = columns[r][c];
  const double whole = det(columns[0], columns[1], columns[2]);
  if (!(whole > 1e-12)) return false;
  n = {det(right, columns[1], columns[2]) / whole, det(columns[0], right, columns[2]) / whole,
       det(columns[0], columns[1], right) / whole};
  return true;
}

Cone coneOf(const Ray& n, const Lens& lens) {
  Cone cone;
  const double norm = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(norm > 1.0) || !(n[2] > 0.1)) return cone;
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

// Keeps the points near the cone and notes their rms; the number that changed sides.
std::size_t trim(const Outline& outline, Cone& cone, Kept& kept) {
  const double limit = std::max(0.8, 0.07 * cone.radius);
  double sum = 0.0;
  std::size_t dropped = 0;
  cone.kept = 0;
  for (std::size_t i = 0; i < outline.rays.size(); ++i) {
    const double off = offCone(cone, outline.rays[i], outline.lens.focalLength);
    const bool near = std::fabs(off) <= limit;
    if (kept[i] != near) ++dropped;
    kept[i] = near;
    if (!near) continue;
    sum += off * off;
    ++cone.kept;
  }
  cone.rms = cone.kept > 0 ? std::sqrt(sum / static_cast<double>(cone.kept)) : 0.0;
  return dropped;
}

// Fits the kept points, then whatever lies near that cone, until nothing changes. Nothing where
// fewer than `least` lie near the first one.
Cone refined(const Outline& outline, Kept kept, std::size_t least) {
  Cone cone;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    Ray n{};
    if (!solve(outline, kept, n)) return {};
    cone = coneOf(n, outline.lens);
    if (!cone.valid || trim(outline, cone, kept) == 0) return cone;
    if (round == 0 && cone.kept < least) return {};
  }
  return cone;
}

// The cone through three points with the most others near it: for an outline that something hides
// in part, where the fit of all points lies between both outlines.
Cone bestOfTriples(const Outline& outline) {
  constexpr std::size_t kLeast = 5;  // a triple with no two others near its cone is no outline
  Cone best;
  const std::size_t n = outline.rays.size();
  for (const std::size_t gap : {2U, 3U, 5U}) {
    if (2 * gap >= n) break;
    for (std::size_t i = 0; i < n; ++i) {
      Kept kept{};
      kept[i] = kept[(i + gap) % n] = kept[(i + 2 * gap) % n] = true;
      const Cone cone = refined(outline, kept, kLeast);
      if (cone.valid && cone.kept > best.kept) best = cone;
    }
  }
  return best;
}

}  // namespace

Cone fitCone(const EdgePoints& points, const Lens& lens) {
  Outline outline{{}, lens};
  for (const PixelPoint p : points) outline.rays.push_back(rayOf(lens, p));
  Kept all;
  all.fill(true);
  const Cone cone = refined(outline, all, 0);
  if (cone.valid && cone.kept + 2 >= points.size()) return cone;
  const Cone other = bestOfTriples(outline);
  return other.kept > cone.kept ? other : cone;
}

}  // namespace kelpie::vision

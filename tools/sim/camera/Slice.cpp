// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/camera/Slice.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr double kNear = 1.0;    // cm: what is nearer than this is not drawn
constexpr double kFarRow = 1e5;  // a row beyond every image
constexpr double kFlat = 1e-9;
constexpr double kLimbTop = 1.1;  // light on a limb's upper and lower edge
constexpr double kLimbFoot = 0.88;

double dot(FieldPoint3 a, FieldPoint3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

Corners cornersOf(const Quad& shape) {
  Corners corners{};
  for (std::size_t i = 0; i < 4; ++i) {
    corners.x[i] = shape.corner[i].x;
    corners.y[i] = shape.corner[i].y;
    corners.z[i] = shape.corner[i].z;
  }
  return corners;
}

void see(const FieldCamera& camera, const Quad& shape, const Corners& corners, SeenQuad& seen) {
  seen.shape = &shape;
  seen.turnedAway = shape.oneSided && dot(shape.normal, camera.position - shape.corner[0]) <= 0.0;
  if (seen.turnedAway) return;
  const FieldPoint3 at = camera.position, right = camera.right;
  const FieldPoint3 down = camera.down, forward = camera.forward;
  // What is written lies on top of nothing that is read: the four are seen at once.
  double* __restrict seenRight = seen.right.data();
  double* __restrict seenDown = seen.down.data();
  double* __restrict seenDepth = seen.depth.data();
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = corners.x[i] - at.x, y = corners.y[i] - at.y, z = corners.z[i] - at.z;
    seenRight[i] = right.x * x + right.y * y + right.z * z;
    seenDown[i] = down.x * x + down.y * y + down.z * z;
    seenDepth[i] = forward.x * x + forward.y * y + forward.z * z;
  }
}

Slice::Slice(const FieldCamera& camera, double x)
    : camera_(camera), u_((x - camera.lens.principalX) / camera.lens.focal) {
  const FieldPoint3& r = camera.right;
  const FieldPoint3& f = camera.forward;
  normal_ = {r.x - u_ * f.x, r.y - u_ * f.y, r.z - u_ * f.z};
  inverseNormal_ = 1.0 / std::sqrt(1.0 + u_ * u_);
}

bool Slice::mayMeet(FieldPoint3 centre, double radius, double margin) const {
  const FieldPoint3 d = centre - camera_.position;
  const double depth = dot(camera_.forward, d);
  if (depth + radius < kNear) return false;
  const double off = std::fabs(dot(normal_, d)) * inverseNormal_;
  return off <= radius + margin * (depth + radius);
}

double Slice::rowOf(double down, double depth) const {
  return camera_.lens.principalY + camera_.lens.focal * (down / depth);
}

Slice::Seen Slice::seen(FieldPoint3 p) const {
  const FieldPoint3 d = p - camera_.position;
  return {dot(camera_.down, d), dot(camera_.forward, d), p.z};
}

std::optional<Span> Slice::stretch(Seen a, Seen b) const {
  if (a.depth < kNear && b.depth < kNear) return std::nullopt;
  if (a.depth < kNear) std::swap(a, b);
  if (b.depth < kNear) {
    const double t = (a.depth - kNear) / (a.depth - b.depth);
    b = {a.down + t * (b.down - a.down), kNear, a.height + t * (b.height - a.height)};
  }
  Span span;
  span.top = rowOf(a.down, a.depth);
  span.bottom = rowOf(b.down, b.depth);
  span.litTop = a.height;  // heights for now; the caller turns them into light
  span.litBottom = b.height;
  if (span.top > span.bottom) {
    std::swap(span.top, span.bottom);
    std::swap(span.litTop, span.litBottom);
  }
  span.depth = 0.5 * (a.depth + b.depth);
  return span;
}

// What it shows of a quad whose corners it parts.
std::optional<Span> Slice::met(const SeenQuad& seen) const {
  const Quad& shape = *seen.shape;
  std::array<double, 4> side;
  for (std::size_t i = 0; i < 4; ++i) side[i] = seen.right[i] - u_ * seen.depth[i];
  const auto crossed = [&side](std::size_t i) {
    return (side[i] < 0.0) != (side[(i + 1) & 3] < 0.0);
  };
  const auto crossing = [&](std::size_t i) {
    const std::size_t next = (i + 1) & 3;
    const double t = side[i] / (side[i] - side[next]);
    const auto between = [t](double a, double b) { return a + t * (b - a); };
    return Seen{between(seen.down[i], seen.down[next]), between(seen.depth[i], seen.depth[next]),
                between(shape.corner[i].z, shape.corner[next].z)};
  };
  std::size_t one = 0;
  while (!crossed(one)) ++one;
  std::size_t other = one + 1;
  while (!crossed(other)) ++other;
  std::optional<Span> span = stretch(crossing(one), crossing(other));
  if (!span) return span;
  const double low = std::min(shape.corner[0].z, shape.corner[2].z);
  const double height = std::fabs(shape.corner[2].z - shape.corner[0].z);
  const double perCm = height > kFlat ? shape.slope / height : 0.0;
  const double base = shape.lit - shape.slope / 2.0;
  span->litTop = base + perCm * (span->litTop - low);
  span->litBottom = base + perCm * (span->litBottom - low);
  span->depth -= shape.depthBias;
  span->colour = shape.colour;
  return span;
}

std::optional<Span> Slice::disc(const Disc& shape) const {
  const FieldPoint3 centre{shape.centre.x, shape.centre.y, 0.0};
  const double flat = std::sqrt(normal_.x * normal_.x + normal_.y * normal_.y);
  if (flat < kFlat) return std::nullopt;
  const double off = dot(normal_, centre - camera_.position) / flat;
  if (std::fabs(off) >= shape.radius) return std::nullopt;
  const double half = std::sqrt(shape.radius * shape.radius - off * off);
  const Point2<Field> n{normal_.x / flat, normal_.y / flat};
  const Point2<Field> middle = shape.centre - n * off;
  std::optional<Span> span = stretch(seen({middle.x - n.y * half, middle.y + n.x * half, 0.0}),
                                     seen({middle.x + n.y * half, middle.y - n.x * half, 0.0}));
  if (!span) return span;
  span->litTop = span->litBottom = 1.0;
  span->colour = shape.colour;
  span->darkens = shape.darkens;
  return span;
}

std::optional<Span> Slice::sphere(const Sphere& shape) const {
  const FieldPoint3 d = shape.centre - camera_.position;
  const double off = dot(normal_, d) * inverseNormal_;
  const double rho2 = shape.radius * shape.radius - off * off;
  const double depth = dot(camera_.forward, d);
  if (rho2 <= 0.0 || depth < kNear) return std::nullopt;
  // Along the ray of row 80 (a) and down (b), inside the plane; tangents by the sum of angles.
  const double stretchX = 1.0 / inverseNormal_;
  const double a = (u_ * dot(camera_.right, d) + depth) * inverseNormal_;
  const double b = dot(camera_.down, d);
  const double rho = std::sqrt(rho2);
  const double tangent2 = a * a + b * b - rho2;
  if (tangent2 <= 0.0) return std::nullopt;
  const double tangent = std::sqrt(tangent2);
  const double below = a * tangent - b * rho;
  const double above = a * tangent + b * rho;
  Span span;
  span.bottom = below > kFlat ? rowOf((b * tangent + a * rho) / below * stretchX, 1.0) : kFarRow;
  span.top = above > kFlat ? rowOf((b * tangent - a * rho) / above * stretchX, 1.0) : -kFarRow;
  span.depth = depth;
  span.colour = shape.colour;
  // Light from above: the top of the whole ball at +14 %, its foot at -16 %.
  const double share = rho / shape.radius;
  const double side = 1.0 - 0.05 * (1.0 - share);
  span.litTop = side + 0.14 * share;
  span.litBottom = side - 0.16 * share;
  return span;
}

std::optional<Span> Slice::limb(const Limb& shape) const {
  std::optional<Span> whole;
  for (const Sphere& part : shape.part) {
    const std::optional<Span> span = sphere(part);
    if (!span) continue;
    if (!whole) whole = span;
    whole->top = std::min(whole->top, span->top);
    whole->bottom = std::max(whole->bottom, span->bottom);
    whole->depth = std::min(whole->depth, span->depth);
  }
  if (!whole) return whole;
  whole->litTop = kLimbTop;
  whole->litBottom = kLimbFoot;
  return whole;
}

std::optional<FieldPoint3> Slice::frontAt(const Cylinder& shape, double height) const {
  const double flat = std::sqrt(normal_.x * normal_.x + normal_.y * normal_.y);
  if (flat < kFlat) return std::nullopt;
  const FieldPoint3 centre{shape.centre.x, shape.centre.y, height};
  const double off = dot(normal_, centre - camera_.position) / flat;
  const double half2 = shape.radius * shape.radius - off * off;
  if (half2 < -1e-6) return std::nullopt;
  const double half = half2 > 0.0 ? std::sqrt(half2) : 0.0;
  const Point2<Field> n{normal_.x / flat, normal_.y / flat};
  const Point2<Field> middle{centre.x - n.x * off, centre.y - n.y * off};
  const double nearer = camera_.forward.x * -n.y + camera_.forward.y * n.x > 0.0 ? -half : half;
  return FieldPoint3{middle.x - n.y * nearer, middle.y + n.x * nearer, height};
}

std::optional<Span> Slice::band(const Cylinder& shape, std::size_t index) const {
  const double flat = std::sqrt(normal_.x * normal_.x + normal_.y * normal_.y);
  if (flat < kFlat) return std::nullopt;
  // Distance of the axis from the plane, linear in height: only where it is within the radius.
  const FieldPoint3 foot{shape.centre.x, shape.centre.y, 0.0};
  const double atGround = dot(normal_, foot - camera_.position) / flat;
  const double perCm = normal_.z / flat;
  double low = shape.height[index];
  double high = shape.height[index + 1];
  if (std::fabs(perCm) > kFlat) {
    const double one = (-shape.radius - atGround) / perCm;
    const double two = (shape.radius - atGround) / perCm;
    low = std::max(low, std::min(one, two));
    high = std::min(high, std::max(one, two));
  }
  if (low >= high) return std::nullopt;
  const std::optional<FieldPoint3> a = frontAt(shape, low);
  const std::optional<FieldPoint3> b = frontAt(shape, high);
  if (!a || !b) return std::nullopt;
  std::optional<Span> span = stretch(seen(*a), seen(*b));
  if (!span) return span;
  const double lateral = (atGround + perCm * 0.5 * (low + high)) / shape.radius;
  const double lit = 1.04 - 0.12 * lateral * lateral + 0.05 * lateral;
  span->litTop = span->litBottom = lit;
  span->colour = shape.band[index];
  return span;
}

std::optional<Span> Slice::ground(Colour colour) const {
  const double down = camera_.down.z;
  if (down > -kFlat) return std::nullopt;  // on its side or upside down: no ground is drawn
  const double ahead = camera_.forward.z + u_ * camera_.right.z;
  Span span;
  span.top = rowOf(-ahead / down, 1.0);
  span.bottom = kFarRow;
  span.colour = colour;
  return span;
}

std::optional<Slice::GroundHit> Slice::groundAt(double row) const {
  const double v = (row - camera_.lens.principalY) / camera_.lens.focal;
  const double z = camera_.forward.z + u_ * camera_.right.z + v * camera_.down.z;
  if (z > -kFlat) return std::nullopt;
  const double t = -camera_.position.z / z;
  const double x = camera_.forward.x + u_ * camera_.right.x + v * camera_.down.x;
  const double y = camera_.forward.y + u_ * camera_.right.y + v * camera_.down.y;
  return GroundHit{camera_.position.x + t * x, camera_.position.y + t * y, t};
}

// In single precision, 1e-4 cm on the field: it is only asked which tuft of the carpet lies there.
Slice::GroundRows Slice::groundRows() const {
  constexpr float kFar = 1e6F;  // cm
  const auto at = [u = u_](double forward, double right) {
    return static_cast<float>(forward + u * right);
  };
  const FieldCamera& camera = camera_;
  const float ahead = at(camera.forward.x, camera.right.x);
  const float lateral = at(camera.forward.y, camera.right.y);
  const float up = at(camera.forward.z, camera.right.z);
  const FieldPoint3& down = camera.down;
  const auto downX = static_cast<float>(down.x), downY = static_cast<float>(down.y);
  const auto downZ = static_cast<float>(down.z), height = static_cast<float>(camera.position.z);
  const auto x = static_cast<float>(camera.position.x), y = static_cast<float>(camera.position.y);
  const auto principal = static_cast<float>(camera.lens.principalY);
  const auto perPixel = static_cast<float>(1.0 / camera.lens.focal);
  GroundRows rows;
  for (std::size_t row = 0; row < kImageHeight; ++row) {
    const float v = (kRowMiddles[row] - principal) * perPixel;
    const float fall = -(up + v * downZ);
    const float below = std::min(height / std::max(fall, 1e-9F), kFar);
    const float depth = fall > 0.0F ? below : 0.0F;
    rows.depth[row] = depth;
    rows.x[row] = x + depth * (ahead + v * downX);
    rows.y[row] = y + depth * (lateral + v * downY);
  }
  return rows;
}

}  // namespace kelpie::sim

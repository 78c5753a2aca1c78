// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/Camera.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr std::size_t kRows = kImageHeight;
constexpr double kRowsDouble = kImageHeight;
constexpr std::size_t kTexels = 128;  // a power of two
constexpr std::uint64_t kTextureSeed = 71;
constexpr double kFineTexel = 0.8;     // cm; tufts of the carpet
constexpr double kCoarseTexel = 11.0;  // cm; wear and uneven light
constexpr double kShadow = 0.35;       // share of the light that a ball takes from below it

std::vector<float> carpetTexture() {
  Random random(kTextureSeed);
  std::vector<float> table(kTexels * kTexels);
  for (float& value : table) value = static_cast<float>(random.uniform(-1.0, 1.0));
  return table;
}

std::size_t texel(double x, double y, double size) {
  const auto i = static_cast<std::int64_t>(std::floor(x / size));
  const auto j = static_cast<std::int64_t>(std::floor(y / size));
  const auto mask = static_cast<std::int64_t>(kTexels - 1);
  return static_cast<std::size_t>((j & mask) * static_cast<std::int64_t>(kTexels) + (i & mask));
}

void blend(float& under, float over, float cover) { under += cover * (over - under); }

FieldPoint3 middleOf(const Quad& quad) {
  return {0.5 * (quad.corner[0].x + quad.corner[2].x), 0.5 * (quad.corner[0].y + quad.corner[2].y),
          0.5 * (quad.corner[0].z + quad.corner[2].z)};
}

// A colour as the second light changes it; a dark thing takes on less of its colour.
Colour lit(const Scene& scene, Colour colour, Point2<Field> place) {
  const double level = lightAt(scene, place);
  const double near = 0.5 * (1.0 + level);
  const double tint = near * scene.light.warmth * static_cast<double>(colour.y / colours::kWhite.y);
  return {colour.y * static_cast<float>(1.0 + level * scene.light.strength),
          colour.cr + static_cast<float>(tint), colour.cb - static_cast<float>(tint)};
}

double radiusOf(const Quad& quad) {
  return 0.5 *
         maths::hypot(quad.corner[2].x - quad.corner[0].x, quad.corner[2].y - quad.corner[0].y);
}

// Whether a sphere touches the cone round the image's corners, 34.3 deg off the axis. A head of 400
// deg/s turns 7 deg between the columns that are asked.
bool nearView(const FieldCamera& camera, const Sphere& sphere) {
  constexpr double kTangent = 0.87;  // of 34.3 + 7 deg
  constexpr double kStretch = 1.33;  // 1 / cosine of that
  const FieldPoint3 d = sphere.centre - camera.position;
  const double depth = camera.forward.x * d.x + camera.forward.y * d.y + camera.forward.z * d.z;
  const double aside2 = d.x * d.x + d.y * d.y + d.z * d.z - depth * depth;
  const double reach = kTangent * depth + kStretch * sphere.radius;
  return reach > 0.0 && aside2 < reach * reach;
}

}  // namespace

CameraParams idealCamera() {
  CameraParams params;
  params.artefacts.ring = params.artefacts.noise = false;
  params.artefacts.blur = params.artefacts.shift = false;
  params.texture = params.light = false;
  params.slices = 8;
  return params;
}

Camera::Camera(const CameraParams& params, const RobotCamera& robot)
    : params_(params), artefacts_(params.artefacts, robot), texture_(carpetTexture()) {}

// A robot seldom sees itself: asked of three columns, so that it costs an image next to nothing.
void Camera::selectOwn(const Scene& scene, const ColumnCameras& cameras) {
  own_.clear();
  for (const Limb& limb : scene.own) {
    const auto sees = [&limb](const FieldCamera& camera) {
      return std::any_of(limb.part.begin(), limb.part.end(),
                         [&camera](const Sphere& part) { return nearView(camera, part); });
    };
    if (sees(cameras.front()) || sees(cameras[kImageWidth / 2]) || sees(cameras.back()))
      own_.push_back(&limb);
  }
}

void Camera::selectShapes(const Scene& scene, const FieldCamera& camera, double middle) {
  const Slice slice(camera, middle);
  // Half a column to each side, measured across the plane, with room for wide angles.
  const double margin = 1.05 * (0.5 / camera.lens.focal);
  solids_.clear();
  beacons_.clear();
  lines_.clear();
  for (const std::vector<Solid>* group : {&scene.fixtures, &scene.robots}) {
    for (const Solid& solid : *group) {
      if (slice.mayMeet(solid.centre, solid.radius, margin)) solids_.push_back(&solid);
    }
  }
  for (const Cylinder& beacon : scene.beacons) {
    const double half = 0.5 * beacon.height[4];
    const FieldPoint3 centre{beacon.centre.x, beacon.centre.y, half};
    if (slice.mayMeet(centre, half + beacon.radius, margin)) beacons_.push_back(&beacon);
  }
  for (const Quad& line : scene.lines) {
    if (slice.mayMeet(middleOf(line), radiusOf(line), margin)) lines_.push_back(&line);
  }
}

void Camera::paintGround(const Scene& scene, const Slice& slice) {
  if (const auto floor = slice.ground(scene.floor)) paint(*floor);
  if (auto carpet = slice.quad(groundQuad(scene.carpet[0], scene.carpet[1], scene.green))) {
    carpet->carpet = 1.0F;
    paint(*carpet);
  }
  for (const Disc& disc : scene.circle) {
    auto span = slice.disc(disc);
    if (!span) continue;
    span->carpet = disc.colour.y == scene.green.y ? 1.0F : 0.3F;
    paint(*span);
  }
  for (const Quad* line : lines_) {
    auto span = slice.quad(*line);
    if (!span) continue;
    span->carpet = 0.3F;
    paint(*span);
  }
  for (const Disc& marker : scene.markers) {
    if (const auto span = slice.disc(marker)) paint(*span);
  }
  for (const Sphere& ball : scene.balls) {
    const Disc shadow{{ball.centre.x, ball.centre.y}, 0.75 * ball.radius, {}, kShadow};
    if (const auto span = slice.disc(shadow)) paint(*span);
  }
}

void Camera::collectSolids(const Scene& scene, const Slice& slice) {
  spans_.clear();
  const bool secondLight = params_.light && scene.light.on();
  // A span of a shape between these two points.
  const auto keep = [&](const std::optional<Span>& span, const FieldPoint3& a,
                        const FieldPoint3& b) {
    if (!span || span->bottom <= 0.0 || span->top >= kRowsDouble) return;
    spans_.push_back(*span);
    if (!secondLight) return;
    Colour& colour = spans_.back().colour;
    colour = lit(scene, colour, {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
  };
  for (const Solid* solid : solids_) {
    for (const Quad& quad : solid->quads) keep(slice.quad(quad), quad.corner[0], quad.corner[2]);
  }
  for (const Cylinder* beacon : beacons_) {
    const FieldPoint3 foot{beacon->centre.x, beacon->centre.y, 0.0};
    for (std::size_t i = 0; i < beacon->band.size(); ++i) keep(slice.band(*beacon, i), foot, foot);
  }
  for (const Sphere& ball : scene.balls) keep(slice.sphere(ball), ball.centre, ball.centre);
  for (const Limb* limb : own_) keep(slice.limb(*limb), limb->part[0].centre, limb->part[0].centre);
}

void Camera::renderSlice(const Scene& scene, const Slice& slice) {
  slice_.y.fill(scene.ceiling.y);
  slice_.cr.fill(scene.ceiling.cr);
  slice_.cb.fill(scene.ceiling.cb);
  slice_.carpet.fill(0.0F);
  paintGround(scene, slice);
  collectSolids(scene, slice);
  std::stable_sort(spans_.begin(), spans_.end(),
                   [](const Span& a, const Span& b) { return a.depth > b.depth; });
  for (const Span& span : spans_) paint(span);
}

void Camera::paint(const Span& span) {
  const double top = std::max(span.top, 0.0);
  const double bottom = std::min(span.bottom, kRowsDouble);
  if (top >= bottom) return;
  const auto first = static_cast<std::size_t>(top);
  const auto last = std::min(static_cast<std::size_t>(std::ceil(bottom)), kRows);
  const double length = span.bottom - span.top;
  const double perRow = length > 0.0 ? (span.litBottom - span.litTop) / length : 0.0;
  for (std::size_t row = first; row < last; ++row) {
    const auto edge = static_cast<double>(row);
    const double covered = std::min(bottom, edge + 1.0) - std::max(top, edge);
    const auto cover = static_cast<float>(covered);
    if (span.darkens > 0.0) {
      slice_.y[row] *= 1.0F - cover * static_cast<float>(span.darkens);
      continue;
    }
    const double lit = span.litTop + perRow * (edge + 0.5 - span.top);
    blend(slice_.y[row], static_cast<float>(lit) * span.colour.y, cover);
    blend(slice_.cr[row], span.colour.cr, cover);
    blend(slice_.cb[row], span.colour.cb, cover);
    blend(slice_.carpet[row], span.carpet, cover);
  }
}

// What lies on the ground, row by row: painted lines have the carpet's share of the texture, 0.3.
void Camera::lightGround(const Scene& scene, const FieldCamera& camera, double middle) {
  constexpr float kPaint = 0.3F;
  const Slice slice(camera, middle);
  for (std::size_t row = 0; row < kRows; ++row) {
    if (column_.carpet[row] <= 0.0F) continue;
    const auto hit = slice.groundAt(static_cast<double>(row) + 0.5);
    if (!hit) continue;
    const float ground = std::min(1.0F, column_.carpet[row] / kPaint);
    const float green = std::max(0.0F, (column_.carpet[row] - kPaint) / (1.0F - kPaint));
    const Colour is{column_.y[row], column_.cr[row], column_.cb[row]};
    const Colour other = lit(scene, is, {hit->x, hit->y});
    const bool odd = std::fmod(std::fabs(hit->x), 2.0 * scene.stripes.width) > scene.stripes.width;
    const auto pile = static_cast<float>(odd ? scene.stripes.contrast : -scene.stripes.contrast);
    blend(column_.y[row], other.y, ground);
    blend(column_.cr[row], other.cr, ground);
    blend(column_.cb[row], other.cb, ground);
    column_.y[row] *= 1.0F + green * pile;
  }
}

void Camera::addSlice(float share) {
  for (std::size_t row = 0; row < kRows; ++row) {
    column_.y[row] += share * slice_.y[row];
    column_.cr[row] += share * slice_.cr[row];
    column_.cb[row] += share * slice_.cb[row];
    column_.carpet[row] += share * slice_.carpet[row];
  }
}

// Tufts fade where a pixel covers many of them; the coarse pattern stays.
void Camera::addTexture(const FieldCamera& camera, double middle) {
  const Slice slice(camera, middle);
  for (std::size_t row = 0; row < kRows; ++row) {
    if (column_.carpet[row] <= 0.0F) continue;
    const auto hit = slice.groundAt(static_cast<double>(row) + 0.5);
    if (!hit) continue;
    const auto fade = static_cast<float>(std::min(1.0, 60.0 / hit->depth));
    const float fine = texture_[texel(hit->x, hit->y, kFineTexel)];
    const float coarse = texture_[texel(hit->x + 40.0, hit->y + 90.0, kCoarseTexel)];
    const auto amount = static_cast<float>(params_.textureAmount) * column_.carpet[row];
    column_.y[row] += amount * (0.7F * fade * fine + 0.3F * std::max(fade, 0.3F) * coarse);
    column_.cb[row] += 0.15F * amount * fade * fine;
  }
}

void Camera::keepColumn(std::size_t x) {
  std::copy(column_.y.begin(), column_.y.end(),
            raw_.plane[0].begin() + static_cast<int>(x * kRows));
  std::copy(column_.cr.begin(), column_.cr.end(),
            raw_.plane[1].begin() + static_cast<int>(x * kRows));
  std::copy(column_.cb.begin(), column_.cb.end(),
            raw_.plane[2].begin() + static_cast<int>(x * kRows));
}

void Camera::render(const Scene& scene, const ColumnCameras& cameras, Random& random,
                    Image& image) {
  const double step = 1.0 / params_.slices;
  selectOwn(scene, cameras);
  for (std::size_t x = 0; x < kImageWidth; ++x) {
    const auto left = static_cast<double>(x);
    selectShapes(scene, cameras[x], left + 0.5);
    column_ = Column{};
    for (int i = 0; i < params_.slices; ++i) {
      renderSlice(scene, Slice(cameras[x], left + (i + 0.5) * step));
      addSlice(static_cast<float>(step));
    }
    if (params_.light && (scene.light.on() || scene.stripes.on()))
      lightGround(scene, cameras[x], left + 0.5);
    if (params_.texture) addTexture(cameras[x], left + 0.5);
    keepColumn(x);
  }
  artefacts_.apply(raw_, random, image);
}

}  // namespace kelpie::sim

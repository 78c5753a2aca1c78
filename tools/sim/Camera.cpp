// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/Camera.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr std::size_t kRows = kImageHeight;
constexpr double kRowsDouble = kImageHeight;
constexpr double kFineTexels = 1.0 / 0.8;     // per cm; tufts of the carpet
constexpr double kCoarseTexels = 1.0 / 11.0;  // per cm; wear and uneven light
constexpr double kShadow = 0.35;              // share of the light that a ball takes from below it

// std::floor is a call where the processor is not known to have it.
std::int64_t floorOf(double v) {
  const auto whole = static_cast<std::int64_t>(v);
  return whole - (v < static_cast<double>(whole) ? 1 : 0);
}

std::size_t texel(double x, double y, double perCm) {
  const std::int64_t i = floorOf(x * perCm);
  const std::int64_t j = floorOf(y * perCm);
  const auto mask = static_cast<std::int64_t>(kTexels - 1);
  return static_cast<std::size_t>((j & mask) * static_cast<std::int64_t>(kTexels) + (i & mask));
}

void blend(float& under, float over, float cover) { under += cover * (over - under); }

// A colour as the second light changes it; a dark thing takes on less of its colour.
Colour lit(const Scene& scene, Colour colour, Point2<Field> place) {
  const double level = lightAt(scene, place);
  const double near = 0.5 * (1.0 + level);
  const double tint = near * scene.light.warmth * static_cast<double>(colour.y / colours::kWhite.y);
  return {colour.y * static_cast<float>(1.0 + level * scene.light.strength),
          colour.cr + static_cast<float>(tint), colour.cb - static_cast<float>(tint)};
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

// The cameras of three columns, which stand for those between them.
using Asked = std::array<const FieldCamera*, 3>;

struct Columns {
  std::size_t first;
  std::size_t last;  // below `first`: none
};

// The columns that may show a quad: those of its corners as the three cameras see them, and some
// beside them. A head that turns round between two columns is 0.9 deg off the even way, 3 px.
Columns columnsOf(const Quad& quad, const Asked& asked) {
  constexpr double kBeside = 8.0;  // px
  constexpr double kAhead = 5.0;   // cm
  constexpr auto kLast = static_cast<double>(kImageWidth - 1);
  double low = kLast + kBeside;
  double high = -kBeside;
  bool away = true;
  bool behind = true;
  bool ahead = true;
  for (const FieldCamera* camera : asked) {
    const SeenQuad seen = seenBy(*camera, quad);
    away = away && seen.turnedAway;
    for (std::size_t i = 0; i < 4; ++i) {
      behind = behind && seen.depth[i] < -kAhead;
      ahead = ahead && seen.depth[i] > kAhead;
      const double x = camera->lens.principalX + camera->lens.focal * seen.right[i] / seen.depth[i];
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  if (away || behind) return {1, 0};
  if (!ahead) return {0, kImageWidth - 1};
  if (high + kBeside < 0.0 || low - kBeside > kLast) return {1, 0};
  return {static_cast<std::size_t>(std::max(low - kBeside, 0.0)),
          static_cast<std::size_t>(std::min(high + kBeside, kLast))};
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

Camera::Camera(const CameraParams& params, const RobotCamera& robot, const SharedTables& tables)
    : params_(params), artefacts_(params.artefacts, robot, tables), tables_(tables) {}

void Camera::selectQuads(const Scene& scene, const ColumnCameras& cameras) {
  const Asked asked{&cameras.front(), &cameras[kImageWidth / 2], &cameras.back()};
  const auto keep = [&asked](const Quad& quad, std::vector<InView>& kept) {
    const auto [first, last] = columnsOf(quad, asked);
    if (first <= last) kept.push_back({&quad, first, last});
  };
  view_.clear();
  lineView_.clear();
  for (const Quad& line : scene.lines) keep(line, lineView_);
  for (const std::vector<Solid>* group : {&scene.fixtures, &scene.robots}) {
    for (const Solid& solid : *group) {
      const Sphere around{solid.centre, solid.radius, {}};
      if (!std::any_of(asked.begin(), asked.end(),
                       [&around](const FieldCamera* camera) { return nearView(*camera, around); }))
        continue;
      for (const Quad& quad : solid.quads) keep(quad, view_);
    }
  }
}

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
  quads_.clear();
  beacons_.clear();
  lines_.clear();
  const auto keep = [&](const SeenQuad& seen, std::vector<SeenQuad>& kept) {
    if (slice.mayMeet(seen, margin)) kept.push_back(seen);
  };
  const auto x = static_cast<std::size_t>(middle);
  for (const InView& quad : view_)
    if (x >= quad.first && x <= quad.last) keep(seenBy(camera, *quad.shape), quads_);
  for (const InView& line : lineView_)
    if (x >= line.first && x <= line.last) keep(seenBy(camera, *line.shape), lines_);
  carpet_ = seenBy(camera, ground_);
  for (const Cylinder& beacon : scene.beacons) {
    const double half = 0.5 * beacon.height[4];
    const FieldPoint3 centre{beacon.centre.x, beacon.centre.y, half};
    if (slice.mayMeet(centre, half + beacon.radius, margin)) beacons_.push_back(&beacon);
  }
}

void Camera::paintGround(const Scene& scene, const Slice& slice) {
  auto carpet = slice.quad(carpet_);
  if (auto floor = slice.ground(scene.floor)) {
    if (carpet && carpet->bottom >= kRowsDouble) floor->bottom = std::ceil(carpet->top);
    paint(*floor);
  }
  if (carpet) {
    carpet->carpet = 1.0F;
    paint(*carpet);
  }
  for (const Disc& disc : scene.circle) {
    auto span = slice.disc(disc);
    if (!span) continue;
    span->carpet = disc.colour.y == scene.green.y ? 1.0F : 0.3F;
    paint(*span);
  }
  for (const SeenQuad& line : lines_) {
    auto span = slice.quad(line);
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
  for (const SeenQuad& quad : quads_)
    keep(slice.quad(quad), quad.shape->corner[0], quad.shape->corner[2]);
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
  order_.clear();
  for (const Span& span : spans_) order_.push_back(&span);
  std::sort(order_.begin(), order_.end(), [](const Span* a, const Span* b) {
    return a->depth != b->depth ? a->depth > b->depth : a < b;
  });
  for (const Span* span : order_) paint(*span);
}

void Camera::paint(const Span& span) {
  const double top = std::max(span.top, 0.0);
  const double bottom = std::min(span.bottom, kRowsDouble);
  if (top >= bottom) return;
  const auto first = static_cast<std::size_t>(top);
  const auto last = std::min(static_cast<std::size_t>(std::ceil(bottom)), kRows);
  std::array<float, kRows> cover;
  std::fill(cover.begin() + first, cover.begin() + last, 1.0F);
  for (const std::size_t row : {first, last - 1}) {
    const auto edge = static_cast<double>(row);
    cover[row] = static_cast<float>(std::min(bottom, edge + 1.0) - std::max(top, edge));
  }
  if (span.darkens > 0.0) {
    const auto darkens = static_cast<float>(span.darkens);
    for (std::size_t row = first; row < last; ++row) slice_.y[row] *= 1.0F - cover[row] * darkens;
    return;
  }
  const double length = span.bottom - span.top;
  const double perRow = length > 0.0 ? (span.litBottom - span.litTop) / length : 0.0;
  // Values of their own, which the rows that are written cannot change.
  const double litTop = span.litTop;
  const double spanTop = span.top;
  const Colour colour = span.colour;
  const float carpet = span.carpet;
  if (perRow == 0.0) {
    const float y = static_cast<float>(litTop) * colour.y;
    for (std::size_t row = first; row < last; ++row) blend(slice_.y[row], y, cover[row]);
  } else {
    for (std::size_t row = first; row < last; ++row) {
      const double lit = litTop + perRow * (kRowMiddles[row] - spanTop);
      blend(slice_.y[row], static_cast<float>(lit) * colour.y, cover[row]);
    }
  }
  for (std::size_t row = first; row < last; ++row) {
    blend(slice_.cr[row], colour.cr, cover[row]);
    blend(slice_.cb[row], colour.cb, cover[row]);
    blend(slice_.carpet[row], carpet, cover[row]);
  }
}

// What lies on the ground, row by row: painted lines have the carpet's share of the texture, 0.3.
void Camera::lightGround(const Scene& scene, const Slice& middle) {
  constexpr float kPaint = 0.3F;
  for (std::size_t row = 0; row < kRows; ++row) {
    if (column_.carpet[row] <= 0.0F) continue;
    const auto hit = middle.groundAt(kRowMiddles[row]);
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
void Camera::addTexture(const Slice& middle) {
  const Slice::GroundRows ground = middle.groundRows();
  const std::vector<float>& texture = tables_->texture;
  const auto most = static_cast<float>(params_.textureAmount);
  for (std::size_t row = 0; row < kRows; ++row) {
    if (column_.carpet[row] <= 0.0F || ground.depth[row] <= 0.0) continue;
    const double x = ground.x[row];
    const double y = ground.y[row];
    const auto fade = static_cast<float>(std::min(1.0, 60.0 / ground.depth[row]));
    const float fine = texture[texel(x, y, kFineTexels)];
    const float coarse = texture[texel(x + 40.0, y + 90.0, kCoarseTexels)];
    const float amount = most * column_.carpet[row];
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
  selectQuads(scene, cameras);
  ground_ = groundQuad(scene.carpet[0], scene.carpet[1], scene.green);
  for (std::size_t x = 0; x < kImageWidth; ++x) {
    const auto left = static_cast<double>(x);
    selectShapes(scene, cameras[x], left + 0.5);
    column_ = Column{};
    for (int i = 0; i < params_.slices; ++i) {
      renderSlice(scene, Slice(cameras[x], left + (i + 0.5) * step));
      addSlice(static_cast<float>(step));
    }
    const Slice middle(cameras[x], left + 0.5);
    if (params_.light && (scene.light.on() || scene.stripes.on())) lightGround(scene, middle);
    if (params_.texture) addTexture(middle);
    keepColumn(x);
  }
  artefacts_.apply(raw_, random, image);
}

}  // namespace kelpie::sim

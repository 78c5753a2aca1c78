// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/camera/Camera.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr std::size_t kRows = kImageHeight;
constexpr double kRowsDouble = kImageHeight;
constexpr std::size_t kBlock = 16;  // columns
// Columns that see with one camera, the one between them: of a head of 400 deg/s they are 0.1 px
// off so, and the border to the two before, which was seen with their camera, 0.2.
constexpr std::size_t kTogether = 2;
static_assert(kBlock % kTogether == 0 && kImageWidth % kTogether == 0);
constexpr float kFineTexels = 1.0F / 0.8F;     // per cm; tufts of the carpet
constexpr float kCoarseTexels = 1.0F / 11.0F;  // per cm; wear and uneven light
constexpr float kPaint = 0.3F;                 // a painted line's share of the carpet's texture
constexpr double kShadow = 0.35;               // share of the light that a ball takes from below it

// std::floor is a call where the processor is not known to have it.
std::int32_t floorOf(float v) {
  const auto whole = static_cast<std::int32_t>(v);
  return whole - (v < static_cast<float>(whole) ? 1 : 0);
}

std::int32_t texel(float x, float y, float perCm) {
  constexpr auto kMask = static_cast<std::int32_t>(kTexels - 1);
  constexpr auto kRow = static_cast<std::int32_t>(kTexels);
  return (floorOf(y * perCm) & kMask) * kRow + (floorOf(x * perCm) & kMask);
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
  const double lateral2 = d.x * d.x + d.y * d.y + d.z * d.z - depth * depth;
  const double reach = kTangent * depth + kStretch * sphere.radius;
  return reach > 0.0 && lateral2 < reach * reach;
}

// The cameras of three columns, which stand for those between them.
using Asked = std::array<const FieldCamera*, 3>;

struct Columns {
  std::size_t first;
  std::size_t last;  // below `first`: none
};

// How far, px, a corner may be off the columns where three cameras see it. A head that turns round
// between two columns is 0.9 deg off the even way, 3 px; one that hardly turns cannot be.
double unevenness(const ColumnCameras& cameras) {
  constexpr std::size_t kApart = 16;
  constexpr double kMax = 8.0;
  double turned = 0.0;
  for (std::size_t x = kApart; x < kImageWidth; x += kApart) {
    const FieldPoint3 d = cameras[x].forward - cameras[0].forward;
    turned = std::max({turned, std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  }
  return std::min(kMax, 1.5 + cameras[0].lens.focal * turned);
}

// The columns that may show a quad: those of its corners as the three cameras see them, and some
// beside them.
Columns columnsOf(const Quad& quad, const Corners& corners, const Asked& asked, double beside) {
  constexpr double kAhead = 5.0;  // cm
  constexpr auto kLast = static_cast<double>(kImageWidth - 1);
  double low = kLast + beside;
  double high = -beside;
  bool away = true;
  bool behind = true;
  bool ahead = true;
  SeenQuad seen;
  for (const FieldCamera* camera : asked) {
    see(*camera, quad, corners, seen);
    away = away && seen.turnedAway;
    ahead = ahead && !seen.turnedAway;  // edge on: not known where
    if (seen.turnedAway) continue;
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
  if (high + beside < 0.0 || low - beside > kLast) return {1, 0};
  return {static_cast<std::size_t>(std::max(low - beside, 0.0)),
          static_cast<std::size_t>(std::min(high + beside, kLast))};
}

// By insertion, in place: a cut shows about ten things.
void sortFarToNear(std::vector<Span>::iterator first, std::vector<Span>::iterator last) {
  const auto farther = [](const Span& a, const Span& b) { return a.depth > b.depth; };
  for (auto span = first; span != last; ++span)
    std::rotate(std::upper_bound(first, span, *span, farther), span, span + 1);
}

struct Rows {
  std::size_t first;
  std::size_t last;  // the first below them
};

// Rows of the ceiling that the first thing on the ground is written over; not those that it is
// blended with.
Rows hiddenBy(const std::vector<Span>& shown) {
  if (shown.empty() || shown.front().darkens > 0.0) return {0, 0};
  const auto top = static_cast<std::size_t>(std::max(shown.front().top, 0.0));
  const double bottom = std::min(shown.front().bottom, kRowsDouble);
  return {top + 1, std::max(top + 2, static_cast<std::size_t>(std::ceil(bottom))) - 1};
}

void fillAround(const Rows& hidden, float value, RawColumn::Channel& channel) {
  std::fill(channel.begin(), channel.begin() + hidden.first, value);
  std::fill(channel.begin() + hidden.last, channel.end(), value);
}

// Whether two cuts show the same things, none of whose ends is more than `rows` off.
bool alike(const std::vector<Span>& a, const std::vector<Span>& b, double rows) {
  constexpr float kLevels = 2.0F;  // of a second light, from column to column
  const auto apart = [](double p, double q) {
    return std::fabs(std::clamp(p, 0.0, kRowsDouble) - std::clamp(q, 0.0, kRowsDouble));
  };
  const auto same = [&](const Span& p, const Span& q) {
    return p.carpet == q.carpet && p.darkens == q.darkens &&
           std::fabs(p.colour.y - q.colour.y) <= kLevels &&
           std::fabs(p.colour.cr - q.colour.cr) <= kLevels &&
           std::fabs(p.colour.cb - q.colour.cb) <= kLevels && apart(p.top, q.top) < rows &&
           apart(p.bottom, q.bottom) < rows;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace

bool mayShow(const ColumnCameras& cameras, const Sphere& sphere) {
  return nearView(cameras.front(), sphere) || nearView(cameras[kImageWidth / 2], sphere) ||
         nearView(cameras.back(), sphere);
}

CameraParams idealCamera() {
  CameraParams params;
  params.artefacts.ring = params.artefacts.noise = false;
  params.artefacts.blur = params.artefacts.shift = false;
  params.texture = params.light = false;
  params.splits = 3;
  params.maxSlope = 0.0;
  return params;
}

Camera::Camera(const CameraParams& params, const RobotCamera& robot, const SharedTables& tables)
    : params_(params),
      artefacts_(params.artefacts, robot, tables),
      tables_(tables),
      middles_(static_cast<std::size_t>(params.splits)) {}

void Camera::selectQuads(const Scene& scene, const ColumnCameras& cameras) {
  const Asked asked{&cameras.front(), &cameras[kImageWidth / 2], &cameras.back()};
  const double beside = unevenness(cameras);
  const auto keep = [&](const Quad& quad, std::vector<InView>& kept) {
    const Corners corners = cornersOf(quad);
    const auto [first, last] = columnsOf(quad, corners, asked, beside);
    if (first <= last) kept.push_back({&quad, corners, first, last});
  };
  view_.clear();
  lineView_.clear();
  for (const Quad& line : scene.lines) keep(line, lineView_);
  for (const std::vector<Solid>* group : {&scene.fixtures, &scene.robots}) {
    for (const Solid& solid : *group) {
      if (!mayShow(cameras, {solid.centre, solid.radius, {}})) continue;
      for (const Quad& quad : solid.quads) keep(quad, view_);
    }
  }
}

// A robot seldom sees itself: asked of three columns, so that it costs an image next to nothing.
void Camera::selectOwn(const Scene& scene, const ColumnCameras& cameras) {
  own_.clear();
  for (const Limb& limb : scene.own) {
    const auto shows = [&](const Sphere& part) { return mayShow(cameras, part); };
    if (std::any_of(limb.part.begin(), limb.part.end(), shows)) own_.push_back(&limb);
  }
}

// Those that one of the block's columns may show, so that each column asks few.
void Camera::selectBlock(const std::vector<InView>& all, std::size_t first,
                         std::vector<const InView*>& kept) {
  kept.clear();
  for (const InView& quad : all)
    if (quad.first < first + kBlock && quad.last >= first) kept.push_back(&quad);
}

void Camera::see(const FieldCamera& camera, std::size_t column,
                 const std::vector<const InView*>& all, Seen& seen) {
  if (seen.place.size() < all.size()) seen.place.resize(all.size());
  seen.count = 0;
  for (const InView* quad : all) {
    if (!quad->shows(column, kTogether)) continue;
    sim::see(camera, *quad->shape, quad->corners, seen.place[seen.count]);
    if (!seen.place[seen.count].turnedAway) ++seen.count;
  }
}

// Of the columns from `x` on that see together.
void Camera::selectShapes(const Scene& scene, const FieldCamera& camera, std::size_t x) {
  constexpr double kHalf = 0.5 * kTogether;
  const Slice slice(camera, static_cast<double>(x) + kHalf);
  // So far to each side, measured across the plane, with room for wide angles.
  const double margin = 1.05 * (kHalf / camera.lens.focal);
  beacons_.clear();
  if (x % kBlock == 0) {
    selectBlock(view_, x, blockView_);
    selectBlock(lineView_, x, blockLines_);
  }
  see(camera, x, blockView_, quads_);
  see(camera, x, blockLines_, lines_);
  carpet_ = seenBy(camera, ground_);
  for (const Cylinder& beacon : scene.beacons) {
    const double half = 0.5 * beacon.height[4];
    const FieldPoint3 centre{beacon.centre.x, beacon.centre.y, half};
    if (slice.mayMeet(centre, half + beacon.radius, margin)) beacons_.push_back(&beacon);
  }
}

void Camera::collectGround(const Scene& scene, const Slice& slice, std::vector<Span>& shown) {
  const auto keep = [&shown](const std::optional<Span>& span, float carpet) {
    if (!span || span->bottom <= 0.0 || span->top >= kRowsDouble) return;
    shown.push_back(*span);
    shown.back().carpet = carpet;
  };
  const auto carpet = slice.quad(carpet_);
  auto floor = slice.ground(scene.floor);
  if (floor && carpet && carpet->bottom >= kRowsDouble) floor->bottom = std::ceil(carpet->top);
  keep(floor, 0.0F);
  keep(carpet, 1.0F);
  for (const Disc& disc : scene.circle)
    keep(slice.disc(disc), disc.colour.y == scene.green.y ? 1.0F : kPaint);
  for (const SeenQuad& line : lines_) keep(slice.quad(line), kPaint);
  for (const Disc& marker : scene.markers) keep(slice.disc(marker), 0.0F);
  for (const Sphere& ball : scene.balls) {
    const Disc shadow{{ball.centre.x, ball.centre.y}, 0.75 * ball.radius, {}, kShadow};
    keep(slice.disc(shadow), 0.0F);
  }
}

void Camera::collectSolids(const Scene& scene, const Slice& slice, std::vector<Span>& shown) {
  const bool secondLight = params_.light && scene.light.on();
  // A span of a shape between these two points.
  const auto keep = [&](const std::optional<Span>& span, const FieldPoint3& a,
                        const FieldPoint3& b) {
    if (!span || span->bottom <= 0.0 || span->top >= kRowsDouble) return;
    shown.push_back(*span);
    if (!secondLight) return;
    Colour& colour = shown.back().colour;
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

// What a cut shows, in the order of painting: the ground as it lies, solids from far to near.
void Camera::look(const Scene& scene, const Slice& slice, Cut& cut) {
  cut.shown.clear();
  cut.isPainted = false;
  collectGround(scene, slice, cut.shown);
  const auto ground = static_cast<std::ptrdiff_t>(cut.shown.size());
  collectSolids(scene, slice, cut.shown);
  sortFarToNear(cut.shown.begin() + ground, cut.shown.end());
}

void Camera::paint(const Scene& scene, Cut& cut) {
  if (cut.isPainted) return;
  cut.isPainted = true;
  const Rows hidden = hiddenBy(cut.shown);
  fillAround(hidden, scene.ceiling.y, cut.painted.y);
  fillAround(hidden, scene.ceiling.cr, cut.painted.cr);
  fillAround(hidden, scene.ceiling.cb, cut.painted.cb);
  fillAround(hidden, 0.0F, cut.painted.carpet);
  for (const Span& span : cut.shown) paint(span, cut.painted);
}

// Rows that a span covers wholly are written; only its two ends blend with what is below.
void Camera::paint(const Span& span, Column& column) {
  const double top = std::max(span.top, 0.0);
  const double bottom = std::min(span.bottom, kRowsDouble);
  if (top >= bottom) return;
  const auto first = static_cast<std::size_t>(top);
  const auto last = std::min(static_cast<std::size_t>(std::ceil(bottom)), kRows);
  const auto coverOf = [&](std::size_t row) {
    const auto edge = static_cast<double>(row);
    return static_cast<float>(std::min(bottom, edge + 1.0) - std::max(top, edge));
  };
  if (span.darkens > 0.0) {
    const auto darkens = static_cast<float>(span.darkens);
    for (std::size_t row = first; row < last; ++row) column.y[row] *= 1.0F - coverOf(row) * darkens;
    return;
  }
  const double length = span.bottom - span.top;
  const double perRow = length > 0.0 ? (span.litBottom - span.litTop) / length : 0.0;
  const auto blendRow = [&](std::size_t row) {
    const float cover = coverOf(row);
    const double lit = span.litTop + perRow * (static_cast<double>(row) + 0.5 - span.top);
    blend(column.y[row], static_cast<float>(lit) * span.colour.y, cover);
    blend(column.cr[row], span.colour.cr, cover);
    blend(column.cb[row], span.colour.cb, cover);
    blend(column.carpet[row], span.carpet, cover);
  };
  blendRow(first);
  if (last == first + 1) return;
  blendRow(last - 1);
  const float lit = static_cast<float>(span.litTop - perRow * span.top) * span.colour.y;
  const float litPerRow = static_cast<float>(perRow) * span.colour.y;
  for (std::size_t row = first + 1; row + 1 < last; ++row)
    column.y[row] = lit + litPerRow * kRowMiddles[row];
  std::fill(column.cr.begin() + first + 1, column.cr.begin() + last - 1, span.colour.cr);
  std::fill(column.cb.begin() + first + 1, column.cb.begin() + last - 1, span.colour.cb);
  std::fill(column.carpet.begin() + first + 1, column.carpet.begin() + last - 1, span.carpet);
}

// What lies on the ground, row by row.
void Camera::lightGround(const Scene& scene, const Slice& middle) {
  for (std::size_t row = 0; row < kRows; ++row) {
    if (column_.carpet[row] <= 0.0F) continue;
    const auto hit = middle.groundAt(static_cast<double>(row) + 0.5);
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

void Camera::average(const Column& left, const Column& right) {
  for (std::size_t row = 0; row < kRows; ++row) {
    column_.y[row] = 0.5F * (left.y[row] + right.y[row]);
    column_.cr[row] = 0.5F * (left.cr[row] + right.cr[row]);
    column_.cb[row] = 0.5F * (left.cb[row] + right.cb[row]);
    column_.carpet[row] = 0.5F * (left.carpet[row] + right.carpet[row]);
  }
}

void Camera::add(const Column& left, const Column& right, float share) {
  for (std::size_t row = 0; row < kRows; ++row) {
    column_.y[row] += share * (left.y[row] + right.y[row]);
    column_.cr[row] += share * (left.cr[row] + right.cr[row]);
    column_.cb[row] += share * (left.cb[row] + right.cb[row]);
    column_.carpet[row] += share * (left.carpet[row] + right.carpet[row]);
  }
}

// What lies between two cuts: their mean where both show the same, which is exact for straight
// edges; else it is halved, `splits` times at most.
void Camera::mix(const Scene& scene, const FieldCamera& camera, Stretch between, int splits) {
  const double width = between.to - between.from;
  Cut& left = *between.left;
  Cut& right = *between.right;
  if (splits == 0 || alike(left.shown, right.shown, params_.maxSlope)) {
    paint(scene, left);
    paint(scene, right);
    if (width == 1.0) return average(left.painted, right.painted);
    return add(left.painted, right.painted, static_cast<float>(0.5 * width));
  }
  if (width == 1.0) column_ = Column{};
  Cut& middle = middles_[static_cast<std::size_t>(splits - 1)];
  const double at = between.from + 0.5 * width;
  look(scene, Slice(camera, at), middle);
  mix(scene, camera, {&left, &middle, between.from, at}, splits - 1);
  mix(scene, camera, {&middle, &right, at, between.to}, splits - 1);
}

// Tufts fade where a pixel covers many of them; the coarse pattern stays. In loops of one thing
// each, which the compiler turns into vectors: nothing but the look-up goes row by row.
void Camera::addTexture(const Slice& middle) {
  std::size_t first = 0;
  while (first < kRows && column_.carpet[first] <= 0.0F) ++first;
  if (first == kRows) return;
  const Slice::GroundRows ground = middle.groundRows();
  std::array<std::int32_t, kRows> fineAt, coarseAt;
  for (std::size_t row = first; row < kRows; ++row) {
    fineAt[row] = texel(ground.x[row], ground.y[row], kFineTexels);
    coarseAt[row] = texel(ground.x[row] + 40.0F, ground.y[row] + 90.0F, kCoarseTexels);
  }
  const float* texture = tables_->texture.data();
  std::array<float, kRows> fine, coarse;
  for (std::size_t row = first; row < kRows; ++row) {
    fine[row] = texture[fineAt[row]];
    coarse[row] = texture[coarseAt[row]];
  }
  const auto max = static_cast<float>(params_.textureAmount);
  for (std::size_t row = first; row < kRows; ++row) {
    const float depth = ground.depth[row];
    const float amount = depth > 0.0F ? max * column_.carpet[row] : 0.0F;
    const float fade = std::min(1.0F, 60.0F / std::max(depth, 1.0F));
    column_.y[row] +=
        amount * (0.7F * fade * fine[row] + 0.3F * std::max(fade, 0.3F) * coarse[row]);
    column_.cb[row] += 0.15F * amount * fade * fine[row];
  }
}

void Camera::render(const Scene& scene, const ColumnCameras& cameras, Random& random,
                    Image& image) {
  selectOwn(scene, cameras);
  selectQuads(scene, cameras);
  ground_ = groundQuad(scene.carpet[0], scene.carpet[1], scene.green);
  FieldCamera camera;
  for (std::size_t x = 0; x < kImageWidth; ++x) {
    const auto left = static_cast<double>(x);
    if (x % kTogether == 0) {
      camera = mixed(cameras[x], cameras[x + kTogether - 1], 0.5);
      selectShapes(scene, camera, x);
    }
    Cut& before = borders_[x % 2];
    Cut& after = borders_[(x + 1) % 2];
    if (x == 0) look(scene, Slice(camera, left), before);
    look(scene, Slice(camera, left + 1.0), after);
    mix(scene, camera, {&before, &after, left, left + 1.0}, params_.splits);
    const Slice middle(camera, left + 0.5);
    if (params_.light && (scene.light.on() || scene.stripes.on())) lightGround(scene, middle);
    if (params_.texture) addTexture(middle);
    artefacts_.add(x, column_, random, image);
  }
}

}  // namespace kelpie::sim

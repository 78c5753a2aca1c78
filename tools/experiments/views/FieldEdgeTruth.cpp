// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/views/FieldEdgeTruth.h"

#include <cmath>
#include <optional>

#include "tools/sim/camera/Slice.h"

namespace kelpie::experiments {
namespace {

using Carpet = std::array<Point2<Field>, 2>;

std::optional<Point2<Field>> carpetAt(const sim::Slice& slice, const Carpet& carpet, double row) {
  const auto hit = slice.groundAt(row);
  if (!hit || hit->x < carpet[0].x || hit->x > carpet[1].x || hit->y < carpet[0].y ||
      hit->y > carpet[1].y)
    return std::nullopt;
  return Point2<Field>{hit->x, hit->y};
}

int nearestBorder(const Carpet& carpet, Point2<Field> p) {
  const std::array<double, 4> away = {p.x - carpet[0].x, carpet[1].x - p.x, p.y - carpet[0].y,
                                      carpet[1].y - p.y};
  int best = 0;
  for (int i = 1; i < 4; ++i)
    if (away[static_cast<std::size_t>(i)] < away[static_cast<std::size_t>(best)]) best = i;
  return best;
}

EdgeColumn columnTruth(const sim::Slice& slice, const Carpet& carpet) {
  EdgeColumn column;
  if (carpetAt(slice, carpet, 0.0)) return column;
  double bare = 0.0;
  double green = 1.0;
  while (green < kImageHeight && !carpetAt(slice, carpet, green)) bare = green++;
  if (green >= kImageHeight) {
    column.row = 1e6;
    return column;
  }
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (bare + green);
    (carpetAt(slice, carpet, middle) ? green : bare) = middle;
  }
  column.row = green;
  column.border = nearestBorder(carpet, *carpetAt(slice, carpet, green));
  return column;
}

bool covers(const std::optional<sim::Span>& span, double row) {
  return span && span->top <= row && row < span->bottom;
}

constexpr double kJustBelow = 0.7;  // px; a goal's back wall stands on the edge and hides nothing
constexpr double kSliceMargin = 0.01;

bool isHidden(const sim::Scene& scene, const sim::Slice& slice, double edgeRow) {
  const double row = edgeRow + kJustBelow;
  for (const auto* solids : {&scene.robots, &scene.fixtures}) {
    for (const auto& solid : *solids) {
      if (!slice.mayMeet(solid.centre, solid.radius, kSliceMargin)) continue;
      for (const auto& quad : solid.quads)
        if (covers(slice.quad(quad), row)) return true;
    }
  }
  for (const auto& beacon : scene.beacons)
    for (std::size_t band = 0; band < beacon.band.size(); ++band)
      if (covers(slice.band(beacon, band), row)) return true;
  for (const auto& ball : scene.balls)
    if (covers(slice.sphere(ball), row)) return true;
  return false;
}

}  // namespace

EdgeTruth edgeTruth(const View& view) {
  EdgeTruth truth;
  for (std::size_t x = 0; x < kImageWidth; ++x) {
    const sim::Slice slice(view.columns[x], static_cast<double>(x) + 0.5);
    truth.column[x] = columnTruth(slice, view.scene.carpet);
    if (truth.column[x].border == kNoBorder) continue;
    ++truth.inImage;
    truth.column[x].hidden = isHidden(view.scene, slice, truth.column[x].row);
    if (truth.column[x].hidden) continue;
    ++truth.shown;
    ++truth.borderColumns[static_cast<std::size_t>(truth.column[x].border)];
  }
  return truth;
}

double horizonTruth(const View& view, int column) {
  const auto& camera = view.columns[static_cast<std::size_t>(column)];
  const double across = camera.right.z * (column + 0.5 - camera.lens.principalX);
  return camera.lens.principalY - (across + camera.forward.z * camera.lens.focal) / camera.down.z;
}

}  // namespace kelpie::experiments

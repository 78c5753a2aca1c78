// SPDX-License-Identifier: Apache-2.0
#include "vision/GoalColumns.h"

#include <algorithm>
#include <optional>

#include "vision/Sight.h"
#include "vision/SpanWalk.h"

namespace kelpie::vision {
namespace {

constexpr double kGoalHeight = 30.0;
constexpr int kColumns = 9;
constexpr int kHoles = 2;

// Middle of the candidate's pixels in a column; nothing where the column has none.
std::optional<PixelPoint> insideColumn(const Scene& scene, const GoalCandidate& c, double x) {
  const int px = Sampler::pixelOf(x);
  const int top = std::max(Sampler::pixelOf(c.box.top), kUsableTop);
  const int bottom = std::min(Sampler::pixelOf(c.box.bottom), kUsableBottom - 1);
  if (px < kUsableLeft || px >= kUsableRight) return std::nullopt;
  int first = -1;
  int last = -1;
  for (int py = top; py <= bottom; py += kLatticeStep) {
    if (scene.sampler.classAt(px, py) != c.colour) continue;
    if (first < 0) first = py;
    last = py;
  }
  if (first < 0) return std::nullopt;
  for (int py = (first + last) / 2; py <= last; ++py) {
    if (scene.sampler.classAt(px, py) == c.colour) return PixelPoint{px + 0.5, py + 0.5};
  }
  return std::nullopt;
}

struct ColumnDistance {
  double distance = 0.0;
  double sd = 0.0;
  double footError = 0.0;
};

struct ColumnSpan {
  EdgeHit top;
  EdgeHit bottom;
};

// By height when both ends are in the image, else by the foot on the ground.
std::optional<ColumnDistance> distanceIn(const Scene& scene, const GoalParams& p,
                                         const ColumnSpan& span) {
  const CameraPose& camera = scene.body.camera;
  if (span.bottom.cut) return std::nullopt;
  const double low = sightOf(camera, span.bottom.point).slope;
  if (!span.top.cut) {
    const double d = kGoalHeight / std::max(sightOf(camera, span.top.point).slope - low, 1e-3);
    const double ground = -camera.position.z / d;
    return ColumnDistance{d, sizeSd(d, kGoalHeight, p.edgeSd),
                          maths::atan(low) - maths::atan(ground)};
  }
  if (low > -0.03) return std::nullopt;
  const double d = -camera.position.z / low;
  return ColumnDistance{d, d * d / camera.position.z * p.directionSd.rad(), 0.0};
}

// The image's top cuts it although 30 cm at the distance of its foot would end below that.
bool isTooTall(const Scene& scene, const ColumnSpan& span) {
  if (!span.top.cut || span.bottom.cut) return false;
  const CameraPose& camera = scene.body.camera;
  const double low = sightOf(camera, span.bottom.point).slope;
  const double high = sightOf(camera, span.top.point).slope;
  constexpr double kLeastSlope = 0.01;  // a foot at the horizon: nothing of 30 cm fills the view
  const double d = camera.position.z / std::max(-low, kLeastSlope);
  return (high - low) * d > 1.4 * kGoalHeight;
}

// The carpet follows within two pixels and a tenth of the height. Cut below: nothing speaks
// against.
bool hasGreenBelow(const Scene& scene, const ColumnSpan& span, ImageUp up) {
  if (span.bottom.cut) return true;
  const double height = span.top.length + span.bottom.length;
  for (const double away : {1.5, 2.5, 2.5 + 0.1 * height}) {
    const PixelPoint at{span.bottom.point.x - away * up.dx, span.bottom.point.y - away * up.dy};
    if (!Sampler::usable(at) || scene.sampler.classAt(at) == ColourClass::green) return true;
  }
  return false;
}

void measureColumns(const Scene& scene, const GoalParams& p, GoalCandidate& c) {
  const ImageUp up = imageUp(scene.body.camera);
  FixedVector<ColumnDistance, kColumns> found;
  for (int i = 0; i < kColumns; ++i) {
    const double share = 0.15 + 0.7 * i / (kColumns - 1);
    const auto start = insideColumn(scene, c, c.box.left + share * (c.box.right - c.box.left));
    if (!start) continue;
    const ColumnSpan span{walkToEdge(scene.sampler, {*start, up.dx, up.dy, c.colour, kHoles}),
                          walkToEdge(scene.sampler, {*start, -up.dx, -up.dy, c.colour, kHoles})};
    ++c.columns;
    c.fieldColumns += hasGreenBelow(scene, span, up) ? 1 : 0;
    c.tallColumns += isTooTall(scene, span) ? 1 : 0;
    c.topCut = c.topCut || span.top.cut;
    c.bottomCut = c.bottomCut || span.bottom.cut;
    const auto distance = distanceIn(scene, p, span);
    if (distance) found.push_back(*distance);
  }
  if (found.empty()) return;
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.distance < b.distance; });
  const ColumnDistance& median = found[found.size() / 2];
  c.distance = std::max(median.distance - p.depth, 5.0);
  c.distanceSd = median.sd;
  c.footError = median.footError;
}

// The post: outwards from the outermost lattice columns that show the goal.
PixelPoint edgeOf(const Scene& scene, const GoalCandidate& c, double from, double direction,
                  bool& cut) {
  const auto start = insideColumn(scene, c, from);
  if (!start) return {from, 0.5 * (c.box.top + c.box.bottom)};
  const EdgeHit hit = walkToEdge(scene.sampler, {*start, direction, 0.0, c.colour, kHoles});
  cut = cut || hit.cut;
  return hit.point;
}

}  // namespace

void measureGoal(const Scene& scene, const GoalParams& params, GoalCandidate& c) {
  const double inset = std::min(4.0, 0.2 * (c.box.right - c.box.left));
  c.leftCut = c.box.left <= kLatticeLeft;
  c.rightCut = c.box.right >= kUsableRight - 1;
  c.leftEdge = edgeOf(scene, c, c.box.left + inset, -1.0, c.leftCut);
  c.rightEdge = edgeOf(scene, c, c.box.right - inset, 1.0, c.rightCut);
  measureColumns(scene, params, c);
}

}  // namespace kelpie::vision

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

// By height when both ends are in the image, else by the foot on the ground.
std::optional<ColumnDistance> distanceIn(const Scene& scene, const GoalParams& p,
                                         const EdgeHit& top, const EdgeHit& bottom) {
  const CameraPose& camera = scene.body.camera;
  if (bottom.cut) return std::nullopt;
  const double low = sightOf(camera, bottom.point).slope;
  if (!top.cut) {
    const double d = kGoalHeight / std::max(sightOf(camera, top.point).slope - low, 1e-3);
    const double ground = -camera.position.z / d;
    return ColumnDistance{d, sizeSd(d, kGoalHeight, p.edgeSd),
                          maths::atan(low) - maths::atan(ground)};
  }
  if (low > -0.03) return std::nullopt;
  const double d = -camera.position.z / low;
  return ColumnDistance{d, d * d / camera.position.z * p.directionSd.rad(), 0.0};
}

void measureDistance(const Scene& scene, const GoalParams& p, GoalCandidate& c) {
  const ImageUp up = imageUp(scene.body.camera);
  FixedVector<ColumnDistance, kColumns> found;
  for (int i = 0; i < kColumns; ++i) {
    const double share = 0.2 + 0.6 * i / (kColumns - 1);
    const auto start = insideColumn(scene, c, c.box.left + share * (c.box.right - c.box.left));
    if (!start) continue;
    const EdgeHit top = walkToEdge(scene.sampler, {*start, up.dx, up.dy, c.colour, kHoles});
    const EdgeHit bottom = walkToEdge(scene.sampler, {*start, -up.dx, -up.dy, c.colour, kHoles});
    c.topCut = c.topCut || top.cut;
    c.bottomCut = c.bottomCut || bottom.cut;
    const auto distance = distanceIn(scene, p, top, bottom);
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
  measureDistance(scene, params, c);
}

}  // namespace kelpie::vision

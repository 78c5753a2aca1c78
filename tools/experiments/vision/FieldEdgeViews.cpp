// SPDX-License-Identifier: Apache-2.0
// The field edge in rendered views: found, missed, false; how often a ball on the field would be
// thrown away as lying beyond it; corners of the carpet; the horizon beside it.
#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/body/Camera.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/views/FieldEdgeTruth.h"
#include "tools/experiments/views/Looks.h"
#include "tools/experiments/vision/FieldEdgeParts.h"
#include "vision/Scene.h"

namespace kelpie::experiments {
namespace {

constexpr double kAllowed = 6.0;      // px
constexpr int kMinShown = 52;         // columns, a quarter: a view shows the edge
constexpr double kBallAllowed = 4.0;  // px above the edge from which a foot is thrown away

using Edges = FixedVector<FieldEdgePercept, 3>;

// Row errors where the edge is in sight, or also where something hides it.
Values rowErrors(const EdgeTruth& truth, const Edges& edges, bool hidden) {
  Values errors;
  for (int x = 0; x < kImageWidth; ++x) {
    const EdgeColumn& column = truth.column[static_cast<std::size_t>(x)];
    if (column.border != kNoBorder && (hidden || !column.hidden))
      errors.push_back(vision::fieldEdgeRow(edges, x + 0.5) - column.row);
  }
  return errors;
}

bool allWithin(const Values& errors) {
  return std::all_of(errors.begin(), errors.end(),
                     [](double e) { return std::fabs(e) <= kAllowed; });
}

// Lowest point of a ball that lies there, as the true camera of its column shows it.
std::optional<PixelPoint> ballFoot(const View& view, Point2<Field> place) {
  const auto centre = sim::pixelIn(view.eye, {place.x, place.y, body::kBallRadius});
  if (!centre || centre->x < 0.0 || centre->x >= kImageWidth) return std::nullopt;
  const sim::FieldPoint3 eye = view.eye.position;
  const double range = maths::hypot(maths::hypot(place.x - eye.x, place.y - eye.y), eye.z);
  const PixelPoint foot{centre->x, centre->y + view.eye.lens.focal * body::kBallRadius / range};
  if (centre->y < 0.0 || centre->y >= kImageHeight) return std::nullopt;
  return foot;
}

bool thrownAway(const Edges& edges, PixelPoint foot) {
  return foot.y < vision::fieldEdgeRow(edges, foot.x) - kBallAllowed;
}

struct Tally {
  int views = 0;
  int shown = 0;
  int found = 0;
  int foundHidden = 0;
  int missed = 0;
  int wrong = 0;
  int tooLow = 0;
  int claimedNone = 0;  // no edge in view, one claimed inside the image
  int notShown = 0;
  int edges = 0;
  int ballViews = 0;
  int ballsLost = 0;
  int spots = 0;
  int spotsLost = 0;
  Values errors;  // px, median of each found view
  Values horizonStill;
  Values horizonTurning;
};

bool insideImage(const Edges& edges) {
  for (int x = 0; x < kImageWidth; ++x) {
    const double row = vision::fieldEdgeRow(edges, x + 0.5);
    if (row > kAllowed && row < kImageHeight) return true;
  }
  return false;
}

void addEdges(const EdgeTruth& truth, const Edges& edges, Tally& tally) {
  ++tally.views;
  tally.edges += static_cast<int>(edges.size());
  if (truth.inImage == 0) {
    ++tally.notShown;
    tally.claimedNone += insideImage(edges) ? 1 : 0;
  }
  if (truth.shown < kMinShown) return;
  ++tally.shown;
  if (edges.empty()) {
    ++tally.missed;
    return;
  }
  const auto errors = rowErrors(truth, edges, false);
  const bool found = allWithin(errors);
  tally.found += found ? 1 : 0;
  tally.wrong += found ? 0 : 1;
  tally.tooLow += *std::max_element(errors.begin(), errors.end()) > kAllowed ? 1 : 0;
  tally.foundHidden += allWithin(rowErrors(truth, edges, true)) ? 1 : 0;
  Values size;
  size.reserve(errors.size());
  for (const double e : errors) size.push_back(std::fabs(e));
  if (found) tally.errors.push_back(percentile(size, 0.5));
}

constexpr int kSpots = 20;

void addBalls(const View& view, const Edges& edges, Random& random, Tally& tally) {
  if (const auto foot = ballFoot(view, view.ball)) {
    ++tally.ballViews;
    tally.ballsLost += thrownAway(edges, *foot) ? 1 : 0;
  }
  for (int i = 0; i < kSpots; ++i) {
    const auto foot = ballFoot(view, {random.uniform(0.0, 360.0), random.uniform(0.0, 540.0)});
    if (!foot) continue;
    ++tally.spots;
    tally.spotsLost += thrownAway(edges, *foot) ? 1 : 0;
  }
}

bool turns(const View& view) {
  const auto& first = view.columns.front().forward;
  const auto& last = view.columns.back().forward;
  return first.x != last.x || first.y != last.y || first.z != last.z;
}

// Where the true one is in the image. While the camera is still only the sensors' noise counts.
void addHorizon(const View& view, const Horizon& horizon, Tally& tally) {
  auto& errors = turns(view) ? tally.horizonTurning : tally.horizonStill;
  for (const int x : {0, kImageWidth / 2, kImageWidth - 1}) {
    const double truth = horizonTruth(view, x);
    if (!(truth > 0.0 && truth < kImageHeight)) continue;
    const double row =
        horizon.atLeft + (horizon.atRight - horizon.atLeft) * (x + 0.5) / kImageWidth;
    errors.push_back(std::fabs(row - truth));
  }
}

Json figures(const Tally& t) {
  return Json{{"views", t.views},
              {"shown_views", t.shown},
              {"found_rate", ratio(t.found, t.shown)},
              {"found_hidden_too_rate", ratio(t.foundHidden, t.shown)},
              {"missed_rate", ratio(t.missed, t.shown)},
              {"wrong_rate", ratio(t.wrong, t.shown)},
              {"too_low_rate", ratio(t.tooLow, t.shown)},
              {"without_edge_views", t.notShown},
              {"false_rate", ratio(t.claimedNone, t.notShown)},
              {"edges_per_view", ratio(t.edges, t.views)},
              {"error_median_px", percentile(t.errors, 0.5)},
              {"error_p95_px", percentile(t.errors, 0.95)},
              {"ball_views", t.ballViews},
              {"ball_lost_rate", ratio(t.ballsLost, t.ballViews)},
              {"spot_lost_rate", ratio(t.spotsLost, t.spots)},
              {"horizon_still_median_px", percentile(t.horizonStill, 0.5)},
              {"horizon_still_p95_px", percentile(t.horizonStill, 0.95)},
              {"horizon_turning_median_px", percentile(t.horizonTurning, 0.5)},
              {"horizon_turning_p95_px", percentile(t.horizonTurning, 0.95)}};
}

}  // namespace

Json fieldEdgeViews(const Request& request) {
  Random random(request.seed);
  Tally tally;
  lookAtViews({}, request, [&](const Look& look) {
    addEdges(edgeTruth(look.view), look.seen.fieldEdges, tally);
    addBalls(look.view, look.seen.fieldEdges, random, tally);
    addHorizon(look.view, look.body.horizon, tally);
  });
  return figures(tally);
}

}  // namespace kelpie::experiments

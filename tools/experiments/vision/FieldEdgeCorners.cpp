// SPDX-License-Identifier: Apache-2.0
// Corners of the carpet: views from the same stream as the others in which two of its borders show,
// each in at least 40 columns with nothing before it. Success: a line within 6 px of either, all
// along its part.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "robot/body/Camera.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/views/FieldEdgeTruth.h"
#include "tools/experiments/vision/FieldEdgeParts.h"
#include "vision/Scene.h"
#include "vision/Vision.h"

namespace kelpie::experiments {
namespace {

constexpr double kAllowed = 6.0;     // px
constexpr double kMeeting = 5.0;     // px, checklist
constexpr int kMinArm = 40;          // columns
constexpr int kViewsPerCorner = 40;  // drawn at most

using Edges = FixedVector<FieldEdgePercept, 3>;

// Largest row error of an edge where a border is in sight.
double worstError(const EdgeTruth& truth, int border, const FieldEdgePercept& edge) {
  double worst = 0.0;
  for (int x = 0; x < kImageWidth; ++x) {
    const EdgeColumn& column = truth.column[static_cast<std::size_t>(x)];
    if (column.border == border && !column.hidden)
      worst = std::fmax(worst, std::fabs(vision::edgeRow(edge, x + 0.5) - column.row));
  }
  return worst;
}

struct Corner {
  int left = kNoBorder;
  int right = kNoBorder;
  PixelPoint meeting;
};

// The first place where one long border follows another.
std::optional<Corner> cornerIn(const EdgeTruth& truth) {
  for (std::size_t x = 0; x + 1 < kImageWidth; ++x) {
    const int a = truth.column[x].border;
    const int b = truth.column[x + 1].border;
    if (a == b || a == kNoBorder || b == kNoBorder) continue;
    if (truth.borderColumns[static_cast<std::size_t>(a)] < kMinArm ||
        truth.borderColumns[static_cast<std::size_t>(b)] < kMinArm)
      continue;
    return Corner{a, b, {static_cast<double>(x) + 1.0, truth.column[x].row}};
  }
  return std::nullopt;
}

double meetingError(const FieldEdgePercept& a, const FieldEdgePercept& b, PixelPoint truth) {
  const double slopes = (b.atRight - b.atLeft) - (a.atRight - a.atLeft);
  if (slopes == 0.0) return 1e3;
  const double x = kImageWidth * (a.atLeft - b.atLeft) / slopes;
  return maths::hypot(x - truth.x, vision::edgeRow(a, x) - truth.y);
}

struct Tally {
  int corners = 0;
  int both = 0;
  int one = 0;
  int met = 0;
  int noEdge = 0;
  Values meeting;  // px
};

struct Match {
  const FieldEdgePercept* left = nullptr;
  const FieldEdgePercept* right = nullptr;
  double worst = 1e9;  // px
};

// Which two of the edges follow the corner's borders best.
Match matched(const EdgeTruth& truth, const Corner& corner, const Edges& edges) {
  Match best;
  for (const auto& a : edges)
    for (const auto& b : edges) {
      if (&a == &b) continue;
      const double worst =
          std::fmax(worstError(truth, corner.left, a), worstError(truth, corner.right, b));
      if (worst < best.worst) best = {&a, &b, worst};
    }
  return best;
}

bool oneFollows(const EdgeTruth& truth, const Corner& corner, const Edges& edges) {
  return std::any_of(edges.begin(), edges.end(), [&](const FieldEdgePercept& edge) {
    return std::fmin(worstError(truth, corner.left, edge), worstError(truth, corner.right, edge)) <=
           kAllowed;
  });
}

void addCorner(const EdgeTruth& truth, const Corner& corner, const Edges& edges, Tally& tally) {
  ++tally.corners;
  tally.noEdge += edges.empty() ? 1 : 0;
  tally.one += oneFollows(truth, corner, edges) ? 1 : 0;
  const Match match = matched(truth, corner, edges);
  if (match.worst > kAllowed) return;
  ++tally.both;
  tally.meeting.push_back(meetingError(*match.left, *match.right, corner.meeting));
  tally.met += tally.meeting.back() <= kMeeting ? 1 : 0;
}

}  // namespace

Json fieldEdgeCorners(const Request& request) {
  ViewParams params;
  params.randomised = cli::paramsOf(request.randomised);
  ViewMaker maker(params, request.seed + 1);
  const auto state = std::make_unique<vision::VisionState>();
  const int wanted = std::max(1, request.trials / 5);
  Tally tally;
  for (int drawn = 0; drawn < wanted * kViewsPerCorner && tally.corners < wanted; ++drawn) {
    const View& view = maker.next();
    const EdgeTruth truth = edgeTruth(view);
    const auto corner = cornerIn(truth);
    if (!corner) continue;
    const BodyState body = body::step(view.input, {});
    const Percepts seen = vision::step({view.input, body}, {}, *state);
    addCorner(truth, *corner, seen.fieldEdges, tally);
  }
  return Json{{"corners", tally.corners},
              {"corner_success_rate", ratio(tally.both, tally.corners)},
              {"one_edge_rate", ratio(tally.one, tally.corners)},
              {"no_edge_rate", ratio(tally.noEdge, tally.corners)},
              {"meeting_within_5_px_rate", ratio(tally.met, tally.corners)},
              {"meeting_median_px", percentile(tally.meeting, 0.5)},
              {"meeting_p90_px", percentile(tally.meeting, 0.9)}};
}

}  // namespace kelpie::experiments

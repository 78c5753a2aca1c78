// SPDX-License-Identifier: Apache-2.0
#include "gps/LinePoseSearch.h"

#include <algorithm>
#include <cmath>

#include "gps/Gaussian.h"
#include "gps/LineMap.h"
#include "gps/Symmetry.h"

namespace kelpie::gps {
namespace {

constexpr std::size_t kMinPoints = 16;  // line points
constexpr std::size_t kMaxPoses = kMaxModes / 2;

std::uint32_t startsOf(const LinePoseSearchParams& p) { return p.columns * p.rows * p.turns; }

// Headings fastest, so that the starts of one frame lie together.
Pose2 startAt(std::uint32_t index, const GpsParams& params) {
  const LinePoseSearchParams& p = params.search;
  const std::uint32_t place = index / p.turns;
  const std::uint32_t rowsBelow = place / p.columns;
  const double column = 0.5 + static_cast<double>(place % p.columns);
  const double row = 0.5 + static_cast<double>(rowsBelow);
  return {{params.field.width * column / p.columns, 0.5 * params.field.length * row / p.rows},
          Angle::rad(2.0 * maths::kPi * (index % p.turns) / p.turns)};
}

// The pose itself or its twin, whichever is in the own half.
Pose2 inOwnHalf(const Pose2& pose, const body::FieldDescription& field) {
  return pose.position.y > 0.5 * field.length ? twinOf(pose, field) : pose;
}

bool samePose(const Pose2& a, const Pose2& b, double apart) {
  return distance(a.position, b.position) < apart && (a.heading - b.heading).abs().deg() < apart;
}

// Keeps the best of each place, sorted by their match.
void keep(const FoundPose& found, const GpsParams& params, LinePoseSearch& search) {
  FixedVector<FoundPose, kFoundPoses> kept;
  bool placed = false;
  for (const FoundPose& other : search.best) {
    const bool same = samePose(other.pose, found.pose, params.search.apart) ||
                      samePose(other.pose, twinOf(found.pose, params.field), params.search.apart);
    if (same && !placed && other.match >= found.match) return;
    if (!placed && found.match > other.match) placed = kept.push_back(found);
    if (!same) kept.push_back(other);
  }
  if (!placed) kept.push_back(found);
  search.best = kept;
}

void tryStart(const SeenLines& seen, const GpsParams& params, const FieldFeatures& field,
              LinePoseSearch& search) {
  LineUpdateParams blunt = params.line;
  blunt.sharpness *= params.search.coarseShare;
  const LineFit far = fitLines(seen, startAt(search.next, params), field, blunt);
  const LineFit near = fitLines(seen, far.pose, field, params.line);
  if (field.outside(near.pose.position).value > 0.0) return;
  keep({inOwnHalf(near.pose, params.field), near.match}, params, search);
}

void tryStarts(const GpsParams& params, GpsState& state) {
  LinePoseSearch& search = state.search;
  const SeenLines seen = seenLines(state.map, params.search.points, params.lineMap);
  const std::uint32_t last =
      std::min(search.next + params.search.startsAFrame, startsOf(params.search));
  for (; search.next < last; ++search.next) tryStart(seen, params, state.features, search);
}

// The weight of a pose over that of the best: match lost is squared distance over S, and that over
// the points' variance a log likelihood, with as many independent points as the information has.
double weightOf(const LineFit& fit, double best, double points, const LineUpdateParams& params) {
  const double variance = params.correlation * maths::square(params.pointSd);
  return maths::exp(points * (fit.match - best) / (2.0 * params.sharpness * variance));
}

PoseMode modeOf(const LineFit& fit, const GpsParams& params) {
  const double wide = maths::square(params.modes.widePositionSd);
  const double floor = maths::square(params.line.floorSd);
  Matrix3 information = fit.information;
  information.diagonal() +=
      Vector3(1.0 / wide, 1.0 / wide, 1.0 / maths::square(params.modes.wideHeadingSd.rad()));
  Matrix3 covariance = information.inverse();
  covariance.diagonal() += Vector3(floor, floor, maths::square(params.line.floorHeadingSd.rad()));
  PoseMode mode;
  mode.pose = fit.pose;
  setCovariance(mode, covariance);
  return mode;
}

// The next of the best, once more with all points.
void refine(const GpsParams& params, GpsState& state) {
  LinePoseSearch& search = state.search;
  const SeenLines seen = seenLines(state.map, params.lineMap.matched, params.lineMap);
  FoundPose& found = search.best[search.next - startsOf(params.search)];
  const LineFit fit = fitLines(seen, found.pose, state.features, params.line);
  found = {fit.pose, fit.match};
}

// The best poses and their twins become the modes, if any matches well enough to be believed.
bool conclude(const GpsParams& params, GpsState& state) {
  FixedVector<FoundPose, kFoundPoses> refined = state.search.best;
  state.search.best.clear();
  for (const FoundPose& found : refined) keep(found, params, state.search);
  if (state.search.best.empty() || state.search.best[0].match < params.search.minMatch)
    return false;
  const SeenLines seen = seenLines(state.map, params.lineMap.matched, params.lineMap);
  LineUpdateParams only = params.line;
  only.maxSteps = 1;  // for the information at the pose
  double points = 0.0;
  for (const SeenPoint& p : seen.lines) points += p.weight;
  state.modes.clear();
  for (std::size_t i = 0; i < std::min(kMaxPoses, state.search.best.size()); ++i) {
    const LineFit fit = fitLines(seen, state.search.best[i].pose, state.features, only);
    PoseMode mode = modeOf(fit, params);
    mode.weight = weightOf(fit, state.search.best[0].match, points, params.line);
    state.modes.push_back(mode);
    mode.pose = twinOf(mode.pose, params.field);
    setCovariance(mode, turned(covarianceOf(mode), Angle::rad(maths::kPi)));
    state.modes.push_back(mode);
  }
  return true;
}

bool isWanted(const FrameInput& input, const GpsParams& params, const GpsState& state) {
  if (!params.search.use || !params.lineMap.use || !standing(input)) return false;
  const std::size_t points = countOf(state.map, LinePointKind::line);
  const bool patient = state.map.age < params.search.patience;
  if (points < (patient ? params.search.minPoints : kMinPoints)) return false;
  return state.lost || (input.lastCommand.localise && !state.search.served);
}

}  // namespace

bool stepLinePoseSearch(const FrameInput& input, const GpsParams& params, GpsState& state) {
  LinePoseSearch& search = state.search;
  if (!input.lastCommand.localise) search.served = false;
  if (!isWanted(input, params, state)) {
    search = LinePoseSearch{false, search.served, 0, {}};
    return false;
  }
  search.running = true;
  const std::uint32_t starts = startsOf(params.search);
  if (search.next < starts) {
    tryStarts(params, state);
    return false;
  }
  if (search.next < starts + search.best.size()) {
    refine(params, state);
    ++search.next;
    return false;
  }
  const bool found = conclude(params, state);
  search = LinePoseSearch{false, found, 0, {}};
  if (!found) return false;
  state.lost = false;
  state.unexplained = 0;
  state.map.newCount = 0.0;  // what it holds is in the modes now
  return true;
}

}  // namespace kelpie::gps

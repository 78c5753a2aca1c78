// SPDX-License-Identifier: Apache-2.0
#include "gps/lines/LinePoseSearch.h"

#include <algorithm>
#include <cmath>

#include "gps/Gaussian.h"
#include "gps/lines/LineMap.h"
#include "gps/lines/Symmetry.h"

namespace kelpie::gps {
namespace {

constexpr std::size_t kMinPoints = 16;  // line points
constexpr std::size_t kMaxPoses = kMaxModes / 2;

std::uint32_t startsOf(const LinePoseSearchParams& p) { return p.columns * p.rows * p.turns; }

// Headings fastest, so that the starts of one frame lie together.
Pose2 startAt(std::uint32_t index, const body::FieldDescription& field,
              const LinePoseSearchParams& p) {
  const std::uint32_t place = index / p.turns;
  const std::uint32_t rowsBelow = place / p.columns;
  const double column = 0.5 + static_cast<double>(place % p.columns);
  const double row = 0.5 + static_cast<double>(rowsBelow);
  return {{field.width * column / p.columns, 0.5 * field.length * row / p.rows},
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
void keep(const FoundPose& found, double apart, const body::FieldDescription& field,
          LinePoseSearch& search) {
  FixedVector<FoundPose, kFoundPoses> kept;
  bool placed = false;
  for (const FoundPose& other : search.best) {
    const bool same = samePose(other.pose, found.pose, apart) ||
                      samePose(other.pose, twinOf(found.pose, field), apart);
    if (same && !placed && other.match >= found.match) return;
    if (!placed && found.match > other.match) placed = kept.push_back(found);
    if (!same) kept.push_back(other);
  }
  if (!placed) kept.push_back(found);
  search.best = kept;
}

void tryStarts(const body::FieldDescription& field, const LinesParams& params, LinesState& lines) {
  LinePoseSearch& search = lines.search;
  const SeenLines seen = seenLines(lines.map, params.search.points, params.map);
  LineUpdateParams blunt = params.update;
  blunt.sharpness *= params.search.coarseShare;
  const std::uint32_t last =
      std::min(search.next + params.search.startsAFrame, startsOf(params.search));
  for (; search.next < last; ++search.next) {
    const Pose2 start = startAt(search.next, field, params.search);
    const LineFit far = fitLines(seen, start, lines.features, blunt);
    const LineFit near = fitLines(seen, far.pose, lines.features, params.update);
    if (lines.features.outside(near.pose.position).value > 0.0) continue;
    keep({inOwnHalf(near.pose, field), near.match}, params.search.apart, field, search);
  }
}

// The weight of a pose over that of the best: match lost is squared distance over S, and that over
// the points' variance a log likelihood, with as many independent points as the information has.
double weightOf(const LineFit& fit, double best, double points, const LineUpdateParams& params) {
  const double variance = params.correlation * maths::square(params.pointSd);
  return maths::exp(points * (fit.match - best) / (2.0 * params.sharpness * variance));
}

PoseMode modeOf(const LineFit& fit, const LinesParams& params) {
  const double prior = maths::square(params.search.priorSd);
  const double floor = maths::square(params.update.floorSd);
  Matrix3 information = fit.information;
  information.diagonal() +=
      Vector3(1.0 / prior, 1.0 / prior, 1.0 / maths::square(params.search.priorHeadingSd.rad()));
  Matrix3 covariance = information.inverse();
  covariance.diagonal() += Vector3(floor, floor, maths::square(params.update.floorHeadingSd.rad()));
  PoseMode mode;
  mode.pose = fit.pose;
  setCovariance(mode, covariance);
  return mode;
}

// The next of the best, once more with all points.
void refine(const LinesParams& params, LinesState& lines) {
  LinePoseSearch& search = lines.search;
  const SeenLines seen = seenLines(lines.map, params.map.matched, params.map);
  FoundPose& found = search.best[search.next - startsOf(params.search)];
  const LineFit fit = fitLines(seen, found.pose, lines.features, params.update);
  found = {fit.pose, fit.match};
}

// Two modes of one weight: the pose and its twin.
void addTwins(PoseMode mode, const body::FieldDescription& field, Modes& modes) {
  modes.push_back(mode);
  mode.pose = twinOf(mode.pose, field);
  setCovariance(mode, turned(covarianceOf(mode), Angle::rad(maths::kPi)));
  modes.push_back(mode);
}

// The best poses and their twins become the modes, if any matches well enough to be believed.
bool conclude(const body::FieldDescription& field, const LinesParams& params, LinesState& lines,
              Modes& modes) {
  LinePoseSearch& search = lines.search;
  const FixedVector<FoundPose, kFoundPoses> refined = search.best;
  search.best.clear();
  for (const FoundPose& found : refined) keep(found, params.search.apart, field, search);
  if (search.best.empty() || search.best[0].match < params.search.minMatch) return false;
  const SeenLines seen = seenLines(lines.map, params.map.matched, params.map);
  LineUpdateParams only = params.update;
  only.maxSteps = 1;  // for the information at the pose
  double points = 0.0;
  for (const SeenPoint& p : seen.lines) points += p.weight;
  modes.clear();
  for (std::size_t i = 0; i < std::min(kMaxPoses, search.best.size()); ++i) {
    const LineFit fit = fitLines(seen, search.best[i].pose, lines.features, only);
    PoseMode mode = modeOf(fit, params);
    mode.weight = weightOf(fit, search.best[0].match, points, params.update);
    addTwins(mode, field, modes);
  }
  return true;
}

bool isWanted(const FrameInput& input, const LinesParams& params, const LinesState& lines,
              bool lost) {
  if (!params.search.use || !params.map.use || !standing(input)) return false;
  const std::size_t points = countOf(lines.map, LinePointKind::line);
  const bool patient = lines.map.age < params.search.patience;
  if (points < (patient ? params.search.minPoints : kMinPoints)) return false;
  return lost || (input.lastCommand.localise && !lines.search.served);
}

}  // namespace

bool stepLinePoseSearch(const FrameInput& input, const body::FieldDescription& field,
                        const LinesParams& params, LinesState& lines, PoseState& pose) {
  LinePoseSearch& search = lines.search;
  if (!input.lastCommand.localise) search.served = false;
  if (!isWanted(input, params, lines, pose.lost)) {
    search = LinePoseSearch{false, search.served, 0, {}};
    return false;
  }
  search.running = true;
  const std::uint32_t starts = startsOf(params.search);
  if (search.next < starts) {
    tryStarts(field, params, lines);
    return false;
  }
  if (search.next < starts + search.best.size()) {
    refine(params, lines);
    ++search.next;
    return false;
  }
  const bool found = conclude(field, params, lines, pose.modes);
  search = LinePoseSearch{false, found, 0, {}};
  if (!found) return false;
  pose.lost = false;
  pose.unexplained = 0;
  lines.map.newCount = 0.0;  // what it holds is in the modes now
  return true;
}

}  // namespace kelpie::gps

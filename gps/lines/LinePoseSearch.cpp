// SPDX-License-Identifier: Apache-2.0
#include "gps/lines/LinePoseSearch.h"

#include <algorithm>

#include "gps/Gaussian.h"
#include "gps/SamePose.h"
#include "gps/lines/LineMap.h"
#include "gps/lines/PaintedField.h"

namespace kelpie::gps {
namespace {

constexpr std::size_t kMinPoints = 16;  // of lines and border
constexpr std::size_t kMaxPoses = kMaxModes / 2;
constexpr std::size_t kRefined = 2 * kMaxPoses;

// The pose itself or its twin, whichever is in the own half.
Pose2 inOwnHalf(const Pose2& pose, const body::FieldDescription& field) {
  return pose.position.y > 0.5 * field.length ? twinOf(pose, field) : pose;
}

// Half of the field is searched: a pose and its twin match alike and count as one.
struct MapScene {
  const body::FieldDescription& field;
  const FieldFeatures& features;
  const LinesParams& params;
  SeenLines few;  // matched from each start
  SeenLines all;

  // First with a blunter match, which leads from farther away.
  std::optional<FoundPose> tried(const Pose2& start) const {
    LineUpdateParams blunt = params.update;
    blunt.sharpness *= params.search.coarseShare;
    const LineFit far = fitLines(few, start, features, blunt);
    const LineFit near = fitLines(few, far.pose, features, params.update);
    if (features.outside(near.pose.position).value > 0.0) return std::nullopt;
    return FoundPose{inOwnHalf(near.pose, field), near.match};
  }
  FoundPose refined(const FoundPose& found) const {
    const LineFit fit = fitLines(all, found.pose, features, params.update);
    return {fit.pose, fit.match};
  }
  bool same(const Pose2& a, const Pose2& b) const {
    const double apart = params.search.apart;
    return samePose(a, b, apart, apart) || samePose(a, twinOf(b, field), apart, apart);
  }
};

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

// Two modes of one weight: the pose and its twin.
void addTwins(PoseMode mode, const body::FieldDescription& field, Modes& modes) {
  modes.push_back(mode);
  mode.pose = twinOf(mode.pose, field);
  setCovariance(mode, turned(covarianceOf(mode), Angle::rad(maths::kPi)));
  modes.push_back(mode);
}

// The best poses and their twins become the modes, if any matches well enough to be believed.
bool conclude(const MapScene& scene, const FoundPoses& found, Modes& modes) {
  const LinesParams& params = scene.params;
  if (found.empty() || found[0].score < params.search.minMatch) return false;
  LineUpdateParams only = params.update;
  only.maxSteps = 1;  // for the information at the pose
  double points = 0.0;
  for (const SeenPoint& p : scene.all.lines) points += p.weight;
  modes.clear();
  for (std::size_t i = 0; i < std::min(kMaxPoses, found.size()); ++i) {
    const LineFit fit = fitLines(scene.all, found[i].pose, scene.features, only);
    PoseMode mode = modeOf(fit, params);
    mode.weight = weightOf(fit, found[0].score, points, params.update);
    addTwins(mode, scene.field, modes);
  }
  return true;
}

bool isWanted(const FrameInput& input, const LinesParams& params, const LinesState& lines,
              bool lost) {
  if (!params.search.use || !params.map.use || !standing(input)) return false;
  const std::size_t points = countOfWhite(lines.map);
  const bool patient = lines.map.age < params.search.patience;
  if (points < (patient ? params.search.minPoints : kMinPoints)) return false;
  return lost || (input.lastCommand.localise && !lines.searchServed);
}

}  // namespace

bool stepLinePoseSearch(const FrameInput& input, const body::FieldDescription& field,
                        const LinesParams& params, LinesState& lines, PoseState& pose) {
  if (!input.lastCommand.localise) lines.searchServed = false;
  if (!isWanted(input, params, lines, pose.lost)) {
    lines.search = PoseSearch{};
    return false;
  }
  const LinePoseSearchParams& p = params.search;
  const MapScene scene{field, lines.features, params, seenLines(lines.map, p.points, params.map),
                       seenLines(lines.map, params.map.matched, params.map)};
  const PoseGrid grid{field.width, 0.5 * field.length, p.columns, p.rows, p.turns};
  if (!stepPoseSearch(grid, {p.startsAFrame, 1, kRefined}, scene, lines.search)) return false;
  lines.searchServed = conclude(scene, lines.search.found, pose.modes);
  lines.search = PoseSearch{};
  if (!lines.searchServed) return false;
  pose.lost = false;
  pose.unexplained = 0;
  lines.map.newCount = 0.0;  // what it holds is in the modes now
  return true;
}

}  // namespace kelpie::gps

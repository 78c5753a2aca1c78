// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/baselines/SymmetryUpdate.h"

#include <algorithm>
#include <utility>

#include "gps/SamePose.h"
#include "gps/lines/LineUpdate.h"

namespace kelpie::gps {
namespace {

constexpr double kGateSds = 4.0;  // standard deviations: beyond, S is below 4e-4

bool isWithin(const PoseMode& mode, const Pose2& pose) {
  const Point2<Field> d = pose.position - mode.pose.position;
  const double turn = (pose.heading - mode.pose.heading).rad();
  const double reach2 = kGateSds * kGateSds;
  return d.x * d.x <= reach2 * mode.covariance[0] && d.y * d.y <= reach2 * mode.covariance[4] &&
         turn * turn <= reach2 * mode.covariance[8];
}

using SymmetricModes = FixedVector<PoseMode, kMaxAmbiguousPoses>;

// Heaviest first; the lightest is lost when there is no room.
void keep(PoseMode mode, std::size_t max, SymmetricModes& modes) {
  for (PoseMode& kept : modes)
    if (mode.weight > kept.weight) std::swap(mode, kept);
  if (modes.size() < max) modes.push_back(mode);
}

// Each mode corrected by each pose that looks like the found one and lies within it.
SymmetricModes symmetricModes(const SeenLines& seen, const PoseObservation& found,
                              const PaintedField& field, const LineUpdateParams& params,
                              const Modes& modes) {
  constexpr SymmetryParams kSymmetry;
  SymmetricModes symmetric;
  LineUpdateParams lines = params;  // thesis 2004 equation 3.20: worse matches are left out
  lines.match += lines.matchStill / (1.0 + lines.headSpeed * seen.headSpeed);
  LineFit fit;
  fit.pose = found.pose;
  fit.information = found.information;
  fit.match = lineMatch(seen, found.pose, field.features, lines);
  const AmbiguousPoses poses =
      ambiguousPoses(seen, fit, field, paintedFeatures(field.description), lines, kSymmetry);
  for (const AmbiguousPose& pose : poses) {
    if (samePose(pose.pose, found.pose, kSameCm, kSameDeg)) continue;
    for (const PoseMode& mode : modes) {
      if (!isWithin(mode, pose.pose)) continue;
      PoseMode moved = corrected(mode, PoseObservation{pose.pose, pose.information});
      moved.weight *= pose.match / std::max(fit.match, 0.1);
      keep(moved, kSymmetry.maxPoses, symmetric);
    }
  }
  return symmetric;
}

}  // namespace

bool updateByLinesAndSymmetry(const SeenLines& seen, const PaintedField& field,
                              const LineUpdateParams& params, Modes& modes, GpsCounts& counts) {
  const Modes before = modes;
  if (!updateByLines(seen, field.features, params, modes, counts)) return false;
  const auto found = observationAt(before[0], seen, field.features, params, counts);
  if (!found) return true;
  for (const PoseMode& mode : symmetricModes(seen, found->pose, field, params, before))
    modes.push_back(mode);
  return true;
}

}  // namespace kelpie::gps

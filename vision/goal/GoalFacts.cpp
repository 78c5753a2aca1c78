// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalFacts.h"

#include <algorithm>
#include <cmath>

#include "vision/pixels/Lattice.h"

namespace kelpie::vision {
GoalFacts goalFacts(const Scene& scene, const GoalCandidate& c, const GoalShape& shape) {
  constexpr double kFarFoot = 20.0;  // px; without an edge in view as well
  constexpr double kMaxMisfit = 50.0;
  GoalFacts facts;
  const ColumnCounts columns = countColumns(c);
  const GoalFeet feet = feetOf(scene, c);
  facts.chosen = columns.chosen;
  facts.measured = columns.measured;
  facts.lowestFoot = maths::clamp(feet.lowest, -kFarFoot, kFarFoot);
  facts.meanFoot = maths::clamp(feet.sum / std::max(facts.chosen, 1.0), -kFarFoot, kFarFoot);
  facts.wallDistance = c.wallDistance;
  facts.visibleWidth = visibleWidth(scene, c);
  facts.misfit = std::min(shape.cost / std::max(facts.measured, 1.0), kMaxMisfit);
  facts.footError = std::fabs(Angle::rad(c.settledFootError()).deg());
  facts.coloured =
      c.samples * maths::square(kLatticeStep) / std::max(1.0, c.box.width() * c.box.height());
  facts.hidden = (c.left.hidden ? 1.0 : 0.0) + (c.right.hidden ? 1.0 : 0.0);
  facts.lateralOffset = shape.lateralOffset();
  facts.topCut = c.topCut ? 1.0 : 0.0;
  facts.cut = (c.left.cut ? 1.0 : 0.0) + (c.right.cut ? 1.0 : 0.0);
  facts.width = c.box.width();
  double paint = 0.0;
  for (const GoalColumn& column : c.columns) paint += column.chosen ? column.paint : 0.0;
  facts.paint = paint / std::max(facts.chosen, 1.0);
  for (const GoalColumn& column : c.columns) facts.green += column.green ? 1.0 : 0.0;
  facts.green /= std::max(1.0, static_cast<double>(c.columns.size()));
  return facts;
}

}  // namespace kelpie::vision

// SPDX-License-Identifier: Apache-2.0
#include "vision/GoalDoubt.h"

#include <algorithm>
#include <cmath>

#include "vision/Lattice.h"
#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kNear = 210.0;  // cm: nearer, the image borders cut most goals
constexpr double kPrior = 5.0;

constexpr std::array<Weight<GoalFacts>, 18> kWeights = {{
    {&GoalFacts::seen, 36.5, -1.5},
    {&GoalFacts::seen, 49.5, -1.9},
    {&GoalFacts::lowest, -0.05, -2.5, Range::far},
    {&GoalFacts::meanFoot, -0.8, -2.1},
    {&GoalFacts::meanFoot, -0.5, -1.8},
    {&GoalFacts::meanFoot, 1.6, 2.0},
    {&GoalFacts::footError, 0.36, 1.9, Range::far},
    {&GoalFacts::footError, 0.6, 1.6},
    {&GoalFacts::misfit, 0.45, 1.3},
    {&GoalFacts::misfit, 10.0, 1.0},
    {&GoalFacts::measured, 10.0, -1.6},
    {&GoalFacts::chosen, 21.0, -1.3},
    {&GoalFacts::chosenShare, 0.875, 1.8, Range::far},
    {&GoalFacts::edges, 2.0, -1.2},
    {&GoalFacts::coloured, 1.19, -1.5},
    {&GoalFacts::hidden, 1.0, 1.1, Range::far},
    {&GoalFacts::aside, 240.0, 1.3},
    {&GoalFacts::topCut, 1.0, 0.6},
}};

}  // namespace

GoalFacts goalFacts(const Scene& scene, const GoalCandidate& c, const GoalShape& shape,
                    const GoalParams& p) {
  GoalFacts facts;
  const ColumnCounts columns = countColumns(c);
  const GoalFeet feet = feetOf(scene, c);
  facts.chosen = columns.chosen;
  facts.measured = columns.measured;
  facts.chosenShare = facts.chosen / std::max(1.0, static_cast<double>(c.columns.size()));
  facts.lowest = feet.lowest;
  facts.meanFoot = feet.sum / std::max(facts.chosen, 1.0);
  facts.wall = c.wall;
  facts.seen = seenWidth(scene, c, p);
  facts.misfit = shape.cost / std::max(facts.measured, 1.0);
  facts.footError = std::fabs(Angle::rad(c.footError).deg());
  facts.edges = static_cast<double>(scene.fieldEdges.size());
  facts.coloured =
      c.samples * maths::square(kLatticeStep) / std::max(1.0, c.box.width() * c.box.height());
  facts.hidden = (c.left.hidden ? 1.0 : 0.0) + (c.right.hidden ? 1.0 : 0.0);
  facts.aside = shape.aside();
  facts.topCut = c.topCut ? 1.0 : 0.0;
  return facts;
}

double goalDoubt(const GoalFacts& facts) {
  return logOdds(kPrior, kWeights, facts, facts.wall < kNear);
}

}  // namespace kelpie::vision

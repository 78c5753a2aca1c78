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
    {&GoalFacts::slant, 240.0, 1.3},
    {&GoalFacts::topCut, 1.0, 0.6},
}};

void addColumns(const Scene& scene, const GoalCandidate& c, GoalFacts& facts) {
  double sum = 0.0;
  for (const GoalColumn& column : c.columns) {
    if (!column.chosen) continue;
    facts.chosen += 1.0;
    facts.measured += column.distance > 0.0 ? 1.0 : 0.0;
    if (column.footCut) continue;
    const double below = belowFieldEdge(scene, column.foot);
    facts.lowest = std::max(facts.lowest, below);
    sum += below;
  }
  facts.meanFoot = sum / std::max(facts.chosen, 1.0);
  facts.chosenShare = facts.chosen / std::max(1.0, static_cast<double>(c.columns.size()));
}

}  // namespace

GoalFacts goalFacts(const Scene& scene, const GoalCandidate& c, const GoalShape& shape,
                    const GoalParams& p) {
  GoalFacts facts;
  addColumns(scene, c, facts);
  facts.wall = c.wall;
  facts.seen = seenWidth(scene, c, p);
  facts.misfit = shape.cost / std::max(facts.measured, 1.0);
  facts.footError = std::fabs(Angle::rad(c.footError).deg());
  facts.edges = static_cast<double>(scene.fieldEdges.size());
  facts.coloured =
      c.samples * maths::square(kLatticeStep) / std::max(1.0, c.box.width() * c.box.height());
  facts.hidden = (c.left.hidden ? 1.0 : 0.0) + (c.right.hidden ? 1.0 : 0.0);
  const Angle turn = Angle::rad(shape.turn) - bearing(shape.middle);
  facts.slant = shape.middle.norm() * maths::sin(std::fabs(turn.rad()));
  facts.topCut = c.topCut ? 1.0 : 0.0;
  return facts;
}

double goalDoubt(const GoalFacts& facts) {
  return logOdds(kPrior, kWeights, facts, facts.wall < kNear);
}

}  // namespace kelpie::vision

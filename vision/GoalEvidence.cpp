// SPDX-License-Identifier: Apache-2.0
#include "vision/GoalEvidence.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kelpie::vision {
namespace {

constexpr double kNear = 210.0;  // cm: nearer, the image borders cut most goals
constexpr double kOpenWidthOff = 40.0;
constexpr double kPrior = 5.5;

enum class Range { any, near, far };

// A fact of at least `least` adds `logOdds`.
struct Weight {
  double GoalFacts::*fact;
  double least;
  double logOdds;
  Range range = Range::any;
};

constexpr std::array<Weight, 16> kWeights = {{
    {&GoalFacts::seen, 50.0, -2.5},
    {&GoalFacts::widthOff, 23.0, 1.4},
    {&GoalFacts::lowest, -0.04, -2.7},
    {&GoalFacts::meanFoot, -0.75, -1.7},
    {&GoalFacts::meanFoot, -0.5, -1.3, Range::far},
    {&GoalFacts::meanFoot, 0.7, 1.2},
    {&GoalFacts::meanFoot, 2.1, 1.9, Range::near},
    {&GoalFacts::misfit, 0.13, 1.2},
    {&GoalFacts::misfit, 0.45, 1.2},
    {&GoalFacts::footError, 0.35, 1.6, Range::far},
    {&GoalFacts::footError, 0.45, 1.8, Range::far},
    {&GoalFacts::measured, 3.0, -2.2},
    {&GoalFacts::chosen, 21.0, -1.6},
    {&GoalFacts::chosenShare, 0.875, 1.7, Range::far},
    {&GoalFacts::edges, 2.0, -1.4},
    {&GoalFacts::samples, 70.0, -1.8},
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
  const bool open = c.left.open() || c.right.open();
  facts.wall = c.wall;
  facts.seen = seenWidth(scene, c, p);
  facts.widthOff = open ? kOpenWidthOff : std::fabs(facts.seen - p.width);
  facts.misfit = shape.cost / std::max(facts.measured, 1.0);
  facts.footError = std::fabs(Angle::rad(c.footError).deg());
  facts.edges = static_cast<double>(scene.fieldEdges.size());
  facts.samples = c.samples;
  return facts;
}

double goalDoubt(const GoalFacts& facts) {
  const bool near = facts.wall < kNear;
  double doubt = kPrior;
  for (const Weight& w : kWeights) {
    const bool applies = w.range == Range::any || near == (w.range == Range::near);
    if (applies && facts.*w.fact >= w.least) doubt += w.logOdds;
  }
  return doubt;
}

}  // namespace kelpie::vision

// SPDX-License-Identifier: Apache-2.0
#include "vision/Together.h"

#include "vision/Refusal.h"

namespace kelpie::vision {
namespace {

bool isGoal(const LandmarkPercept& landmark) { return landmark.kind <= LandmarkKind::goalYellow; }

double area(const LandmarkPercept& landmark) {
  return (landmark.box.right - landmark.box.left) * (landmark.box.bottom - landmark.box.top);
}

}  // namespace

void keepOneGoal(Percepts& percepts) {
  double largest = 0.0;
  for (const auto& landmark : percepts.landmarks)
    if (isGoal(landmark) && area(landmark) > largest) largest = area(landmark);
  FixedVector<LandmarkPercept, 8> kept;
  bool goalKept = false;
  for (const auto& landmark : percepts.landmarks) {
    const bool good = !isGoal(landmark) || (!goalKept && area(landmark) >= largest);
    if (good)
      kept.push_back(landmark);
    else
      refuse(percepts.counts, Refusal::goalOpposite);
    goalKept = goalKept || (good && isGoal(landmark));
  }
  percepts.landmarks = kept;
}

}  // namespace kelpie::vision

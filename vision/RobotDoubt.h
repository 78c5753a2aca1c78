// SPDX-License-Identifier: Apache-2.0
// Whether what passed every check is a robot: plain facts of its largest patch and of all of them,
// and the log odds that it is none. Specks on clothes beyond the carpet and patches placed too far,
// because something hides the feet, pass each single check now and then. Weak for a robot of which
// one small patch shows at the carpet's edge.
#pragma once

namespace kelpie::vision {

struct RobotFacts {
  double patches = 1.0;
  double distance = 0.0;  // cm, camera to the nearest leg
  double width = 0.0;     // cm, of all patches together
  // Of the largest patch:
  double own = 0.0;          // share of its colour inside its box
  double shell = 0.0;        // share of white and grey round it
  double patchWidth = 0.0;   // cm
  double patchHeight = 0.0;  // cm
  double heightOff = 0.0;    // cm of its middle from a trunk's height
  double beyond = 0.0;       // cm of carpet from its foot to the field edge
  double inside = 0.0;       // px of its foot below the field edge
  double behind = 0.0;       // px of carpet seen behind, 30 where the image does not tell
  double footCut = 0.0;      // 1: the image ends before the foot
  double edges = 0.0;        // field edges in view
};

// Natural log of the odds that it is no robot, up to a constant (logistic regression on candidates
// of 60 000 rendered views; experiments.md tells how).
double robotDoubt(const RobotFacts& facts);

}  // namespace kelpie::vision

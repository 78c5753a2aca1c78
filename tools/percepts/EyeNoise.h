// SPDX-License-Identifier: Apache-2.0
// How vision differs from a perfect observer: what it misses, and the errors that pixels and sizes
// have. Fitted to what eight robots saw in a match from images (`kelpie evaluate percept-noise`,
// 27,800 frames). Errors of joints, stance and lean are not here: they come about by themselves
// (View.h).
#pragma once

#include <array>

namespace kelpie::percepts {

// Recall of a thing of which no more than a part shows: from almost none, then from 20, 40, 60 and
// 80 %, and of a whole one.
using RecallByShare = std::array<double, 6>;

struct BallErrors {
  RecallByShare near{0.3, 0.65, 0.7, 0.95, 0.97, 0.99};  // to 150 cm
  RecallByShare far{0.0, 0.03, 0.25, 0.65, 0.95, 0.99};  // from 300 cm on; between, both
  double fades = 350.0;                                  // cm, from where on fewer are recognised
  double farthest = 440.0;                               // cm, from where on none is
  double pixel = 0.25;                                   // px, of its centre
  double share = 0.023;                                  // of the distance
  double turningShare = 0.058;                           // so, while the head turns
  double partShare = 0.1;                                // so, when not all of it shows
  double bias = 0.005;                                   // of the distance
  double farBias = 0.025;                                // more from 300 cm on, or of a part
};

struct BeaconErrors {
  RecallByShare recall{0.15, 0.18, 0.5, 0.65, 0.87, 0.96};  // of its bands
  double farthest = 500.0;                                  // cm
  double pixel = 1.5;                                       // px, of its middle
  double edge = 0.13;       // px, of the bands' height that tells the distance
  double partShare = 0.06;  // of the distance, when not all of it shows
};

struct GoalErrors {
  RecallByShare recall{0.1, 0.35, 0.66, 0.9, 0.92, 0.95};  // of its mouth's width
  double near = 100.0;                                     // cm; to there that much of it
  double nearRecall = 0.45;
  double farthest = 580.0;    // cm
  double pixel = 1.0;         // px, of an end or of a gap's
  double share = 0.03;        // of the distance
  double hiddenShare = 0.28;  // of what does not show of the mouth, in its middle's place
};

// By the pixels of uniform that show, evenly over their logarithm.
struct RobotErrors {
  double redFew = 4.0, redMany = 30.0;  // no red robot is recognised, and as many as ever are
  double blueFew = 6.0, blueMany = 45.0;
  double recall = 0.77;
  double tooMany = 256.0;  // pixels of one that fills the view
  double tooManyRecall = 0.53;
  double near = 40.0;        // cm, to where
  double nearRecall = 0.16;  // that holds
  double farthest = 265.0;   // cm
  double share = 0.07;       // of the distance
  double bias = -0.04;       // so
  double across = 4.0;       // cm
};

struct ObstacleErrors {
  double recall = 1.0;  // of a column of pixels with a lower leg in it
  double pixel = 1.0;   // px, of where it begins
};

struct LineErrors {
  double recall = 0.7;        // of a crossing of a grid line
  double near = 100.0;        // cm, to which that holds
  double farthest = 330.0;    // cm, where none is left
  double pixel = 0.3;         // px
  double fieldRecall = 0.98;  // of a point deep in the green
};

// Of a frame: that it shows something which is not there.
struct FalseOnes {
  double robots = 0.005;
  double beacons = 0.0006;
};

struct EyeNoise {
  BallErrors ball;
  BeaconErrors beacon;
  GoalErrors goal;
  RobotErrors robot;
  ObstacleErrors obstacle;
  LineErrors line;
  FalseOnes falseOnes;
  double edgeRms = 0.5;  // px, of a border of the carpet
};

}  // namespace kelpie::percepts

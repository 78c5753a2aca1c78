// SPDX-License-Identifier: Apache-2.0
// One to three straight edges that bound a convex carpet, and their score: the truncated quadratic
// of MSAC over the features. The carpet is inside all of them, so a feature belongs to the edge
// that it is farthest beyond, and none may lie beyond any.
#pragma once

#include "robot/core/FixedVector.h"
#include "vision/edge/EdgeFeatures.h"
#include "vision/edge/EdgeLine.h"

namespace kelpie::vision {

using EdgeLines = FixedVector<EdgeLine, 3>;

constexpr double kNoScore = -1e6;  // less than any outline's

struct Outline {
  EdgeLines lines;
  double score = kNoScore;  // in inliers
};

// How far a point is off the carpet, and the edge that says so. There must be an edge.
struct EdgePlace {
  double distance = 0.0;  // px
  std::size_t edge = 0;
};
inline EdgePlace placeOf(const EdgeLines& lines, PixelPoint p) {
  EdgePlace place{lines[0].distanceBeyond(p), 0};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const double beyond = lines[i].distanceBeyond(p);
    if (beyond > place.distance) place = {beyond, i};
  }
  return place;
}

// What an outline is scored by.
struct EdgeEvidence {
  const EdgeFeatures& features;
  const HorizonFrame& frame;
  const FieldEdgeParams& params;
};

// Inliers weighted by their closeness and trust, less a fine for each place of the carpet that is
// seen beyond (MSAC, Torr and Zisserman 2000, with the fine added).
double scoreOf(const EdgeEvidence& evidence, const EdgeLines& lines);

// Refits every edge to its inliers within `width` tolerances, if that is better: a line through two
// points is off at its far end. Whether it was.
bool refine(const EdgeEvidence& evidence, double width, Outline& outline);

// Counts the inliers of each edge and their distance.
void measure(const EdgeEvidence& evidence, EdgeLines& lines);

// Number of features beyond the outline: places of the carpet that it leaves out.
double carpetBeyond(const EdgeEvidence& evidence, const EdgeLines& lines);

constexpr double kMinNoise = 0.09;  // px^2: features lie on whole pixels
// px^2, mean over the features on the measured edges.
double noiseOf(const EdgeLines& lines);

}  // namespace kelpie::vision

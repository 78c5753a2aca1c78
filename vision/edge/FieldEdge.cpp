// SPDX-License-Identifier: Apache-2.0
#include "vision/edge/FieldEdge.h"

#include "robot/core/Maths.h"
#include "vision/edge/EdgeFeatures.h"

namespace kelpie::vision {
namespace {

constexpr double kFarRow = 1e4;    // px; as the horizon's rows
constexpr double kMinTilt = 0.02;  // a steeper line would reach the far row inside the image

double rowAt(const EdgeLine& line, double x) {
  return maths::clamp((line.offset - line.nx * x) / line.ny, -kFarRow, kFarRow);
}

}  // namespace

FieldEdges findFieldEdges(const Sampler& sampler, const Lattice& lattice,
                          const HorizonScanParams& scan, const FieldEdgeParams& params,
                          VisionCounts& counts) {
  const EdgeFeatures features = edgeFeatures(sampler, horizonScan(lattice, scan), params);
  return edgeRows(fitEdgeLines(features, lattice.frame(), params, counts));
}

FieldEdges edgeRows(const EdgeLines& lines) {
  FieldEdges edges;
  for (const EdgeLine& line : lines) {
    if (line.ny > -kMinTilt) continue;
    edges.push_back(
        {rowAt(line, 0.0), rowAt(line, kImageWidth), static_cast<double>(line.support), line.rms});
  }
  return edges;
}

}  // namespace kelpie::vision

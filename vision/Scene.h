// SPDX-License-Identifier: Apache-2.0
// What every finder reads: the classified image, its blobs, the camera's place and the field.
#pragma once

#include <algorithm>
#include <cmath>

#include "robot/body/FieldDescription.h"
#include "robot/core/types/Percepts.h"
#include "vision/blobs/Blobs.h"
#include "vision/pixels/HorizonFrame.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

// The beacons and goals of one image.
constexpr std::size_t kMaxLandmarks = 8;
using Landmarks = FixedVector<LandmarkPercept, kMaxLandmarks>;

struct Scene {
  const Sampler& sampler;
  const BlobBuffer& blobs;
  const BodyState& body;
  const FixedVector<FieldEdgePercept, 3>& fieldEdges;
  HorizonFrame frame;
  const Lattice& lattice;
  const RunBuffer& runs;
  const body::FieldDescription& field;
};

// px
inline double focalLength(const Scene& scene) { return scene.body.camera.lens.focalLength; }

inline double horizonRow(const Scene& scene, double x) {
  const Horizon& h = scene.body.horizon;
  return h.atLeft + (h.atRight - h.atLeft) * x / kImageWidth;
}

inline double edgeRow(const FieldEdgePercept& e, double x) {
  return e.atLeft + (e.atRight - e.atLeft) * x / kImageWidth;
}

// The carpet is convex, so of several edges the lowest counts. Above the image without any.
inline double fieldEdgeRow(const FixedVector<FieldEdgePercept, 3>& edges, double x) {
  constexpr double kAboveImage = -1e6;  // px
  double row = kAboveImage;
  for (const FieldEdgePercept& e : edges) {
    const double here = edgeRow(e, x);
    row = here > row ? here : row;
  }
  return row;
}
inline double fieldEdgeRow(const Scene& scene, double x) {
  return fieldEdgeRow(scene.fieldEdges, x);
}

// Below it there is carpet, and what stands on it.
inline double carpetRow(const Scene& scene, double x) {
  return std::max(horizonRow(scene, x), fieldEdgeRow(scene, x));
}

// How far a pixel is below the horizon or the field edge, px along the level image's columns;
// negative above. Rows of a rolled image's line change by more than the way to it.
inline double belowHorizon(const Scene& scene, PixelPoint p) {
  return (p.y - horizonRow(scene, p.x)) * std::fabs(scene.frame.cos);
}
inline double belowFieldEdge(const Scene& scene, PixelPoint p) {
  return (p.y - fieldEdgeRow(scene, p.x)) * std::fabs(scene.frame.cos);
}

}  // namespace kelpie::vision

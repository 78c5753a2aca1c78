// SPDX-License-Identifier: Apache-2.0
// The ERS-7's camera: renders a Scene into an Image, column by column, each column from its own
// camera pose (the sensor exposes columns left to right over the frame time, facts-2005 section
// 2.1). Edges are anti-aliased: exact along a column, by `slices` cuts across it. The same scene,
// poses and random state give the same bytes on every machine.
#pragma once

#include <array>
#include <vector>

#include "tools/sim/Artefacts.h"
#include "tools/sim/Scene.h"
#include "tools/sim/Slice.h"

namespace kelpie::sim {

struct CameraParams {
  ArtefactParams artefacts;
  int slices = 3;              // cuts for each column
  bool texture = true;         // of the carpet
  double textureAmount = 5.0;  // grey levels, sd about a third of it
  bool light = true;           // the scene's second light, and stripes of the carpet

  static constexpr auto fields() {
    return fieldList(field("artefacts", &CameraParams::artefacts),
                     field("slices", &CameraParams::slices, "", 1, 16),
                     field("texture", &CameraParams::texture),
                     field("textureAmount", &CameraParams::textureAmount, "levels", 0, 30),
                     field("light", &CameraParams::light));
  }
};

// No artefacts, no texture, one light, 8 cuts: for measuring geometry.
CameraParams idealCamera();

// Whether an image of those cameras may show something inside a sphere.
bool mayShow(const ColumnCameras& cameras, const Sphere& sphere);

class Camera {
 public:
  Camera(const CameraParams& params, const RobotCamera& robot,
         const SharedTables& tables = makeRandomTables());

  void render(const Scene& scene, const ColumnCameras& cameras, Random& random, Image& image);

 private:
  struct Column : RawColumn {
    Channel carpet{};
  };
  void selectQuads(const Scene& scene, const ColumnCameras& cameras);
  void selectOwn(const Scene& scene, const ColumnCameras& cameras);
  void selectShapes(const Scene& scene, const FieldCamera& camera, double middle);
  void renderSlice(const Scene& scene, const Slice& slice);
  void collectSolids(const Scene& scene, const Slice& slice);
  void paintGround(const Scene& scene, const Slice& slice);
  void paint(const Span& span);
  void addTexture(const Slice& middle);
  void lightGround(const Scene& scene, const Slice& middle);
  void addSlice(float share);

  CameraParams params_;
  Artefacts artefacts_;
  SharedTables tables_;
  Column slice_;
  Column column_;
  struct InView {
    const Quad* shape;
    std::size_t first;  // column, and the last, that may show it
    std::size_t last;
  };
  std::vector<InView> view_;     // of solids, that the image may show
  std::vector<SeenQuad> quads_;  // of those, that may meet the column
  std::vector<const Cylinder*> beacons_;
  std::vector<InView> lineView_;
  std::vector<SeenQuad> lines_;
  Quad ground_;
  SeenQuad carpet_;
  std::vector<const Limb*> own_;  // that the image may show
  std::vector<Span> spans_;
  std::vector<const Span*> order_;  // far to near
};

}  // namespace kelpie::sim

// SPDX-License-Identifier: Apache-2.0
// The ERS-7's camera: renders a Scene into an Image, column by column, every two from their own
// camera pose (the sensor exposes columns left to right over the frame time, facts-2005 section
// 2.1). Edges are anti-aliased: exact along a column; across it by cuts on its borders, each of
// which two columns share, and where these show different things by halving the column. The same
// scene, poses and random state give the same bytes on every machine.
#pragma once

#include <array>
#include <vector>

#include "tools/sim/camera/Artefacts.h"
#include "tools/sim/camera/Scene.h"
#include "tools/sim/camera/Slice.h"

namespace kelpie::sim {

struct CameraParams {
  ArtefactParams artefacts;
  int splits = 1;         // how often a column is halved at most, and
  double maxSlope = 2.0;  // rows that an edge may run from cut to cut without; 0: always halved
  bool texture = true;    // of the carpet
  double textureAmount = 5.0;  // grey levels, sd about a third of it
  bool light = true;           // the scene's second light, and stripes of the carpet

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("artefacts", &CameraParams::artefacts),
                     field("splits", &CameraParams::splits, "", 0, 4),
                     field("maxSlope", &CameraParams::maxSlope, "rows", 0, 160),
                     field("texture", &CameraParams::texture),
                     field("textureAmount", &CameraParams::textureAmount, "levels", 0, 30),
                     field("light", &CameraParams::light));
  }
};

// No artefacts, no texture, one light, each column in eight parts: for measuring geometry.
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
  struct InView {
    const Quad* shape;
    Corners corners;
    std::size_t first;  // column, and the last, that may show it
    std::size_t last;
    // Any of the columns from there on.
    bool shows(std::size_t x, std::size_t count) const { return x + count > first && x <= last; }
  };
  void selectQuads(const Scene& scene, const ColumnCameras& cameras);
  void selectOwn(const Scene& scene, const ColumnCameras& cameras);
  static void selectBlock(const std::vector<InView>& all, std::size_t first,
                          std::vector<const InView*>& kept);
  // As a column's camera sees them: the first `count`, so that their places are used again.
  struct Seen {
    std::vector<SeenQuad> place;
    std::size_t count = 0;

    const SeenQuad* begin() const { return place.data(); }
    const SeenQuad* end() const { return place.data() + count; }
  };
  static void see(const FieldCamera& camera, std::size_t column,
                  const std::vector<const InView*>& all, Seen& seen);
  void selectShapes(const Scene& scene, const FieldCamera& camera, std::size_t x);
  struct Cut {
    std::vector<Span> shown;  // in the order of painting
    bool isPainted = false;
    Column painted;
  };
  void collectSolids(const Scene& scene, const Slice& slice, std::vector<Span>& shown);
  void collectGround(const Scene& scene, const Slice& slice, std::vector<Span>& shown);
  void look(const Scene& scene, const Slice& slice, Cut& cut);
  static void paint(const Scene& scene, Cut& cut);
  static void paint(const Span& span, Column& column);
  struct Stretch {
    Cut* left;
    Cut* right;
    double from;  // columns
    double to;
  };
  void mix(const Scene& scene, const FieldCamera& camera, Stretch between, int splits);
  void addTexture(const Slice& middle);
  void lightGround(const Scene& scene, const Slice& middle);
  void average(const Column& left, const Column& right);  // of a whole column
  void add(const Column& left, const Column& right, float share);

  CameraParams params_;
  Artefacts artefacts_;
  SharedTables tables_;
  std::array<Cut, 2> borders_;  // of the column; the left one of even columns first
  std::vector<Cut> middles_;    // one for each split
  Column column_;
  std::vector<InView> view_;  // of solids, that the image may show
  Seen quads_;                // of those, that may meet the column
  std::vector<const Cylinder*> beacons_;
  std::vector<InView> lineView_;
  std::vector<const InView*> blockView_;  // of those, that some columns beside each other may show
  std::vector<const InView*> blockLines_;
  Seen lines_;
  Quad ground_;
  SeenQuad carpet_;
  std::vector<const Limb*> own_;  // that the image may show
};

}  // namespace kelpie::sim

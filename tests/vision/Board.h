// SPDX-License-Identifier: Apache-2.0
// A carpet with coloured rectangles drawn pixel by pixel, and the scene around it: for checks that
// look at single pixels. No ring effect, no noise.
#pragma once

#include <memory>

#include "tests/vision/Painting.h"
#include "vision/Scene.h"

namespace kelpie::vision {

class Board {
 public:
  explicit Board(const CameraPose& camera = cameraAt(16, 0, -30)) : body(bodyOf(camera)) {
    fill(0, 0, kImageWidth, kImageHeight, kGreenPaint);
    sampler.reset();
  }

  // Columns [left, right), rows [top, bottom).
  void fill(int left, int top, int right, int bottom, const Paint& paint) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        image_->set(x, y,
                    {static_cast<std::uint8_t>(paint.y), static_cast<std::uint8_t>(paint.cr),
                     static_cast<std::uint8_t>(paint.cb)});
    sampler.reset();
  }

  Scene scene() const {
    return {sampler, *blobs_, body, edges, horizonFrameOf(body.camera), lattice_, *runs_, field};
  }

  BodyState body;
  FixedVector<FieldEdgePercept, 3> edges;
  body::FieldDescription field = *body::fieldDescription("2006");

 private:
  Lattice lattice_{horizonFrameOf(body.camera)};
  std::unique_ptr<Image> image_ = std::make_unique<Image>();
  std::unique_ptr<PixelTables> tables_ =
      std::make_unique<PixelTables>(*loadCalibration("nominal", "none"));
  std::unique_ptr<ClassMemory> classes_ = std::make_unique<ClassMemory>();
  std::unique_ptr<BlobBuffer> blobs_ = std::make_unique<BlobBuffer>();
  std::unique_ptr<RunBuffer> runs_ = std::make_unique<RunBuffer>();

 public:
  Sampler sampler{*image_, *tables_, *classes_};
};

}  // namespace kelpie::vision

// SPDX-License-Identifier: Apache-2.0
// How much of each object a view really shows: the scene is rendered again without artefacts and
// with the object in a colour of its own, and its pixels are counted. Only to
// compare with what vision says.
#pragma once

#include <functional>
#include <memory>

#include "tools/experiments/views/View.h"

namespace kelpie::experiments {

// Pixels inside the usable part of the image that show an object at least half.
struct Shown {
  int pixels = 0;
  PixelBox box;
};

class Visibility {
 public:
  Visibility();

  Shown ball(const View& view);
  Shown beacon(const View& view, std::size_t index);  // its coloured bands
  Shown goal(const View& view, std::size_t index);
  Shown robot(const View& view, std::size_t index);
  Shown uniform(const View& view, std::size_t index);  // of a robot, the coloured patches
  // The same as if nothing stood before it.
  Shown ballAlone(const View& view);
  Shown beaconAlone(const View& view, std::size_t index);
  Shown goalAlone(const View& view, std::size_t index);
  Shown robotAlone(const View& view, std::size_t index);

 private:
  Shown shown(const sim::Scene& scene, const View& view);

  sim::Camera camera_;
  std::unique_ptr<Image> image_;
  Random random_;
};

}  // namespace kelpie::experiments

// SPDX-License-Identifier: Apache-2.0
// The image turned about its middle so that up is up: u runs to the right along the horizon, v down
// from it, both in pixels, the same as x and y while the head is not rolled. The head's pan axis
// leans with the neck, so a look aside rolls the image by up to 70 deg; patches, columns and boxes
// are only upright here.
#pragma once

#include <algorithm>

#include "robot/body/Camera.h"
#include "robot/core/Geometry.h"
#include "robot/core/Percepts.h"
#include "vision/SpanWalk.h"

namespace kelpie::vision {

struct LevelPoint {
  double u = 0.0;
  double v = 0.0;
};

struct LevelBox {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  double middle() const { return 0.5 * (left + right); }
};

struct Level {
  double cos = 1.0;  // of the roll: the horizon's right is (cos, sin) in the image
  double sin = 0.0;

  PixelPoint toImage(LevelPoint p) const {
    const double u = p.u - body::kPrincipalX;
    const double v = p.v - body::kPrincipalY;
    return {body::kPrincipalX + cos * u - sin * v, body::kPrincipalY + sin * u + cos * v};
  }
  LevelPoint fromImage(PixelPoint p) const {
    const double x = p.x - body::kPrincipalX;
    const double y = p.y - body::kPrincipalY;
    return {body::kPrincipalX + cos * x + sin * y, body::kPrincipalY - sin * x + cos * y};
  }
  ImageUp up() const { return {sin, -cos}; }
  ImageUp right() const { return {cos, sin}; }
};

// Level where the camera looks so far up or down that the image has no up.
inline Level levelOf(const CameraPose& camera) {
  const ImageUp up = imageUp(camera);
  return {-up.dy, up.dx};
}

// The image box around a level one.
inline PixelBox imageBox(const Level& level, const LevelBox& box) {
  PixelBox around{1e9, 1e9, -1e9, -1e9};
  for (const double u : {box.left, box.right})
    for (const double v : {box.top, box.bottom}) {
      const PixelPoint p = level.toImage({u, v});
      around = {std::min(around.left, p.x), std::min(around.top, p.y), std::max(around.right, p.x),
                std::max(around.bottom, p.y)};
    }
  return around;
}

}  // namespace kelpie::vision

// SPDX-License-Identifier: Apache-2.0
// The camera's roll: what is up, what is right and what is as high as the camera in the image.
// Level coordinates are those of the image turned about its middle until up is up: u runs to the
// right along the horizon, v down from it, both in pixels, the same as x and y while the head is
// not rolled. The head's pan axis leans with the neck, so a look to the side rolls the image by up
// to 70 deg; patches, columns and boxes are only upright in level coordinates. From the camera's
// axes, not from the horizon's two rows, which are clamped and say nothing when the horizon is
// upright.
#pragma once

#include <algorithm>

#include "robot/body/Camera.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::vision {

// A unit vector in the image.
struct ImageDirection {
  double dx = 0.0;
  double dy = -1.0;

  ImageDirection operator-() const { return {-dx, -dy}; }
};

inline PixelPoint moved(PixelPoint from, ImageDirection direction, double length) {
  return {from.x + length * direction.dx, from.y + length * direction.dy};
}

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

// px, outside any image: where a box begins that nothing is in yet.
constexpr double kFarOutside = 1e9;
inline constexpr LevelBox kEmptyLevelBox{kFarOutside, kFarOutside, -kFarOutside, -kFarOutside};
inline constexpr PixelBox kEmptyPixelBox{kFarOutside, kFarOutside, -kFarOutside, -kFarOutside};

struct HorizonFrame {
  double cos = 1.0;  // of the roll
  double sin = 0.0;
  double middleAbove = 0.0;  // px that the principal point is above the horizon, within 1e4
  Lens lens;

  ImageDirection up() const { return {sin, -cos}; }
  ImageDirection right() const { return {cos, sin}; }
  // px above the horizon
  double above(PixelPoint p) const {
    return middleAbove + sin * (p.x - lens.principalX) - cos * (p.y - lens.principalY);
  }
  // px along the horizon, counted from where the image's origin lies
  double along(PixelPoint p) const { return cos * p.x + sin * p.y; }
  // The pixel that is so far to the right and above another one, as in an upright image.
  PixelPoint beside(PixelPoint from, double right, double above) const {
    return {from.x + right * cos + above * sin, from.y + right * sin - above * cos};
  }
  PixelPoint toImage(LevelPoint p) const {
    const double u = p.u - lens.principalX;
    const double v = p.v - lens.principalY;
    return {lens.principalX + cos * u - sin * v, lens.principalY + sin * u + cos * v};
  }
  LevelPoint fromImage(PixelPoint p) const {
    const double x = p.x - lens.principalX;
    const double y = p.y - lens.principalY;
    return {lens.principalX + cos * x + sin * y, lens.principalY - sin * x + cos * y};
  }
};

// Not rolled where the camera looks so far up or down that the image has no up.
HorizonFrame horizonFrameOf(const CameraPose& camera);

// The image box around a level one.
inline PixelBox imageBox(const HorizonFrame& frame, const LevelBox& box) {
  PixelBox around = kEmptyPixelBox;
  for (const double u : {box.left, box.right})
    for (const double v : {box.top, box.bottom}) {
      const PixelPoint p = frame.toImage({u, v});
      around = {std::min(around.left, p.x), std::min(around.top, p.y), std::max(around.right, p.x),
                std::max(around.bottom, p.y)};
    }
  return around;
}

}  // namespace kelpie::vision

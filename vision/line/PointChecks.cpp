// SPDX-License-Identifier: Apache-2.0
#include "vision/line/PointChecks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "robot/body/Camera.h"
#include "vision/ElevationDoubt.h"

namespace kelpie::vision {
namespace {

bool inBox(const PixelBox& box, PixelPoint p, double margin) {
  return p.x >= box.left - margin && p.x <= box.right + margin && p.y >= box.top - margin &&
         p.y <= box.bottom + margin;
}

bool isGreen(const Sampler& sampler, int px, int py) {
  return Sampler::usable(px, py) && sampler.classAt(px, py) == ColourClass::green;
}

bool isGreen(const Sampler& sampler, const GridLine& gridLine, int i, int offset = 0) {
  return isGreen(sampler, gridLine.column(i, offset), gridLine.row(i, offset));
}

// Two greens in a row, next to the bright pixels or after one pixel of another class.
bool twoGreens(const Sampler& sampler, const GridLine& gridLine, int i, int step) {
  if (!isGreen(sampler, gridLine, i + step)) return false;
  return isGreen(sampler, gridLine, i) || isGreen(sampler, gridLine, i + 2 * step);
}

// Pixels that a centimetre square to the ray fills where the pixel's ray meets the ground.
double pixelsPerCm(const CameraPose& camera, PixelPoint pixel) {
  const Point3<Robot> ray = body::rayThrough(camera, pixel);
  return camera.lens.focalLength * std::max(-ray.z, 0.0) / camera.position.z;
}

// Where the border's upper edge is above a foot. Seen from inside the field the border leans away:
// its upper edge is as much farther as higher.
std::optional<PixelPoint> borderTop(const CameraPose& camera, PixelPoint pixel, double height) {
  const auto foot = body::groundPoint(camera, pixel);
  if (!foot) return std::nullopt;
  const Point2<Robot> way{foot->x - camera.position.x, foot->y - camera.position.y};
  const double share = 1.0 + height / std::max(way.norm(), 1.0);
  return body::project(
      camera, {camera.position.x + way.x * share, camera.position.y + way.y * share, height});
}

double widthTolerance(const GroundWidth& width, double lineWidth, const LinePointParams& p) {
  return (p.widthTolerance + width.doubt) * lineWidth + p.widthSlack * width.perPixel;
}

// Widths on the ground grow with the square of its distance, which is camera height over slope.
double widthDoubt(const CameraPose& camera, Point2<Robot> place) {
  const Point2<Robot> way{place.x - camera.position.x, place.y - camera.position.y};
  const double d = std::max(way.norm(), 1.0);
  const GroundRay ray{way.x / d, way.y / d, 0.0};
  return 2.0 * elevationDoubt(camera, ray).slack() * d / camera.position.z;
}

}  // namespace

bool headIsSlow(const BodyState& body, const LinePointParams& p) {
  return body.headSpeed < p.maxHeadSpeed.rad();
}

bool pointIsBelowHorizon(const Scene& scene, PixelPoint pixel) {
  return pixel.y > carpetRow(scene, pixel.x);
}

bool pointIsOutsideCorners(PixelPoint pixel, const LinePointParams& p) {
  const double lateral = std::min(pixel.x, kImageWidth - pixel.x);
  return lateral + std::min(pixel.y, kImageHeight - pixel.y) >= p.cornerBuffer;
}

bool pointIsOutsideObjects(const Percepts& seen, PixelPoint pixel, const LinePointParams& p) {
  const BallPercept& ball = seen.ball;
  const double r = ball.radius;
  const PixelBox around{ball.centre.x - r, ball.centre.y - r, ball.centre.x + r, ball.centre.y + r};
  if (ball.present && inBox(around, pixel, p.objectMargin)) return false;
  for (const auto& robot : seen.robots)
    if (inBox(robot.box, pixel, p.objectMargin)) return false;
  return true;
}

bool lineIsBetweenGreen(const Sampler& sampler, const LineCandidate& c) {
  return twoGreens(sampler, c.gridLine, c.segment.first, -1) &&
         twoGreens(sampler, c.gridLine, c.segment.last, 1);
}

bool lineIsColourless(const Sampler& sampler, const LineCandidate& c, const LinePointParams& p) {
  const int middle = static_cast<int>(c.segment.middle() + 0.5);
  const Yuv in = sampler.corrected(c.gridLine.column(middle), c.gridLine.row(middle));
  const int last = c.segment.last;
  const Yuv out = sampler.corrected(c.gridLine.column(last), c.gridLine.row(last));
  return std::abs(in.cr - out.cr) <= p.maxChroma && std::abs(in.cb - out.cb) <= p.maxChroma;
}

bool lineIsNarrow(const GroundWidth& width, double lineWidth, const LinePointParams& p) {
  return width.paint - lineWidth <= widthTolerance(width, lineWidth, p);
}

bool lineIsWide(const GroundWidth& width, double lineWidth, const LinePointParams& p) {
  return lineWidth - width.paint <= widthTolerance(width, lineWidth, p);
}

bool borderIsAfterGreen(const Sampler& sampler, const GridLine& gridLine, const RisingEdge& edge) {
  return twoGreens(sampler, gridLine, edge.first, -1);
}

bool borderIsLong(const Scene& scene, const GridLine& gridLine, const RisingEdge& edge,
                  const LinePointParams& p) {
  const double flat =
      2.0 * scene.field.lineWidth * pixelsPerCm(scene.body.camera, gridLine.at(edge.foot));
  const int end = edge.last + static_cast<int>(std::max(p.borderMin, flat));
  int i = edge.last;
  for (; i <= end && Sampler::usable(gridLine.column(i), gridLine.row(i)); ++i) {
    if (isGreen(scene.sampler, gridLine, i)) return false;
  }
  return i - edge.last >= flat;
}

bool borderIsHigh(const Scene& scene, const GridLine& gridLine, const RisingEdge& edge,
                  const LinePointParams& p) {
  const PixelPoint foot = gridLine.at(edge.last);
  const auto top = borderTop(scene.body.camera, foot, scene.field.borderWidth);
  if (!top) return false;
  const double dx = top->x - foot.x;
  const double dy = top->y - foot.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  const int needed = static_cast<int>(p.borderShare * length);
  int white = 0;
  int seen = 0;
  for (; seen < needed; ++seen) {
    const PixelPoint at{foot.x + dx * seen / length, foot.y + dy * seen / length};
    if (!Sampler::usable(at)) break;
    white += scene.sampler.classAt(at) == ColourClass::white ? 1 : 0;
  }
  return needed >= 2 && white >= p.borderWhite * seen;
}

bool borderGoesOn(const Sampler& sampler, const GridLine& gridLine, const RisingEdge& edge,
                  const LinePointParams& p) {
  const int reach = static_cast<int>(p.borderReach);
  const auto left = edgeBeside(sampler, gridLine, edge, -reach);
  const auto right = edgeBeside(sampler, gridLine, edge, reach);
  if (!left && !right) return false;
  if (left && right) return std::fabs(*left + *right - 2.0 * edge.foot) <= p.borderBend;
  const int missing = left ? reach : -reach;  // allowed beyond the rim only
  return !Sampler::usable(gridLine.column(edge.first, missing), gridLine.row(edge.first, missing));
}

bool borderHasSide(const Scene& scene, const GridLine& gridLine, const RisingEdge& edge,
                   const LinePointParams& p) {
  const double flat =
      2.0 * scene.field.lineWidth * pixelsPerCm(scene.body.camera, gridLine.at(edge.foot));
  const int length = static_cast<int>(std::max(p.borderSide, flat));
  for (const int side : {-1, 1}) {
    int green = 0;
    for (int k = 1; k <= length; ++k)
      green += isGreen(scene.sampler, gridLine, edge.last, side * k) ? 1 : 0;
    if (green == 0) return true;
  }
  return false;
}

bool fieldIsEven(const Sampler& sampler, PixelPoint pixel, const LinePointParams& p) {
  const int px = Sampler::pixelOf(pixel.x);
  const int py = Sampler::pixelOf(pixel.y);
  constexpr int kBlurReach = 4;  // px, beyond the blur of a thin line
  if (!Sampler::usable(px, py - kBlurReach) || !Sampler::usable(px, py + kBlurReach)) return true;
  const int around = sampler.rawY(px, py - kBlurReach) + sampler.rawY(px, py + kBlurReach);
  const int here = sampler.rawY(px, py - 1) + sampler.rawY(px, py) + sampler.rawY(px, py + 1);
  return here / 3.0 - around / 2.0 <= p.fieldBump;
}

bool fieldIsGreenBeside(const Sampler& sampler, PixelPoint pixel, const LinePointParams& p) {
  const int px = Sampler::pixelOf(pixel.x);
  const int py = Sampler::pixelOf(pixel.y);
  int other = 0;
  for (int k = 1; k <= p.fieldSide; ++k) {
    for (const int x : {px - k, px + k})
      other += Sampler::usable(x, py) && !isGreen(sampler, x, py) ? 1 : 0;
  }
  return other <= p.fieldMaxOther;
}

std::optional<GroundWidth> widthOnGround(const CameraPose& camera, const LineCandidate& c,
                                         PixelPoint a, PixelPoint b) {
  const auto one = body::groundPoint(camera, a);
  const auto other = body::groundPoint(camera, b);
  const auto from = body::groundPoint(camera, c.gridLine.at(c.segment.from));
  const auto to = body::groundPoint(camera, c.gridLine.at(c.segment.to));
  if (!one || !other || !from || !to) return std::nullopt;
  const Point2<Robot> along = *other - *one;
  const Point2<Robot> across = *to - *from;
  const double length = along.norm();
  const double pixels = c.segment.to - c.segment.from;
  constexpr double kMinLength = 1e-6;  // cm and px
  if (length < kMinLength || pixels < kMinLength) return std::nullopt;
  const double perPixel = std::fabs(along.x * across.y - along.y * across.x) / (length * pixels);
  return GroundWidth{perPixel, perPixel * c.segment.paint, widthDoubt(camera, *from)};
}

}  // namespace kelpie::vision

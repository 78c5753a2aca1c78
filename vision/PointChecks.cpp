// SPDX-License-Identifier: Apache-2.0
#include "vision/PointChecks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "robot/body/Camera.h"

namespace kelpie::vision {
namespace {

bool inBox(const PixelBox& box, PixelPoint p, double margin) {
  return p.x >= box.left - margin && p.x <= box.right + margin && p.y >= box.top - margin &&
         p.y <= box.bottom + margin;
}

bool isGreen(const Sampler& sampler, int px, int py) {
  return Sampler::usable(px, py) && sampler.classAt(px, py) == ColourClass::green;
}

bool isGreen(const Sampler& sampler, const Scan& scan, int i, int aside = 0) {
  return isGreen(sampler, scan.column(i, aside), scan.row(i, aside));
}

// Two greens in a row, next to the bright pixels or after one odd pixel.
bool twoGreens(const Sampler& sampler, const Scan& scan, int i, int step) {
  if (!isGreen(sampler, scan, i + step)) return false;
  return isGreen(sampler, scan, i) || isGreen(sampler, scan, i + 2 * step);
}

}  // namespace

bool headIsSlow(const BodyState& body, const LineParams& p) {
  return body.headSpeed < p.maxHeadSpeed.rad();
}

bool pointIsBelowHorizon(const Scene& scene, PixelPoint pixel) {
  return pixel.y > std::max(horizonRow(scene, pixel.x), fieldEdgeRow(scene, pixel.x));
}

bool pointIsOutsideCorners(PixelPoint pixel, const LineParams& p) {
  const double aside = std::min(pixel.x, kImageWidth - pixel.x);
  return aside + std::min(pixel.y, kImageHeight - pixel.y) >= p.cornerBuffer;
}

bool pointIsOutsideObjects(const Percepts& seen, PixelPoint pixel, const LineParams& p) {
  const BallPercept& ball = seen.ball;
  const double r = ball.radius;
  const PixelBox around{ball.centre.x - r, ball.centre.y - r, ball.centre.x + r, ball.centre.y + r};
  if (ball.present && inBox(around, pixel, p.objectMargin)) return false;
  for (const auto& robot : seen.robots)
    if (inBox(robot.box, pixel, p.objectMargin)) return false;
  for (const auto& landmark : seen.landmarks)
    if (inBox(landmark.box, pixel, p.objectMargin)) return false;
  return true;
}

bool lineIsBetweenGreen(const Sampler& sampler, const LineCandidate& c) {
  return twoGreens(sampler, c.scan, c.stretch.first, -1) &&
         twoGreens(sampler, c.scan, c.stretch.last, 1);
}

bool lineIsColourless(const Sampler& sampler, const LineCandidate& c, const LineParams& p) {
  const int middle = static_cast<int>(c.stretch.middle() + 0.5);
  const Yuv in = sampler.corrected(c.scan.column(middle), c.scan.row(middle));
  const int last = c.stretch.last;
  const Yuv out = sampler.corrected(c.scan.column(last), c.scan.row(last));
  return std::abs(in.cr - out.cr) <= p.maxChroma && std::abs(in.cb - out.cb) <= p.maxChroma;
}

bool lineHasWidth(const GroundWidth& width, const LineParams& p) {
  const double slack = p.widthTolerance * p.lineWidth + p.widthSlack * width.perPixel;
  return std::fabs(width.paint - p.lineWidth) <= slack;
}

bool borderIsLong(const Sampler& sampler, const Scan& scan, int foot, const LineParams& p) {
  int white = 0;
  for (int k = 1; k <= p.borderMin; ++k) {
    const int i = foot + k;
    if (!Sampler::usable(scan.column(i), scan.row(i))) break;
    const ColourClass c = sampler.classAt(scan.column(i), scan.row(i));
    if (c == ColourClass::green) return false;
    white += c == ColourClass::white ? 1 : 0;
  }
  return white >= 2;
}

bool borderHasSide(const Sampler& sampler, const Scan& scan, int foot, const LineParams& p) {
  for (const int side : {-1, 1}) {
    int green = 0;
    for (int k = 1; k <= p.borderSide; ++k) green += isGreen(sampler, scan, foot + 1, side * k);
    if (green == 0) return true;
  }
  return false;
}

bool fieldIsGreenBeside(const Sampler& sampler, PixelPoint pixel, const LineParams& p) {
  const int px = Sampler::pixelOf(pixel.x);
  const int py = Sampler::pixelOf(pixel.y);
  int other = 0;
  for (int k = 1; k <= p.fieldSide; ++k) {
    for (const int x : {px - k, px + k})
      other += Sampler::usable(x, py) && !isGreen(sampler, x, py) ? 1 : 0;
  }
  return other <= p.fieldMaxOther;
}

// The line runs from the middle of one neighbour to that of the other.
std::optional<GroundWidth> widthOnGround(const CameraPose& camera, const LineCandidate& c,
                                         const Beside& left, const Beside& right, int reach) {
  const auto a = body::groundPoint(camera, c.scan.at(left.middle(), -reach));
  const auto b = body::groundPoint(camera, c.scan.at(right.middle(), reach));
  const auto from = body::groundPoint(camera, c.scan.at(c.stretch.from));
  const auto to = body::groundPoint(camera, c.scan.at(c.stretch.to));
  if (!a || !b || !from || !to) return std::nullopt;
  const Point2<Robot> along = *b - *a;
  const Point2<Robot> across = *to - *from;
  const double length = along.norm();
  const double pixels = c.stretch.to - c.stretch.from;
  if (length < 1e-6 || pixels < 1e-6) return std::nullopt;
  const double perPixel = std::fabs(along.x * across.y - along.y * across.x) / (length * pixels);
  return GroundWidth{perPixel, perPixel * c.stretch.paint};
}

}  // namespace kelpie::vision

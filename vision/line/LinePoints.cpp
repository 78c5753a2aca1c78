// SPDX-License-Identifier: Apache-2.0
#include "vision/line/LinePoints.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "robot/core/Maths.h"
#include "vision/Refusal.h"
#include "vision/line/PointChecks.h"

namespace kelpie::vision {
namespace {

constexpr int kFieldStep = 2;  // px; every second pixel tells green as well, at half the cost

struct Finder {
  const Scene& scene;
  const LinePointParams& params;
  Percepts& out;

  void refused(Refusal reason) const { refuse(out.counts, reason); }
};

int firstRowBelow(double limit) {
  return static_cast<int>(maths::clamp(limit + 1.0, kUsableTop * 1.0, kImageHeight * 1.0));
}

int highestRow(const Scene& scene, int px) { return firstRowBelow(carpetRow(scene, px)); }

bool keepsAnyPoint(const Finder& f, PixelPoint pixel) {
  if (!pointIsOutsideCorners(pixel, f.params)) {
    f.refused(Refusal::lineInCorner);
    return false;
  }
  if (!pointIsOutsideObjects(f.out, pixel, f.params)) {
    f.refused(Refusal::lineInObject);
    return false;
  }
  return true;
}

void addPoint(const Finder& f, LinePointKind kind, PixelPoint pixel) {
  const auto place = body::groundPoint(f.scene.body.camera, pixel);
  const double weight = place ? pointWeight(kind, place->norm(), f.params) : 0.0;
  if (weight <= 0.0) return f.refused(Refusal::pointTooFar);
  if (!f.out.linePoints.push_back({kind, *place, weight, pixel})) f.refused(Refusal::bufferFull);
}

struct Ends {
  PixelPoint a;
  PixelPoint b;
};

// Where the line goes on to both sides; at the rim of the image one side must do.
std::optional<Ends> endsBeside(const Finder& f, const LineCandidate& c) {
  const int reach = static_cast<int>(f.params.besideReach);
  Ends ends{c.pixel, c.pixel};
  for (const int side : {-reach, reach}) {
    if (!hasBeside(c.gridLine, c.segment, side)) continue;
    const auto beside = segmentBeside(f.scene.sampler, c.gridLine, c.segment, side);
    if (!beside) return std::nullopt;
    (side < 0 ? ends.a : ends.b) = c.gridLine.at(beside->middle(), side);
  }
  return ends;
}

void checkLine(const Finder& f, const LineCandidate& c) {
  const Sampler& sampler = f.scene.sampler;
  if (!pointIsBelowHorizon(f.scene, c.pixel)) return;
  if (c.segment.top - c.segment.base < f.params.minContrast) return f.refused(Refusal::lineTooDim);
  if (!lineIsBetweenGreen(sampler, c)) return f.refused(Refusal::lineNotInGreen);
  if (!lineIsColourless(sampler, c, f.params)) return f.refused(Refusal::lineColoured);
  if (!keepsAnyPoint(f, c.pixel)) return;
  const auto ends = endsBeside(f, c);
  if (!ends) return f.refused(Refusal::lineGreenBeside);
  const auto width = widthOnGround(f.scene.body.camera, c, ends->a, ends->b);
  if (!width || !lineIsNarrow(*width, f.scene.field.lineWidth, f.params))
    return f.refused(Refusal::lineAmbiguous);
  if (!lineIsWide(*width, f.scene.field.lineWidth, f.params))
    return f.refused(Refusal::lineTooThin);
  addPoint(f, LinePointKind::line, c.pixel);
}

void checkLines(const Finder& f, const GridLine& gridLine, BrightSegments& segments) {
  findBrightSegments(f.scene.sampler, gridLine, f.params, segments);
  for (const BrightSegment& s : segments) checkLine(f, {gridLine, s, gridLine.at(s.middle())});
}

void findLines(const Finder& f) {
  BrightSegments segments;
  for (int px = kGridLeft; px < kUsableRight; px += kGridSpacing)
    checkLines(f, gridLineUp(px, highestRow(f.scene, px)), segments);
  for (int py = kGridTop; py < kUsableBottom; py += kGridSpacing) {
    if (py < highestRow(f.scene, 0) && py < highestRow(f.scene, kImageWidth)) continue;
    checkLines(f, gridLineRight(py), segments);
  }
}

void checkBorder(const Finder& f, const GridLine& gridLine, const RisingEdge& edge) {
  const Sampler& sampler = f.scene.sampler;
  const PixelPoint pixel = gridLine.at(edge.foot);
  if (pixel.y <= horizonRow(f.scene, pixel.x)) return;
  if (!borderIsAfterGreen(sampler, gridLine, edge)) return;
  if (!borderIsLong(f.scene, gridLine, edge, f.params)) return;
  if (!borderIsHigh(f.scene, gridLine, edge, f.params)) return f.refused(Refusal::borderTooShort);
  if (!borderGoesOn(sampler, gridLine, edge, f.params)) return f.refused(Refusal::borderBent);
  if (!borderHasSide(f.scene, gridLine, edge, f.params))
    return f.refused(Refusal::borderGreenBeside);
  if (keepsAnyPoint(f, pixel)) addPoint(f, LinePointKind::border, pixel);
}

void checkBorders(const Finder& f, const GridLine& gridLine) {
  for (const RisingEdge& edge : risingEdges(f.scene.sampler, gridLine, f.params))
    checkBorder(f, gridLine, edge);
}

// The foot of the border is its lower edge, and the edge nearer to the middle of the image. The
// field edge does not bound these grid lines: it is the foot itself.
void findBorders(const Finder& f) {
  for (int px = kGridLeft; px < kUsableRight; px += kGridSpacing)
    checkBorders(f, gridLineUp(px, firstRowBelow(horizonRow(f.scene, px))));
  const double highest = std::min(f.scene.body.horizon.atLeft, f.scene.body.horizon.atRight);
  for (int py = kGridTop; py < kUsableBottom; py += kGridSpacing) {
    if (py < highest) continue;
    checkBorders(f, gridLineOut(py, -1));
    checkBorders(f, gridLineOut(py, 1));
  }
}

void checkField(const Finder& f, PixelPoint pixel) {
  if (!keepsAnyPoint(f, pixel)) return;
  if (!fieldIsEven(f.scene.sampler, pixel, f.params)) return f.refused(Refusal::fieldUneven);
  if (!fieldIsGreenBeside(f.scene.sampler, pixel, f.params))
    return f.refused(Refusal::fieldNotGreen);
  addPoint(f, LinePointKind::field, pixel);
}

// Cuts the green runs of a grid line into field intervals; the middle of each is a point.
void findFieldPoints(const Finder& f, int px) {
  const double horizon = horizonRow(f.scene, px + 0.5);
  const int highest = highestRow(f.scene, px);
  const CameraPose& camera = f.scene.body.camera;
  int lowest = kUsableBottom;
  for (int py = kUsableBottom - 1; py >= highest; py -= kFieldStep) {
    if (f.scene.sampler.classAt(px, py) != ColourClass::green) {
      lowest = py;
    } else if (lowest - py >= fieldInterval(0.5 * (py + lowest) - horizon, camera, f.params)) {
      checkField(f, {px + 0.5, 0.5 * (py + lowest) + 0.5});
      lowest = py;
    }
  }
}

void dropFew(const Finder& f, LinePointKind kind) {
  auto& points = f.out.linePoints;
  std::size_t count = 0;
  for (const LinePoint& p : points) count += p.kind == kind ? 1 : 0;
  if (static_cast<double>(count) >= f.params.minOfKind) return;
  std::size_t kept = 0;
  for (const LinePoint& p : points) {
    if (p.kind == kind) {
      f.refused(Refusal::pointsTooFew);
    } else {
      points[kept++] = p;
    }
  }
  points.resize(kept);
}

}  // namespace

double pointWeight(LinePointKind kind, double distance, const LinePointParams& p) {
  if (kind == LinePointKind::field) return distance <= p.noWeight ? 1.0 : 0.0;
  const double d = p.linearWeight ? distance : distance * distance;
  const double near = p.linearWeight ? p.fullWeight : p.fullWeight * p.fullWeight;
  const double far = p.linearWeight ? p.noWeight : p.noWeight * p.noWeight;
  return maths::clamp((far - d) / (far - near), 0.0, 1.0);
}

double fieldInterval(double rows, const CameraPose& camera, const LinePointParams& p) {
  const double even = p.fieldSpacing * rows * rows / (camera.position.z * camera.lens.focalLength);
  return maths::clamp(even, p.minFieldInterval, p.maxFieldInterval);
}

void findLinePoints(const Scene& scene, const LinePointParams& params, Percepts& out) {
  if (!headIsSlow(scene.body, params)) return;
  const Finder f{scene, params, out};
  findLines(f);
  if (scene.field.borderWidth > 0.0) findBorders(f);
  for (int px = kGridLeft; px < kUsableRight; px += kFieldGridSpacing) findFieldPoints(f, px);
  for (const auto kind : {LinePointKind::line, LinePointKind::border, LinePointKind::field})
    dropFew(f, kind);
}

}  // namespace kelpie::vision

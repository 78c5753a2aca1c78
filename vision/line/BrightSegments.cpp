// SPDX-License-Identifier: Apache-2.0
#include "vision/line/BrightSegments.h"

#include <algorithm>

#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

constexpr int kEdgeWidth = 2;  // px over which a blurred edge rises

// The brightness along a grid line, read in place.
struct Profile {
  const std::uint8_t* y;
  int step;
  int length;

  int operator[](int i) const { return y[i * step]; }
};

Profile profileOf(const Sampler& sampler, const GridLine& gridLine) {
  const std::uint8_t* first = sampler.rawY().data() + Image::at(gridLine.px, gridLine.py);
  return {first, gridLine.dy * kImageWidth + gridLine.dx, gridLine.length};
}

// The next place from i on where the brightness changes by `minStep`, or the end.
int nextStep(const Profile& y, int i, int minStep) {
  const int ahead = kEdgeWidth * y.step;
  const auto flat = static_cast<unsigned>(2 * minStep - 1);
  const std::uint8_t* p = y.y + i * y.step;
  for (; i + kEdgeWidth + 1 < y.length; ++i, p += y.step)
    if (static_cast<unsigned>(p[ahead] - p[0] + minStep - 1) >= flat) break;
  return i;
}

// Where a straight line from (i, a) to (i + 1, b) passes `level`; the nearer end when both are on
// one side of it, as where the pixel beside a segment is itself half bright.
double passes(int i, double a, double b, double level) {
  return a == b ? i + 0.5 : i + maths::clamp((level - a) / (b - a), 0.0, 1.0);
}

double halfUp(const Profile& y, int first, int last, double level) {
  int i = first;
  while (i + 1 < last && y[i + 1] < level) ++i;
  return passes(i, y[i], y[i + 1], level);
}

double halfDown(const Profile& y, int first, int last, double level) {
  int i = last;
  while (i - 1 > first && y[i - 1] < level) --i;
  return passes(i - 1, y[i - 1], y[i], level);
}

// Full paint is at least `whiteOverGreen` times as bright as the carpet beside it, so that a line
// narrower than a pixel has its true width.
BrightSegment measured(const Profile& y, int first, int last, double whiteOverGreen) {
  BrightSegment s{first, last};
  const double before = 0.5 * (y[first] + y[first - 1]);
  const double after = 0.5 * (y[last] + y[last + 1]);
  s.base = 0.5 * (before + after);
  double sum = 0.0;
  for (int i = first + 1; i < last; ++i) {
    s.top = std::max(s.top, static_cast<double>(y[i]));
    sum += y[i] - s.base;
  }
  s.from = halfUp(y, first, last, 0.5 * (before + s.top));
  s.to = halfDown(y, first, last, 0.5 * (after + s.top));
  s.paint = sum / std::max(s.top - s.base, (whiteOverGreen - 1.0) * s.base + 1.0);
  return s;
}

// The pixels beside the grid line, as far as the image goes: the grid line itself is usable from
// end to end, so its lane is so where its first pixel is.
struct Lane {
  Profile profile;

  bool inside(int i) const { return i >= 0 && i < profile.length; }
  int y(int i) const { return profile[i]; }
};

Lane laneOf(const Sampler& sampler, const GridLine& gridLine, int offset) {
  const int px = gridLine.column(0, offset);
  const int py = gridLine.row(0, offset);
  if (!Sampler::usable(px, py)) return {{nullptr, 0, 0}};
  return {profileOf(sampler, {px, py, gridLine.dx, gridLine.dy, gridLine.length})};
}

struct PixelRange {
  int first = 0;  // first and last bright pixel
  int last = 0;
  bool found = false;
};

PixelRange follow(const Lane& lane, PixelRange before, double level, int longest) {
  PixelRange now;
  for (int i = before.first - 1; i <= before.last + 1 && !now.found; ++i) {
    if (lane.inside(i) && lane.y(i) >= level) now = {i, i, true};
  }
  if (!now.found) return now;
  while (now.last - now.first < longest && lane.inside(now.first - 1) &&
         lane.y(now.first - 1) >= level)
    --now.first;
  while (now.last - now.first < longest && lane.inside(now.last + 1) &&
         lane.y(now.last + 1) >= level)
    ++now.last;
  const bool ends = lane.inside(now.first - 1) && lane.inside(now.last + 1);
  now.found = ends && now.last - now.first < longest;
  return now;
}

// The end of a run of rising (sign 1) or falling (-1) steps that begins at i.
int lastStep(const Profile& y, int i, int sign, int minStep) {
  while (i + kEdgeWidth + 2 < y.length && sign * (y[i + kEdgeWidth + 1] - y[i + 1]) >= minStep) ++i;
  return i;
}

}  // namespace

GridLine gridLineOut(int py, int dx) {
  const int from = kImageWidth / 2;
  return {from, py, dx, 0, dx > 0 ? kUsableRight - from : from - kUsableLeft + 1};
}

GridLine gridLineUp(int px, int highest) {
  return {px, kUsableBottom - 1, 0, -1, std::max(kUsableBottom - highest, 0)};
}

GridLine gridLineRight(int py) { return {kUsableLeft, py, 1, 0, kUsableRight - kUsableLeft}; }

void findBrightSegments(const Sampler& sampler, const GridLine& gridLine,
                        const LinePointParams& params, BrightSegments& found) {
  found.clear();
  const Profile y = profileOf(sampler, gridLine);
  const int minStep = static_cast<int>(params.minStep);
  int first = -1;
  for (int i = nextStep(y, 1, minStep); i + kEdgeWidth + 1 < y.length;
       i = nextStep(y, i + 1, minStep)) {
    const int step = y[i + kEdgeWidth] - y[i];
    if (step >= minStep) {
      first = i;
      i = lastStep(y, i, 1, minStep);
    } else if (step <= -minStep && first >= 0) {
      i = lastStep(y, i, -1, minStep);
      const int last = i + kEdgeWidth;
      if (last - first <= params.maxSegment)
        found.push_back(measured(y, first, last, params.whiteOverGreen));
      first = -1;
    }
  }
}

BrightSegments brightSegments(const Sampler& sampler, const GridLine& gridLine,
                              const LinePointParams& params) {
  BrightSegments found;
  findBrightSegments(sampler, gridLine, params, found);
  return found;
}

RisingEdges risingEdges(const Sampler& sampler, const GridLine& gridLine,
                        const LinePointParams& params) {
  const Profile y = profileOf(sampler, gridLine);
  const int minStep = static_cast<int>(params.minStep);
  RisingEdges found;
  for (int i = nextStep(y, 1, minStep); i + kEdgeWidth + 1 < y.length;
       i = nextStep(y, i + 1, minStep)) {
    if (y[i + kEdgeWidth] - y[i] < minStep) continue;
    const int first = i;
    i = lastStep(y, i, 1, minStep);
    const int last = i + kEdgeWidth;
    const double level = 0.5 * (0.5 * (y[first] + y[first - 1]) + y[last]);
    found.push_back({first, last, halfUp(y, first, last + 1, level), level});
  }
  return found;
}

std::optional<double> edgeBeside(const Sampler& sampler, const GridLine& gridLine,
                                 const RisingEdge& edge, int offset) {
  constexpr int kMaxShift = 4;  // px that the edge may move from one neighbour to the next
  const int step = offset > 0 ? 1 : -1;
  int dark = static_cast<int>(edge.foot);  // the last pixel below the level
  for (int k = step; k != offset + step; k += step) {
    const Lane lane = laneOf(sampler, gridLine, k);
    if (!lane.inside(dark - kMaxShift) || !lane.inside(dark + kMaxShift + 1)) return std::nullopt;
    dark -= kMaxShift;
    if (lane.y(dark) >= edge.level) return std::nullopt;
    const int end = dark + 2 * kMaxShift;
    while (dark <= end && lane.y(dark + 1) < edge.level) ++dark;
    if (dark > end) return std::nullopt;
  }
  const Lane lane = laneOf(sampler, gridLine, offset);
  return passes(dark, lane.y(dark), lane.y(dark + 1), edge.level);
}

bool hasBeside(const GridLine& gridLine, const BrightSegment& segment, int offset) {
  return Sampler::usable(gridLine.column(segment.first, offset),
                         gridLine.row(segment.first, offset)) &&
         Sampler::usable(gridLine.column(segment.last, offset), gridLine.row(segment.last, offset));
}

std::optional<Beside> segmentBeside(const Sampler& sampler, const GridLine& gridLine,
                                    const BrightSegment& segment, int offset) {
  const double level = 0.5 * (segment.base + segment.top);
  PixelRange range{static_cast<int>(segment.from + 1.0), static_cast<int>(segment.to), true};
  const int longest = 2 * (segment.last - segment.first) + 4;
  const int step = offset > 0 ? 1 : -1;
  for (int k = step; k != offset + step; k += step) {
    range = follow(laneOf(sampler, gridLine, k), range, level, longest);
    if (!range.found) return std::nullopt;
  }
  const Lane lane = laneOf(sampler, gridLine, offset);
  return Beside{passes(range.first - 1, lane.y(range.first - 1), lane.y(range.first), level),
                passes(range.last, lane.y(range.last), lane.y(range.last + 1), level)};
}

}  // namespace kelpie::vision

// SPDX-License-Identifier: Apache-2.0
#include "vision/LineScan.h"

#include <algorithm>

#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

constexpr int kReach = 2;  // px over which a blurred edge rises

// The brightness along a scan, read in place.
struct Profile {
  const std::uint8_t* y;
  int step;
  int length;

  int operator[](int i) const { return y[i * step]; }
};

Profile profileOf(const Sampler& sampler, const Scan& scan) {
  const std::uint8_t* first = sampler.rawY().data() + Image::at(scan.px, scan.py);
  return {first, scan.dy * kImageWidth + scan.dx, scan.length};
}

// The next place from i on where the brightness changes by `minStep`, or the end.
int nextStep(const Profile& y, int i, int minStep) {
  const int ahead = kReach * y.step;
  const auto flat = static_cast<unsigned>(2 * minStep - 1);
  const std::uint8_t* p = y.y + i * y.step;
  for (; i + kReach + 1 < y.length; ++i, p += y.step)
    if (static_cast<unsigned>(p[ahead] - p[0] + minStep - 1) >= flat) break;
  return i;
}

// Where a straight line from (i, a) to (i + 1, b) passes `level`; the nearer end when both are on
// one side of it, as where the pixel beside a stretch is itself half bright.
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
Stretch measured(const Profile& y, int first, int last, double whiteOverGreen) {
  Stretch s{first, last};
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

// The pixels beside the scan, as far as the image goes.
struct Lane {
  const Sampler& sampler;
  const Scan& scan;
  int aside;

  bool inside(int i) const {
    return i >= 0 && i < scan.length && Sampler::usable(scan.column(i, aside), scan.row(i, aside));
  }
  int y(int i) const { return sampler.rawY(scan.column(i, aside), scan.row(i, aside)); }
};

struct Range {
  int first = 0;  // first and last bright pixel
  int last = 0;
  bool found = false;
};

Range follow(const Lane& lane, Range before, double level, int longest) {
  Range now;
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
  while (i + kReach + 2 < y.length && sign * (y[i + kReach + 1] - y[i + 1]) >= minStep) ++i;
  return i;
}

}  // namespace

Scan scanOut(int py, int dx) {
  const int from = kImageWidth / 2;
  return {from, py, dx, 0, dx > 0 ? kUsableRight - from : from - kUsableLeft + 1};
}

Scan scanUp(int px, int highest) {
  return {px, kUsableBottom - 1, 0, -1, std::max(kUsableBottom - highest, 0)};
}

Scan scanRight(int py) { return {kUsableLeft, py, 1, 0, kUsableRight - kUsableLeft}; }

Stretches brightStretches(const Sampler& sampler, const Scan& scan, const LineParams& params) {
  const Profile y = profileOf(sampler, scan);
  const int minStep = static_cast<int>(params.minStep);
  Stretches found;
  int first = -1;
  for (int i = nextStep(y, 1, minStep); i + kReach + 1 < y.length;
       i = nextStep(y, i + 1, minStep)) {
    const int step = y[i + kReach] - y[i];
    if (step >= minStep) {
      first = i;
      i = lastStep(y, i, 1, minStep);
    } else if (step <= -minStep && first >= 0) {
      i = lastStep(y, i, -1, minStep);
      const int last = i + kReach;
      if (last - first <= params.maxStretch)
        found.push_back(measured(y, first, last, params.whiteOverGreen));
      first = -1;
    }
  }
  return found;
}

Rises risesOn(const Sampler& sampler, const Scan& scan, const LineParams& params) {
  const Profile y = profileOf(sampler, scan);
  const int minStep = static_cast<int>(params.minStep);
  Rises found;
  for (int i = nextStep(y, 1, minStep); i + kReach + 1 < y.length;
       i = nextStep(y, i + 1, minStep)) {
    if (y[i + kReach] - y[i] < minStep) continue;
    const int first = i;
    i = lastStep(y, i, 1, minStep);
    const int last = i + kReach;
    const double level = 0.5 * (0.5 * (y[first] + y[first - 1]) + y[last]);
    found.push_back({first, last, halfUp(y, first, last + 1, level), level});
  }
  return found;
}

std::optional<double> riseBeside(const Sampler& sampler, const Scan& scan, const Rise& rise,
                                 int aside) {
  constexpr int kMost = 4;  // px that the edge may move from one neighbour to the next
  const int step = aside > 0 ? 1 : -1;
  int dark = static_cast<int>(rise.foot);  // the last pixel below the level
  for (int k = step; k != aside + step; k += step) {
    const Lane lane{sampler, scan, k};
    if (!lane.inside(dark - kMost) || !lane.inside(dark + kMost + 1)) return std::nullopt;
    dark -= kMost;
    if (lane.y(dark) >= rise.level) return std::nullopt;
    const int end = dark + 2 * kMost;
    while (dark <= end && lane.y(dark + 1) < rise.level) ++dark;
    if (dark > end) return std::nullopt;
  }
  const Lane lane{sampler, scan, aside};
  return passes(dark, lane.y(dark), lane.y(dark + 1), rise.level);
}

bool hasBeside(const Scan& scan, const Stretch& stretch, int aside) {
  return Sampler::usable(scan.column(stretch.first, aside), scan.row(stretch.first, aside)) &&
         Sampler::usable(scan.column(stretch.last, aside), scan.row(stretch.last, aside));
}

std::optional<Beside> stretchBeside(const Sampler& sampler, const Scan& scan,
                                    const Stretch& stretch, int aside) {
  const double level = 0.5 * (stretch.base + stretch.top);
  Range range{static_cast<int>(stretch.from + 1.0), static_cast<int>(stretch.to), true};
  const int longest = 2 * (stretch.last - stretch.first) + 4;
  const int step = aside > 0 ? 1 : -1;
  for (int k = step; k != aside + step; k += step) {
    range = follow({sampler, scan, k}, range, level, longest);
    if (!range.found) return std::nullopt;
  }
  const Lane lane{sampler, scan, aside};
  return Beside{passes(range.first - 1, lane.y(range.first - 1), lane.y(range.first), level),
                passes(range.last, lane.y(range.last), lane.y(range.last + 1), level)};
}

}  // namespace kelpie::vision

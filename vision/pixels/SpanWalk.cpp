// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/SpanWalk.h"

#include "robot/core/Maths.h"
#include "robot/core/types/Percepts.h"
#include "vision/pixels/Between.h"
#include "vision/pixels/PixelWalk.h"

namespace kelpie::vision {
namespace {

// A colour, or a difference of colours, in half grey levels: the mean of two pixels is whole then.
// Whole numbers because each walk asks for ten colours.
struct Halves {
  int y = 0;
  int cr = 0;
  int cb = 0;
};

Halves operator+(const Halves& a, const Halves& b) { return {a.y + b.y, a.cr + b.cr, a.cb + b.cb}; }
Halves operator-(const Halves& a, const Halves& b) { return {a.y - b.y, a.cr - b.cr, a.cb - b.cb}; }
int dot(const Halves& a, const Halves& b) { return a.y * b.y + a.cr * b.cr + a.cb * b.cb; }

// A walk with its pixels, and the image that it goes through.
struct Walk {
  const Sampler& sampler;
  const SpanWalk& span;
  PixelWalk pixels;

  Walk(const Sampler& image, const SpanWalk& walk)
      : sampler(image), span(walk), pixels(walk.from, walk.direction) {}
  bool usable(int step) const { return Sampler::usable(pixels.x(step), pixels.y(step)); }
  PixelPoint along(int step) const { return moved(span.from, span.direction, step); }
  PixelPoint pixelCentre(int step) const { return {pixels.x(step) + 0.5, pixels.y(step) + 0.5}; }
  bool inside(int step) const {
    return usable(step) && sampler.classAt(pixels.x(step), pixels.y(step)) == span.colour;
  }
  // Half of a pixel's colour.
  Halves colourAt(int step) const {
    const Yuv c = sampler.corrected(pixels.x(step), pixels.y(step));
    return {c.y, c.cr, c.cb};
  }
};

// Mean of two neighbouring steps, or of one at the rim of the image.
Halves colourNear(const Walk& walk, int step, int next) {
  const Halves a = walk.colourAt(step);
  return walk.usable(next) ? a + walk.colourAt(next) : a + a;
}

PixelPoint betweenCentres(const Walk& walk, int step, double share) {
  return between(walk.pixelCentre(step), walk.pixelCentre(step + 1), share);
}

// How much of the inside colour a pixel has: 1 inside, 0 outside.
struct Blend {
  Halves outside;
  Halves difference;
  double perNorm = 1.0;

  double operator()(const Halves& c) const { return dot(c - outside, difference) * perNorm; }
};

// Colours closer than this cannot be distinguished above the noise (sd 3): take the class's edge.
constexpr int kMinContrast = 36;  // half grey levels

// Where the pixels of a blurred edge are half inside and half outside; `plain` without any.
PixelPoint halfBlended(const Walk& walk, const Blend& blend, int first, int end, PixelPoint plain) {
  double before = 1.0;
  for (int step = first; step < end; ++step) {
    const Halves colour = walk.colourAt(step);
    const double now = blend(colour + colour);
    if (now < 0.5 && step > 0) {
      const double share = before > now ? (before - 0.5) / (before - now) : 0.5;
      return betweenCentres(walk, step - 1, maths::clamp(share, 0.0, 1.0));
    }
    before = now;
  }
  return plain;
}

// `last` is the last step inside; two steps on the mixed pixels of the edge are passed.
PixelPoint halfWay(const Walk& walk, int last) {
  const PixelPoint plain = betweenCentres(walk, last, 0.5);
  const int beyond = last + 3;
  if (!walk.usable(beyond)) return plain;
  const int inner = last >= 2 ? last - 2 : 0;
  const Halves inside = colourNear(walk, inner, inner > 0 ? inner - 1 : 0);
  const Halves outside = colourNear(walk, beyond, beyond + 1);
  const Halves difference = inside - outside;
  const int norm = dot(difference, difference);
  if (norm < kMinContrast * kMinContrast) return plain;
  return halfBlended(walk, {outside, difference, 1.0 / norm}, last >= 1 ? last - 1 : 0, beyond + 1,
                     plain);
}

// The last step of the walk's colour before more than its holes of others. From the farthest that
// the holes allow backwards: where that is of the colour none between needs to be looked at.
int lastInside(const Walk& walk) {
  int last = 0;
  int others = 0;  // steps after the last one up to this one are of other classes
  while (true) {
    const int farthest = last + walk.span.holes + 1;
    int step = farthest;
    while (step > others && !walk.inside(step)) --step;
    if (step == others) return last;
    last = step;
    others = farthest;
  }
}

}  // namespace

EdgeHit walkToEdge(const Sampler& sampler, const SpanWalk& span) {
  EdgeHit hit{span.from, false, 0.0};
  if (!Sampler::usable(span.from)) {
    hit.cut = true;
    return hit;
  }
  const Walk walk(sampler, span);
  const int last = lastInside(walk);
  hit.cut = !walk.usable(last + span.holes + 1);
  hit.point = hit.cut ? walk.along(last) : halfWay(walk, last);
  hit.length = (hit.point.x - span.from.x) * span.direction.dx +
               (hit.point.y - span.from.y) * span.direction.dy;
  return hit;
}

}  // namespace kelpie::vision

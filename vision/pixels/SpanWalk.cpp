// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/SpanWalk.h"

#include "robot/core/Maths.h"
#include "robot/core/Percepts.h"
#include "vision/pixels/Between.h"

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

PixelPoint along(const SpanWalk& walk, int step) { return moved(walk.from, walk.direction, step); }

// Half of a pixel's colour.
Halves colourAt(const Sampler& sampler, PixelPoint p) {
  const Yuv c = sampler.corrected(static_cast<int>(p.x), static_cast<int>(p.y));
  return {c.y, c.cr, c.cb};
}

// Mean of two neighbouring steps, or of one at the rim of the image.
Halves colourNear(const Sampler& sampler, const SpanWalk& walk, int step, int next) {
  const Halves a = colourAt(sampler, along(walk, step));
  const PixelPoint other = along(walk, next);
  return Sampler::usable(other) ? a + colourAt(sampler, other) : a + a;
}

PixelPoint pixelCentre(PixelPoint p) {
  return {Sampler::pixelOf(p.x) + 0.5, Sampler::pixelOf(p.y) + 0.5};
}

PixelPoint betweenCentres(PixelPoint a, PixelPoint b, double share) {
  return between(pixelCentre(a), pixelCentre(b), share);
}

// How much of the inside colour a pixel has: 1 inside, 0 outside.
struct Blend {
  Halves outside;
  Halves difference;
  int norm = 1;

  double operator()(const Halves& c) const {
    return static_cast<double>(dot(c - outside, difference)) / norm;
  }
};

// Colours closer than this cannot be told apart above the noise (sd 3): take the class's edge.
constexpr int kMinContrast = 36;  // half grey levels

// Where the pixels of a blurred edge are half inside and half outside; `plain` without any.
PixelPoint halfBlended(const Sampler& sampler, const SpanWalk& walk, const Blend& blend, int first,
                       int end, PixelPoint plain) {
  double before = 1.0;
  for (int step = first; step < end; ++step) {
    const Halves colour = colourAt(sampler, along(walk, step));
    const double now = blend(colour + colour);
    if (now < 0.5 && step > 0) {
      const double share = before > now ? (before - 0.5) / (before - now) : 0.5;
      return betweenCentres(along(walk, step - 1), along(walk, step),
                            maths::clamp(share, 0.0, 1.0));
    }
    before = now;
  }
  return plain;
}

// `last` is the last step inside; two steps on the mixed pixels of the edge are passed.
PixelPoint halfWay(const Sampler& sampler, const SpanWalk& walk, int last) {
  const PixelPoint plain = betweenCentres(along(walk, last), along(walk, last + 1), 0.5);
  const int beyond = last + 3;
  if (!Sampler::usable(along(walk, beyond))) return plain;
  const int inner = last >= 2 ? last - 2 : 0;
  const Halves inside = colourNear(sampler, walk, inner, inner > 0 ? inner - 1 : 0);
  const Halves outside = colourNear(sampler, walk, beyond, beyond + 1);
  const Halves difference = inside - outside;
  const int norm = dot(difference, difference);
  if (norm < kMinContrast * kMinContrast) return plain;
  return halfBlended(sampler, walk, {outside, difference, norm}, last >= 1 ? last - 1 : 0,
                     beyond + 1, plain);
}

// The last step of the walk's colour before more than its holes of others. From the farthest that
// the holes allow backwards: where that is of the colour none between needs to be looked at.
int lastInside(const Sampler& sampler, const SpanWalk& walk) {
  int last = 0;
  int others = 0;  // steps after the last one up to this one are of other classes
  while (true) {
    const int farthest = last + walk.holes + 1;
    int step = farthest;
    for (; step > others; --step) {
      const PixelPoint p = along(walk, step);
      if (Sampler::usable(p) && sampler.classAt(p) == walk.colour) break;
    }
    if (step == others) return last;
    last = step;
    others = farthest;
  }
}

}  // namespace

EdgeHit walkToEdge(const Sampler& sampler, const SpanWalk& walk) {
  EdgeHit hit{walk.from, false, 0.0};
  if (!Sampler::usable(walk.from)) {
    hit.cut = true;
    return hit;
  }
  const int last = lastInside(sampler, walk);
  hit.cut = !Sampler::usable(along(walk, last + walk.holes + 1));
  hit.point = hit.cut ? along(walk, last) : halfWay(sampler, walk, last);
  hit.length = (hit.point.x - walk.from.x) * walk.direction.dx +
               (hit.point.y - walk.from.y) * walk.direction.dy;
  return hit;
}

}  // namespace kelpie::vision

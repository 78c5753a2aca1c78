// SPDX-License-Identifier: Apache-2.0
#include "vision/pixels/SpanWalk.h"

#include "robot/core/Maths.h"
#include "robot/core/Percepts.h"

namespace kelpie::vision {
namespace {

struct Mean {
  double y = 0.0;
  double cr = 0.0;
  double cb = 0.0;
};

PixelPoint along(const SpanWalk& walk, int step) { return moved(walk.from, walk.direction, step); }

Mean colourAt(const Sampler& sampler, PixelPoint p) {
  const Yuv c = sampler.corrected(static_cast<int>(p.x), static_cast<int>(p.y));
  return {static_cast<double>(c.y), static_cast<double>(c.cr), static_cast<double>(c.cb)};
}

// Mean of two neighbouring steps, or of one at the rim of the image.
Mean colourNear(const Sampler& sampler, const SpanWalk& walk, int step, int next) {
  const Mean a = colourAt(sampler, along(walk, step));
  if (!Sampler::usable(along(walk, next))) return a;
  const Mean b = colourAt(sampler, along(walk, next));
  return {0.5 * (a.y + b.y), 0.5 * (a.cr + b.cr), 0.5 * (a.cb + b.cb)};
}

PixelPoint pixelCentre(PixelPoint p) {
  return {Sampler::pixelOf(p.x) + 0.5, Sampler::pixelOf(p.y) + 0.5};
}

PixelPoint between(PixelPoint a, PixelPoint b, double share) {
  const PixelPoint p = pixelCentre(a);
  const PixelPoint q = pixelCentre(b);
  return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
}

// How much of the inside colour a pixel has: 1 inside, 0 outside.
struct Blend {
  Mean outside;
  Mean difference;
  double norm = 1.0;

  double operator()(const Mean& c) const {
    return ((c.y - outside.y) * difference.y + (c.cr - outside.cr) * difference.cr +
            (c.cb - outside.cb) * difference.cb) /
           norm;
  }
};

// Colours closer than this cannot be told apart above the noise (sd 3): take the class's edge.
constexpr double kMinContrast = 18.0;

// `last` is the last step inside; two steps on the mixed pixels of the edge are passed.
PixelPoint halfWay(const Sampler& sampler, const SpanWalk& walk, int last) {
  const auto plain = [&walk, last] {
    return between(along(walk, last), along(walk, last + 1), 0.5);
  };
  const int beyond = last + 3;
  if (!Sampler::usable(along(walk, beyond))) return plain();
  const int inner = last >= 2 ? last - 2 : 0;
  const Mean inside = colourNear(sampler, walk, inner, inner > 0 ? inner - 1 : 0);
  Blend blend{colourNear(sampler, walk, beyond, beyond + 1), {}, 1.0};
  blend.difference = {inside.y - blend.outside.y, inside.cr - blend.outside.cr,
                      inside.cb - blend.outside.cb};
  blend.norm = maths::square(blend.difference.y) + maths::square(blend.difference.cr) +
               maths::square(blend.difference.cb);
  if (blend.norm < maths::square(kMinContrast)) return plain();
  double before = 1.0;
  for (int step = last >= 1 ? last - 1 : 0; step <= beyond; ++step) {
    const double now = blend(colourAt(sampler, along(walk, step)));
    if (now < 0.5 && step > 0) {
      const double share = before > now ? (before - 0.5) / (before - now) : 0.5;
      return between(along(walk, step - 1), along(walk, step), maths::clamp(share, 0.0, 1.0));
    }
    before = now;
  }
  return plain();
}

}  // namespace

EdgeHit walkToEdge(const Sampler& sampler, const SpanWalk& walk) {
  EdgeHit hit{walk.from, false, 0.0};
  if (!Sampler::usable(walk.from)) {
    hit.cut = true;
    return hit;
  }
  int last = 0;
  for (int step = 1; step - last <= walk.holes + 1; ++step) {
    const PixelPoint p = along(walk, step);
    if (!Sampler::usable(p)) {
      hit.cut = true;
      break;
    }
    if (sampler.classAt(p) == walk.colour) last = step;
  }
  hit.point = hit.cut ? along(walk, last) : halfWay(sampler, walk, last);
  hit.length = (hit.point.x - walk.from.x) * walk.direction.dx +
               (hit.point.y - walk.from.y) * walk.direction.dy;
  return hit;
}

}  // namespace kelpie::vision

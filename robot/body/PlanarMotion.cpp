// SPDX-License-Identifier: Apache-2.0
#include "robot/body/PlanarMotion.h"

namespace kelpie::body {

PlanarMotion rigidMotion(const Point2<Robot>* from, const Point2<Robot>* to, std::size_t count) {
  PlanarMotion motion;
  if (count == 0) return motion;
  const double share = 1.0 / static_cast<double>(count);
  Point2<Robot> a;
  Point2<Robot> b;
  for (std::size_t i = 0; i < count; ++i) {
    a = a + from[i] * share;
    b = b + to[i] * share;
  }
  double along = 0.0;
  double across = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Point2<Robot> p = from[i] - a;
    const Point2<Robot> q = to[i] - b;
    along += p.x * q.x + p.y * q.y;
    across += p.x * q.y - p.y * q.x;
  }
  motion.turn = count > 1 ? maths::atan2(across, along) : 0.0;
  const maths::SinCos r = maths::sinCos(motion.turn);
  motion.x = b.x - (r.cos * a.x - r.sin * a.y);
  motion.y = b.y - (r.sin * a.x + r.cos * a.y);
  return motion;
}

}  // namespace kelpie::body

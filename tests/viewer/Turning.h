// SPDX-License-Identifier: Apache-2.0
// Quaternions and transforms as a viewer uses them, written apart from what makes them.
#pragma once

#include <array>

#include "foxglove/Frames.pb.h"

namespace kelpie::viewer {

using Vec = std::array<double, 3>;

inline Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// v + 2 w (q x v) + 2 q x (q x v)
inline Vec turnedBy(const foxglove::Quaternion& q, const Vec& v) {
  const Vec axis{q.x(), q.y(), q.z()};
  const Vec once = cross(axis, v);
  const Vec twice = cross(axis, once);
  Vec result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = v[i] + 2.0 * q.w() * once[i] + 2.0 * twice[i];
  return result;
}

inline double normOf(const foxglove::Quaternion& q) {
  return q.x() * q.x() + q.y() * q.y() + q.z() * q.z() + q.w() * q.w();
}

// From the parent's coordinates to the child's.
inline Vec inChild(const foxglove::FrameTransform& transform, const Vec& p) {
  const foxglove::Vector3& t = transform.translation();
  foxglove::Quaternion back = transform.rotation();
  back.set_w(-back.w());
  return turnedBy(back, {p[0] - t.x(), p[1] - t.y(), p[2] - t.z()});
}

}  // namespace kelpie::viewer

// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/View.h"

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::broadcast {

std::optional<cv::Point2d> project(const View& view, const cv::Vec3d& point, cv::Size size) {
  const cv::Vec3d ahead = cv::normalize(view.target - view.eye);
  const cv::Vec3d right = cv::normalize(ahead.cross(cv::Vec3d(0.0, 0.0, 1.0)));
  const cv::Vec3d up = right.cross(ahead);
  const cv::Vec3d way = point - view.eye;
  const double depth = way.dot(ahead);
  if (depth <= 0.01) return std::nullopt;
  const double focal = 0.5 * size.height / std::tan(0.5 * kOpening * maths::kPi / 180.0);
  return cv::Point2d(0.5 * size.width + focal * way.dot(right) / depth,
                     0.5 * size.height - focal * way.dot(up) / depth);
}

}  // namespace kelpie::broadcast

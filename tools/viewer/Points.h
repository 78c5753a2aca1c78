// SPDX-License-Identifier: Apache-2.0
// A PointCloud under construction: three floats and four bytes of colour a point.
#pragma once

#include <string>

#include "foxglove/Basics.pb.h"
#include "foxglove/Frames.pb.h"
#include "robot/core/Time.h"

namespace kelpie::viewer {

class Points {
 public:
  Points(TimeUs time, const std::string& frame);

  void add(const foxglove::Vector3& place, const foxglove::Color& colour);
  const foxglove::PointCloud& cloud() const { return cloud_; }

 private:
  foxglove::PointCloud cloud_;
};

}  // namespace kelpie::viewer

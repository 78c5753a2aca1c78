// SPDX-License-Identifier: Apache-2.0
// The frames of a film of one robot: its camera with all that vision found and, below, why it did
// what it did, a line for each layer; beside it the field seen from above.
#pragma once

#include <opencv2/core.hpp>

#include "tools/match/Match.h"

namespace kelpie::cli {

class RobotFilm {
 public:
  explicit RobotFilm(const match::Match& match);
  cv::Size size() const { return canvas_.size(); }
  const cv::Mat& frame(const match::Moment& moment);

 private:
  body::FieldDescription field_;
  cv::Mat ground_;
  cv::Mat canvas_;
  match::Paths paths_;
};

}  // namespace kelpie::cli

// SPDX-License-Identifier: Apache-2.0
// The frames of a film of a match as television would show it: the stage, followed by a camera,
// beside what the watched robot sees and why it does what it does.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/broadcast/Cameraman.h"
#include "tools/broadcast/Course.h"
#include "tools/match/Match.h"
#include "tools/match/MatchWords.h"

namespace kelpie::broadcast {

constexpr int kFilmRate = 15;         // frames a second
constexpr std::size_t kEvery = 2;     // of the camera's frames one is shown
constexpr double kLastPicture = 1.5;  // s that the last one stays

class BroadcastFilm {
 public:
  // An error where the stage cannot be drawn (Stage.h) or nothing can be written.
  static Expected<BroadcastFilm> create(const match::Match& match, Course course,
                                        double sharpness = kFilmSharpness);

  static cv::Size size() { return {1280, 720}; }
  // To be asked in the order of the moments, of each one in kEvery.
  Expected<cv::Mat> frame(const match::Moment& moment);
  // The last one once more, with what was called at the very end.
  Expected<cv::Mat> last(const match::Moment& moment);

 private:
  BroadcastFilm(const match::Match& match, Course course, Stage stage);
  Expected<cv::Mat> draw(const match::Moment& moment, double seconds);
  void plan();

  const match::Match* match_;
  Course course_;
  Stage stage_;
  match::MatchFacts facts_;
  std::vector<double> times_;
  std::vector<View> views_;
  std::size_t next_ = 0;
};

}  // namespace kelpie::broadcast

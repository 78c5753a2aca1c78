// SPDX-License-Identifier: Apache-2.0
// The frames of a film with the cameras of all robots round the field, the red ones at the left,
// the blue ones at the right. A robot without a log is a grey tile with its name.
#pragma once

#include <deque>

#include "tools/broadcast/BroadcastFilm.h"
#include "tools/broadcast/Feed.h"
#include "tools/picture/Canvas.h"

namespace kelpie::broadcast {

class SplitFilm {
 public:
  // `logs`: all of them, the watched one first.
  static Expected<SplitFilm> create(const match::Match& match, Course course,
                                    const std::vector<std::string>& logs,
                                    double sharpness = kFilmSharpness);

  static cv::Size size() { return {1280, 720}; }
  Expected<cv::Mat> frame(const match::Moment& moment);

 private:
  SplitFilm(const match::Match& match, Course course, Stage stage);
  void drawTile(picture::Canvas& canvas, TeamColour team, int player, const Tableau& tableau);
  Feed* feedOf(TeamColour team, int player);

  const match::Match* match_;
  Course course_;
  Stage stage_;
  match::MatchFacts facts_;
  std::deque<Feed> feeds_;
};

}  // namespace kelpie::broadcast

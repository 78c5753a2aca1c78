// SPDX-License-Identifier: Apache-2.0
// How far what a localiser is fed is from the truth during a match: landmarks by kind, odometry by
// second. Tells which of its assumptions are wrong.
#pragma once

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "tools/experiments/Experiment.h"
#include "tools/experiments/LocaliseFilters.h"
#include "tools/experiments/LocaliseMatch.h"

namespace kelpie::experiments {

class SenseErrors {
 public:
  // `csv`: file for a table of all landmarks; empty: none.
  SenseErrors(const gps::GpsParams& params, const std::string& csv);

  void frame(const WatchedFrame& frame);
  Json json() const;
  // Of all matches: for beacons and goals (uncut ones) bias and spread of distance and heading, as
  // they are and over the claimed sd; landmarks and false ones a second; true way over odometry.
  static Json summary(const std::vector<Json>& matches);

 private:
  struct Errors {
    std::vector<double> distance;  // share of the true one
    std::vector<double> heading;   // deg
    std::vector<double> distanceOverSd;
    std::vector<double> headingOverSd;
  };
  void landmark(const LandmarkPercept& percept, const WatchedFrame& frame);
  void step(const WatchedFrame& frame);

  void write(const LandmarkPercept& percept, const TrueLandmark& truth, TimeUs time);

  gps::GpsParams params_;
  std::ofstream csv_;
  std::array<Errors, 2> errors_;  // beacons, goals
  std::vector<double> falseOnes_{0.0};
  std::vector<double> seconds_{0.0};
  std::vector<double> saidForward_, saidLeft_, saidTurn_, didForward_, didLeft_, didTurn_;
};

}  // namespace kelpie::experiments

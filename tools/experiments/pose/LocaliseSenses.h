// SPDX-License-Identifier: Apache-2.0
// Errors of a localiser's inputs during a match: landmarks by kind, odometry by second. They tell
// which of its assumptions are wrong.
#pragma once

#include <string>
#include <vector>

#include "tools/experiments/harness/Trace.h"
#include "tools/experiments/pose/LocaliseFilters.h"
#include "tools/experiments/pose/LocaliseMatch.h"

namespace kelpie::experiments {

// Errors of the landmarks of one kind.
struct LandmarkErrors {
  Values distance;  // share of the true one
  Values heading;   // deg
  Values distanceOverSd;
  Values headingOverSd;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("distance", &LandmarkErrors::distance),
                     field("heading", &LandmarkErrors::heading, "deg"),
                     field("distanceOverSd", &LandmarkErrors::distanceOverSd),
                     field("headingOverSd", &LandmarkErrors::headingOverSd));
  }
  void add(const LandmarkErrors& other);
  // A percept of a landmark or a ball.
  template <class Percept>
  void add(const Percept& percept, const TrueLandmark& truth);
  Json summary(double seconds) const;
};

// One direction of the odometry beside what the robot really did, each second.
struct OdometryErrors {
  Values reported;
  Values real;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("reported", &OdometryErrors::reported),
                     field("real", &OdometryErrors::real));
  }
  void add(const OdometryErrors& other);
  // Slope through the origin of what was done over what was reported, and the residuals.
  Json summary() const;
};

struct SenseErrors {
  double seconds = 0.0;  // of the matches
  int falseLandmarks = 0;
  LandmarkErrors beacons;
  LandmarkErrors goals;          // uncut ones
  LandmarkErrors balls;          // to 150 cm
  int falseBalls = 0;            // of those
  OdometryErrors forward, left;  // cm
  OdometryErrors turn;           // deg

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("seconds", &SenseErrors::seconds, "s"),
        field("falseLandmarks", &SenseErrors::falseLandmarks),
        field("beacons", &SenseErrors::beacons), field("goals", &SenseErrors::goals),
        field("balls", &SenseErrors::balls), field("falseBalls", &SenseErrors::falseBalls),
        field("forward", &SenseErrors::forward, "cm"), field("left", &SenseErrors::left, "cm"),
        field("turn", &SenseErrors::turn, "deg"));
  }
  void add(const SenseErrors& other);
  // For beacons, goals and balls bias and spread of distance and heading, as they are and over the
  // claimed sd; landmarks and false ones a second; true way over odometry.
  Json summary() const;
};

struct LandmarkRow {
  TimeUs time;
  LandmarkKind kind = LandmarkKind::goalBlue;
  double distance = 0.0;
  double trueDistance = 0.0;
  Angle heading;
  Angle trueHeading;
  double distanceSd = 0.0;
  double headingSd = 0.0;  // deg
  bool cut = false;        // by the image's border

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("t_s", &LandmarkRow::time), field("kind", &LandmarkRow::kind),
                     field("distance_cm", &LandmarkRow::distance),
                     field("true_distance_cm", &LandmarkRow::trueDistance),
                     field("heading_deg", &LandmarkRow::heading),
                     field("true_heading_deg", &LandmarkRow::trueHeading),
                     field("distance_sd_cm", &LandmarkRow::distanceSd),
                     field("heading_sd_deg", &LandmarkRow::headingSd),
                     field("cut", &LandmarkRow::cut));
  }
};

// Collects them frame by frame.
class SenseRecorder {
 public:
  // `path`: of a table of all landmarks; empty: none.
  SenseRecorder(const gps::GpsParams& params, const std::string& path)
      : params_(params), trace_(path) {}

  void frame(const WatchedFrame& frame);
  const SenseErrors& errors() const { return errors_; }

 private:
  void addLandmark(const LandmarkPercept& percept, const WatchedFrame& frame);
  void addBall(const BallPercept& percept, const WatchedFrame& frame);
  void addStep(const WatchedFrame& frame);

  gps::GpsParams params_;
  Trace<LandmarkRow> trace_;
  SenseErrors errors_;
};

}  // namespace kelpie::experiments

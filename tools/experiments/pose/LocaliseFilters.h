// SPDX-License-Identifier: Apache-2.0
// Localisers that listen to a match beside the player's own: the same input and percepts through
// other parameters, or with some of the percepts left out or corrected by the truth. So one match
// compares them frame by frame. For experiments only: the player acts on its own belief.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/experiments/baselines/PoseVariants.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/pose/LocaliseMatch.h"

namespace kelpie::experiments {

// What a listener hears. The truth tells what the error comes from, one thing at a time.
struct Hearing {
  bool landmarks = true;
  bool lines = true;
  bool trueOdometry = false;
  bool trueDistances = false;  // of landmarks that are really there
  bool trueHeadings = false;
  bool noFalse = false;  // without landmarks that are not there
};

class Listener {
 public:
  Listener(std::string name, const gps::GpsParams& params, const Hearing& hearing,
           gps::Localise localise = gps::step);

  const WorldModel& hear(const WatchedFrame& frame);
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  gps::GpsParams params_;
  Hearing hearing_;
  gps::Localise localise_;
  std::unique_ptr<gps::GpsState> state_ = std::make_unique<gps::GpsState>();
  std::unique_ptr<FrameInput> input_ = std::make_unique<FrameInput>();
  std::unique_ptr<Percepts> percepts_ = std::make_unique<Percepts>();
  std::unique_ptr<WorldModel> world_ = std::make_unique<WorldModel>();
};

// Where a landmark really is, seen from the robot.
struct TrueLandmark {
  double distance = 0.0;
  Angle heading;
};
TrueLandmark trueLandmark(LandmarkKind kind, const Pose2& robot, const gps::GpsParams& params,
                          TeamColour team);
// The percept shows that landmark: heading within 10 deg or half a goal, distance within a third.
bool isThere(const LandmarkPercept& percept, const TrueLandmark& truth);

// A belief beside the truth of one frame.
struct PoseError {
  double cm = 0.0;
  double deg = 0.0;
  double nees = 0.0;  // squared error over the claimed covariance (NEES); 3 on average if true

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("cm", &PoseError::cm), field("deg", &PoseError::deg),
                     field("nees", &PoseError::nees));
  }
};
PoseError poseError(const WorldModel& world, const Pose2& truth);

// Errors of one localiser over a match.
struct ErrorTrack {
  Values cm;
  Values deg;
  Values nees;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("cm", &ErrorTrack::cm), field("deg", &ErrorTrack::deg),
                     field("nees", &ErrorTrack::nees));
  }
  void add(const PoseError& error);
  void add(const ErrorTrack& other);
  // mean_cm, median_cm, p95_cm, mean_deg, p95_deg, gross_rate (beyond 50 cm), understated_rate
  // (beyond what 5 % of the frames may be, were the covariance true), nees (its median over the
  // 2.37 of a true covariance), nees_mean (its mean over the 3 of one).
  Json summary() const;
};

}  // namespace kelpie::experiments

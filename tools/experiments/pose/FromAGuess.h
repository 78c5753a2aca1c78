// SPDX-License-Identifier: Apache-2.0
// Guesses beside a true pose, and how often a way of finding the best match leads from them to
// within 10 cm and 5 deg of it (checklist E7).
#pragma once

#include <array>
#include <cmath>

#include "gps/lines/LineFit.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/sim/world/Observer.h"

namespace kelpie::experiments {

struct Start {
  double sd;     // cm
  double sdDeg;  // deg
};
constexpr std::array<Start, 3> kStarts{{{10, 5}, {20, 10}, {40, 20}}};

struct SeenPose {
  sim::TruePose truth;
  gps::SeenLines seen;
};

inline Pose2 guessBeside(const sim::TruePose& truth, const Start& start, std::uint64_t seed) {
  Random random(seed + 77);
  return {{truth.x + random.gaussian(0.0, start.sd), truth.y + random.gaussian(0.0, start.sd)},
          Angle::rad(truth.heading) + Angle::deg(random.gaussian(0.0, start.sdDeg))};
}

class FoundPoses {
 public:
  void add(const Pose2& pose, std::uint32_t steps, const sim::TruePose& truth) {
    const double off = std::hypot(pose.position.x - truth.x, pose.position.y - truth.y);
    const double turned = (pose.heading - Angle::rad(truth.heading)).abs().deg();
    steps_ += steps;
    const bool found = off <= kSuccessCm && turned <= kSuccessDeg;
    successes_.count(found);
    if (found) error2_ += off * off;
  }
  cli::Json json() const {
    return {{"success", successes_.value()},
            {"steps", ratio(steps_, successes_.all)},
            {"rms_cm", std::sqrt(ratio(error2_, successes_.hits))}};
  }

 private:
  static constexpr double kSuccessCm = 10.0;
  static constexpr double kSuccessDeg = 5.0;

  Share successes_;
  double steps_ = 0.0;
  double error2_ = 0.0;  // cm2, of the successes
};

}  // namespace kelpie::experiments

// SPDX-License-Identifier: Apache-2.0
// Odometry as a function of time. The motion loop reports what was walked in steps of 32 ms, images
// are exposed in between, or before: the total is interpolated over the last eight steps, as
// images may lag by 130 ms, and extrapolated at the last rate for at most three, as an image may be
// newer than the last sensor message, the more so where joints are older than images. Components
// are summed in the robot frame; over one camera frame (at most 0.1 rad) the error is below 0.1 cm.
#pragma once

#include <array>
#include <cmath>

#include "robot/core/types/Motion.h"

namespace kelpie::agent {

class OdometryTrack {
 public:
  // A step that ended at `end` and lasted one message.
  void add(TimeUs end, const Odometry& step) {
    for (std::size_t i = totals_.size() - 1; i > 0; --i) totals_[i] = totals_[i - 1];
    const OdometryVariance& last = totals_[1].variance;
    totals_[0] = {totals_[1].forward + step.forward,
                  totals_[1].left + step.left,
                  totals_[1].turn + step.turn.rad(),
                  {last.forward + step.variance.forward, last.left + step.variance.left,
                   last.turn + step.variance.turn}};
    end_ = end;
  }

  // What was walked between the previous call and `time`.
  Odometry until(TimeUs time) {
    const Total total = totalAt(time);
    Odometry walked{total.forward - taken_.forward,
                    total.left - taken_.left,
                    Angle::rad(total.turn - taken_.turn),
                    {}};
    // Of time that was extrapolated too far there is nothing to take back.
    walked.variance = {std::fmax(0.0, total.variance.forward - taken_.variance.forward),
                       std::fmax(0.0, total.variance.left - taken_.variance.left),
                       std::fmax(0.0, total.variance.turn - taken_.variance.turn)};
    taken_ = total;
    return walked;
  }

 private:
  static constexpr std::size_t kSteps = 8;
  static constexpr double kMaxAhead = 3.0;  // steps
  struct Total {
    double forward = 0.0;  // cm
    double left = 0.0;     // cm
    double turn = 0.0;     // rad, not wrapped
    OdometryVariance variance;
  };

  Total totalAt(TimeUs time) const {
    const double message = kTickSeconds * kTicksPerMessage;
    const double back = maths::clamp((end_ - time).seconds() / message, -kMaxAhead, double{kSteps});
    const auto i = static_cast<std::size_t>(maths::clamp(back, 0.0, kSteps - 1.0));
    const Total& a = totals_[i];
    const Total& b = totals_[i + 1];
    const double share = back - static_cast<double>(i);
    const auto mix = [share](double at, double to) { return at + share * (to - at); };
    return {mix(a.forward, b.forward),
            mix(a.left, b.left),
            mix(a.turn, b.turn),
            {mix(a.variance.forward, b.variance.forward), mix(a.variance.left, b.variance.left),
             mix(a.variance.turn, b.variance.turn)}};
  }

  std::array<Total, kSteps + 1> totals_{};  // since the start, at the ends of steps, latest first
  Total taken_;
  TimeUs end_;
};

}  // namespace kelpie::agent

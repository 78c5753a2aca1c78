// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/JointTrack.h"

namespace kelpie::agent {
namespace {

constexpr double kMaxExtrapolation = 2.5;  // ticks, 20 ms: half an exposure and one tick of delay

}  // namespace

JointTrack::Span JointTrack::spanAt(TimeUs time) const {
  const std::size_t count = next_ < kTicks ? next_ : kTicks;
  std::size_t newer = next_ - 1;
  const std::size_t oldest = next_ - count;
  while (newer > oldest + 1 && time < times_[(newer - 1) % kTicks]) --newer;
  const std::size_t older = newer > oldest ? newer - 1 : newer;
  const double seconds = (times_[newer % kTicks] - times_[older % kTicks]).seconds();
  const double past = (time - times_[older % kTicks]).seconds();
  const double fraction =
      seconds > 0.0 ? maths::clamp(past / seconds, 0.0, 1.0 + kMaxExtrapolation) : 0.0;
  return {&frames_[older % kTicks], &frames_[newer % kTicks], seconds, fraction};
}

SensorFrame JointTrack::at(TimeUs time) const {
  if (empty()) return {};
  const Span span = spanAt(time);
  SensorFrame result = frames_[(next_ - 1) % kTicks];
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const Angle from = span.older->joints.angle[j];
    result.joints.angle[j] = from + (span.newer->joints.angle[j] - from) * span.fraction;
  }
  return result;
}

HeadRate JointTrack::headRate(TimeUs time) const {
  if (empty()) return {};
  const Span span = spanAt(time);
  if (span.seconds <= 0.0) return {};
  const auto rate = [&span](Joint joint) {
    return (span.newer->joints[joint] - span.older->joints[joint]).rad() / span.seconds;
  };
  return {rate(Joint::neckTilt), rate(Joint::headPan), rate(Joint::headNod)};
}

}  // namespace kelpie::agent

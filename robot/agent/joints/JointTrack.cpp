// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/joints/JointTrack.h"

namespace kelpie::agent {
namespace {

constexpr double kMaxExtrapolation = 0.1;  // s
constexpr std::size_t kRateTicks = 4;      // over which the rate is taken beyond the newest tick

}  // namespace

JointTrack::Places JointTrack::placesAt(TimeUs time) const {
  const std::size_t count = next_ < kTicks ? next_ : kTicks;
  const std::size_t oldest = next_ - count;
  std::size_t newer = next_ - 1;
  if (times_[newer % kTicks] < time)
    return {oldest, newer - oldest > kRateTicks ? newer - kRateTicks : oldest, newer};
  while (newer > oldest + 1 && time < times_[(newer - 1) % kTicks]) --newer;
  return {oldest, newer > oldest ? newer - 1 : newer, newer};
}

JointTrack::Span JointTrack::between(std::size_t older, std::size_t newer) const {
  const double seconds = (times_[newer % kTicks] - times_[older % kTicks]).seconds();
  return {&frames_[older % kTicks], &frames_[newer % kTicks], times_[older % kTicks], seconds};
}

double JointTrack::partWay(const Places& places, TimeUs time) const {
  const Span span = between(places.older, places.newer);
  const double past = (time - span.start).seconds();
  if (!(span.seconds > 0.0)) return 0.0;
  return maths::clamp(past / span.seconds, 0.0, 1.0 + kMaxExtrapolation / span.seconds);
}

SensorFrame JointTrack::at(TimeUs time) const {
  if (empty()) return {};
  const Places places = placesAt(time);
  const Span span = between(places.older, places.newer);
  const double fraction = partWay(places, time);
  SensorFrame result = frames_[(next_ - 1) % kTicks];
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const Angle from = span.older->joints.angle[j];
    result.joints.angle[j] = from + (span.newer->joints.angle[j] - from) * fraction;
  }
  return result;
}

Stance JointTrack::stance(TimeUs time) const {
  if (empty()) return {};
  const Places places = placesAt(time);
  const double part = partWay(places, time);
  const Stance& from = stances_[places.older % kTicks];
  const Stance& to = stances_[places.newer % kTicks];
  return {from.shoulderHeight + part * (to.shoulderHeight - from.shoulderHeight),
          from.bodyTilt + (to.bodyTilt - from.bodyTilt) * part,
          from.bodyRoll + (to.bodyRoll - from.bodyRoll) * part};
}

HeadRate JointTrack::headRate(TimeUs time) const {
  if (empty()) return {};
  // From a tick before to a tick after where these exist: over three ticks the sensed angles' noise
  // (0.1 deg) weighs a third of what it does over one, where it is 0.5 deg an image.
  const Places places = placesAt(time);
  const Span span = between(places.older > places.oldest ? places.older - 1 : places.older,
                            places.newer + 1 < next_ ? places.newer + 1 : places.newer);
  if (span.seconds <= 0.0) return {};
  const auto rate = [&span](Joint joint) {
    return (span.newer->joints[joint] - span.older->joints[joint]).rad() / span.seconds;
  };
  return {rate(Joint::neckTilt), rate(Joint::headPan), rate(Joint::headNod)};
}

}  // namespace kelpie::agent

// SPDX-License-Identifier: Apache-2.0
// What an agent sent to a robot's effectors, played tick by tick as OPEN-R does: command vectors in
// their turn, joints that none names stay where they were commanded to be.
#pragma once

#include <cstdint>
#include <deque>

#include "robot/host/world/WorldProtocol.h"

namespace kelpie::sim {

class CommandQueue {
 public:
  explicit CommandQueue(const JointAngles& start) : target_(start) {}

  void add(const host::AgentReply& reply);
  // One tick.
  void play();

  const JointAngles& target() const { return target_; }
  // Whether the joint is held: the motors have power and its gain is enabled. Who puts a robot onto
  // the field stands it there and keeps a hand at it until its motors hold it for the first time.
  bool held(std::size_t joint) const {
    return handHolds_ || (motorPower_ && (gains_ >> joint & 1U) != 0);
  }
  double legGain() const { return legGain_; }  // over the standard one
  // Vectors whose output ended since the last call.
  std::uint32_t takeVectorsDone();
  std::size_t vectorsWaiting() const { return queue_.size(); }

 private:
  std::deque<host::EffectorVector> queue_;
  JointAngles target_;
  bool motorPower_ = false;
  std::uint32_t gains_ = 0;
  bool handHolds_ = true;
  double legGain_ = 1.0;
  std::uint32_t played_ = 0;  // ticks of the first vector
  std::uint32_t done_ = 0;
};

}  // namespace kelpie::sim

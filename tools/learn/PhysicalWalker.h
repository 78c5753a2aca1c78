// SPDX-License-Identifier: Apache-2.0
// A physical robot with its actuator on carpet without an end, as cheap as can be: commands
// in, what the actuator tells and the true way out. Two command vectors are in flight, as on the
// robot. It begins standing.
#pragma once

#include <memory>

#include "actuator/Actuator.h"
#include "tools/sim/physics/PhysicalBodies.h"

namespace kelpie::learn {

class PhysicalWalker {
 public:
  PhysicalWalker(const sim::PhysicsParams& model, const actuator::ActuatorParams& params,
                 std::uint64_t seed);

  // 32 ms. After a fault of the physics nothing moves any more and failed() is true.
  const MotionOutput& step(const Command& command);
  const MotionOutput& output() const { return output_; }

  sim::BodyPlace place() const { return bodies_->place(0); }
  Pose2 pose() const { return place().pose; }
  bool fallen() const;
  bool failed() const { return failed_; }
  void spareLegs() { worn_ = true; }  // the battery gives so much that the actuator takes weak legs
  sim::PhysicalBodies& bodies() { return *bodies_; }
  const actuator::ActuatorState& state() const { return state_; }

 private:
  void send();

  std::unique_ptr<sim::PhysicalBodies> bodies_;
  const actuator::ActuatorParams* params_;  // must live as long
  actuator::ActuatorState state_;
  MotionInput input_;
  MotionOutput output_;
  bool sent_ = false;
  bool failed_ = false;
  bool worn_ = false;
};

}  // namespace kelpie::learn

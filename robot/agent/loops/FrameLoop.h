// SPDX-License-Identifier: Apache-2.0
// The camera loop: one FrameInput becomes BodyState, Percepts, WorldModel and Command. This file
// and MotionLoop.h are the only code that knows the stages and their order.
#pragma once

#include <memory>
#include <string>

#include "behaviour/Behaviour.h"
#include "gps/Localiser.h"
#include "robot/agent/AgentConfig.h"
#include "robot/agent/loops/Sight.h"
#include "robot/agent/loops/StageObserver.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"
#include "vision/Vision.h"

namespace kelpie::agent {

class FrameLoop {
 public:
  // `scripts`: folder or zip of behaviours. `beside`: another robot's of this process, if there is
  // one (BehaviourState).
  FrameLoop(const AgentConfig& config, const std::string& scripts,
            const FrameLoop* beside = nullptr);

  // The result stays valid until the next step.
  const FrameOutput& step(const FrameInput& input, StageObserver& observer);
  // Runs the stages after vision, from the percepts of an image that was not kept.
  const FrameOutput& stepFrom(const Percepts& seen, const FrameInput& input,
                              StageObserver& observer);

  // The same with something in the place of vision.
  const FrameOutput& stepThrough(Sight& sight, const FrameInput& input, StageObserver& observer);

  const std::string& scriptError() const { return behaviour_.lastError(); }
  const behaviour::RecentReports& reports() const { return behaviour_.reports(); }

 private:
  void sense(const FrameInput& input, StageObserver& observer);
  void decide(const FrameInput& input, StageObserver& observer);

  AgentConfig config_;
  vision::VisionState vision_;
  gps::GpsState gps_;
  behaviour::BehaviourState behaviour_;
  FrameOutput output_;
};

}  // namespace kelpie::agent

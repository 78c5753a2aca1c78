// SPDX-License-Identifier: Apache-2.0
// The class whose one object the SDK's stub generator makes: it includes "Agent.h" and wants a
// global class Agent with a default constructor (openr-measured.md 1, 3). Only for the file that it
// generates; this folder is on no other include path.
#pragma once

#include "robot/agent/Agent.h"
#include "robot/object/Robot.h"

class Agent : private kelpie::object::LateLoops, public kelpie::agent::Agent {
 public:
  Agent() : kelpie::agent::Agent(loops()) {}

  OStatus DoInit(const OSystemEvent& event) override {
    make(*kelpie::object::makeConfig());
    return kelpie::agent::Agent::DoInit(event);
  }
};

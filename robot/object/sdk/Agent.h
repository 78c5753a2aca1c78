// SPDX-License-Identifier: Apache-2.0
// The class whose one object the SDK's stub generator makes: it includes "Agent.h" and wants a
// global class Agent with a default constructor (openr-measured.md 1, 3). Only for the file that it
// generates, and for Entries.cpp in its place; this folder is on no other include path.
#pragma once

#include "robot/object/RobotAgent.h"

class Agent : public kelpie::object::RobotAgent {
 public:
  Agent() : RobotAgent("/MS", kelpie::agent::kRobotPorts) {}
};

// SPDX-License-Identifier: Apache-2.0
// A stand-in robot of which every primitive of the contract is open, by the contract's locators.
#pragma once

#include "robot/agent/AgentIo.h"
#include "robot/openr/Contract.h"
#include "tests/openr/FakeSystem.h"

namespace kelpie::openr {

class OpenedRobot : public FakeSystem {
 public:
  OpenedRobot() {
    for (std::size_t i = 0; i < kJointCount; ++i) ids.joints[i] = open(kJointRows[i].locator);
    for (std::size_t i = 0; i < kSensorCount; ++i) ids.sensors[i] = open(kSensorRows[i].locator);
    for (std::size_t i = 0; i < kLedCount; ++i) ids.leds[i] = open(kLightRows[i].locator);
    for (std::size_t i = 0; i < kEarCount; ++i) ids.ears[i] = open(kEarRows[i]);
  }

  // Undefined for a locator that the robot does not have.
  OPrimitiveID open(const char* locator) {
    OPrimitiveID id = oprimitiveID_UNDEF;
    openPrimitive(locator, &id);
    return id;
  }
  // A command vector as the agent prepares it, of these four ticks.
  OCommandVectorData& commanded(const JointFrame& frame,
                                const agent::Senses& senses = agent::robotSenses()) {
    MemoryRegionID memory = 0;
    OCommandVectorData* vector = nullptr;
    newCommandVector(agent::kCommandCount, &memory, &vector);
    const agent::CommandPlaces places = agent::prepareCommands(*vector, ids);
    std::array<JointFrame, kTicksPerMessage> frames{};
    frames.fill(frame);
    agent::writeCommands(frames, places, *vector, senses);
    return *vector;
  }

  agent::PrimitiveIds ids{};
};

}  // namespace kelpie::openr

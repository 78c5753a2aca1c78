// SPDX-License-Identifier: Apache-2.0
// Where the robot's sensors and images come from on the host, and where its commands go.
// Lock-stepped: after each event the source gets exactly one reply.
#pragma once

#include "robot/core/Expected.h"
#include "robot/core/types/Image.h"
#include "robot/host/world/WorldProtocol.h"

namespace kelpie::host {

// What arrives at one moment. The image counts when step.imagePresent.
struct WorldEvent {
  WorldStep step;
  Image image;
};

class Source {
 public:
  virtual ~Source() = default;

  // Waits for the next event. False: the world said goodbye; an error: one line.
  virtual Expected<bool> next(WorldEvent& event) = 0;
  virtual Status reply(const AgentReply& reply) = 0;
};

}  // namespace kelpie::host

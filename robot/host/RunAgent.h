// SPDX-License-Identifier: Apache-2.0
// Runs Kelpie's OPEN-R object against a source until the world says goodbye. The process around it
// needs no more than
//   auto world = WorldSource::connect(socket, hello, {});
//   Network network;
//   network.control = [&](const ControlPacket& packet, TimeUs now) { loops.hear(packet, now); };
//   const auto summary = runAgent(*world, loops, {}, network);
#pragma once

#include "robot/agent/loops/Loops.h"
#include "robot/host/HostSystem.h"
#include "robot/host/Source.h"

namespace kelpie::host {

Expected<RunSummary> runAgent(Source& source, agent::Loops& loops, const HostParams& params,
                              const Network& network);

}  // namespace kelpie::host

// SPDX-License-Identifier: Apache-2.0
// Runs Kelpie's OPEN-R object against a source until the world says goodbye. The process around it
// needs no more than
//   auto world = WorldSource::connect(socket, hello, {});
//   const auto summary = runAgent(*world, loops, {}, [&](const GameState& g) { loops.setGame(g);
//   });
#pragma once

#include <functional>

#include "robot/agent/Loops.h"
#include "robot/host/HostSystem.h"
#include "robot/host/Source.h"

namespace kelpie::host {

// `onGame`, if any, gets the game state of each step before the step's sensors and image: on the
// robot it comes over the network, not through OPEN-R.
Expected<RunSummary> runAgent(Source& source, agent::Loops& loops, const HostParams& params,
                              const std::function<void(const GameState&)>& onGame);

}  // namespace kelpie::host

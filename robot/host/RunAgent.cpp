// SPDX-License-Identifier: Apache-2.0
#include "robot/host/RunAgent.h"

#include <memory>

#include "robot/agent/Agent.h"
#include "robot/host/AgentStub.h"

namespace kelpie::host {

Expected<RunSummary> runAgent(Source& source, agent::Loops& loops, const HostParams& params,
                              const Network& network) {
  const auto agent = std::make_unique<agent::Agent>(loops);  // holds an image: not on the stack
  HostSystem system(source, params);
  return system.run(agentStub(*agent), network);
}

}  // namespace kelpie::host

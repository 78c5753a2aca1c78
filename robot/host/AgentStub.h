// SPDX-License-Identifier: Apache-2.0
// The agent's entry table, by which the host's dispatcher reaches its methods.
#pragma once

#include "robot/agent/Agent.h"
#include "robot/openr/ObjectStub.h"

namespace kelpie::host {

openr::ObjectStub agentStub(agent::Agent& agent);

}  // namespace kelpie::host

// SPDX-License-Identifier: Apache-2.0
// Takes the orders of a person who watches (tools/sim/staging/LiveOrder.h) from a file that nobody
// waits for, such as standard input, and has world and pace obey them. What cannot be obeyed is
// reported in a line.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/sim/staging/LiveOrder.h"
#include "tools/sim/world/Pace.h"
#include "tools/sim/world/World.h"

namespace kelpie::sim {

class OrderDesk {
 public:
  using Tell = std::function<void(const std::string&)>;
  // `input`: a file descriptor. World and pace must outlive the desk.
  OrderDesk(int input, World& world, Pace& pace, const body::FieldDescription& field,
            std::vector<host::AgentHello> robots, Tell tell);

  // What has come since the last call.
  void hear();

 private:
  void obey(const std::string& line);
  void obey(const LiveOrder& order);

  int input_;
  World& world_;
  Pace& pace_;
  const body::FieldDescription field_;
  std::vector<host::AgentHello> robots_;
  Tell tell_;
  std::string pending_;  // a line whose end has not come
};

}  // namespace kelpie::sim

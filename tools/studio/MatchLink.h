// SPDX-License-Identifier: Apache-2.0
// What passes between the thread that plays a match and the one that serves the studio: orders one
// way, lines for the user the other.
#pragma once

#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "tools/sim/staging/LiveOrder.h"

namespace kelpie::studio {

class MatchLink {
 public:
  MatchLink(const body::FieldDescription& field, std::vector<host::AgentHello> robots)
      : field_(field), robots_(std::move(robots)) {}

  // An error says why the match cannot obey; else it will, unless it is over.
  Status order(const sim::LiveOrder& order);
  // The next of them in words; empty: none.
  std::string nextOrder();
  void say(const std::string& line);
  std::vector<std::string> takeLines();

 private:
  const body::FieldDescription field_;
  const std::vector<host::AgentHello> robots_;
  std::mutex mutex_;
  std::deque<std::string> orders_;
  std::vector<std::string> lines_;
};

}  // namespace kelpie::studio

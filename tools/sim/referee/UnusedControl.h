// SPDX-License-Identifier: Apache-2.0
// What is said of packets at a game controller's port that nothing is made of. A program of another
// year is named by the version that it sends, since a person can do something about that; the rest
// by its reason. Each is said once, however often it comes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/core/types/ControlPacket.h"

namespace kelpie::sim {

class UnusedControl {
 public:
  explicit UnusedControl(std::uint16_t port) : port_(port) {}

  // A line, or nothing because it has been said.
  std::optional<std::string> lineFor(const ControlPacket& packet, ControlRefusal refusal);

 private:
  std::uint16_t port_;
  std::vector<std::string> said_;
};

}  // namespace kelpie::sim

// SPDX-License-Identifier: Apache-2.0
// The agent's end of the line to a driver. Lock-stepped as the world is: the agent waits for the
// answer, so that keys of a script come at the same frames however fast the machine is. When the
// driver is gone the answer is to stand.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/core/types/FrameOutput.h"
#include "robot/host/world/Connection.h"
#include "robot/host/world/DriverProtocol.h"

namespace kelpie::host {

class DriverLink {
 public:
  // Joins the driver that listens, or will soon, at the path.
  static Expected<DriverLink> connect(const std::string& path);
  explicit DriverLink(Connection connection);

  // The driver's answer stands in drive() afterwards, after an error as well.
  Status tell(const FrameInput& input, const FrameOutput& output);
  // Present from the start: a robot that waits for its driver does not play.
  const Drive& drive() const { return drive_; }

 private:
  Connection connection_;
  std::unique_ptr<DriverView> view_ = std::make_unique<DriverView>();  // on the heap for its size
  std::vector<std::uint8_t> body_;
  Drive drive_{true, {}};
};

}  // namespace kelpie::host

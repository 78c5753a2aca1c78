// SPDX-License-Identifier: Apache-2.0
#include "robot/object/RobotAgent.h"

#include <OPENR/OSyslog.h>

#include <algorithm>
#include <array>
#include <string>

#include "behaviour/Behaviour.h"

namespace kelpie::object {

OStatus RobotAgent::DoInit(const OSystemEvent& event) {
  readStick();
  return agent::Agent::DoInit(event);
}

// The configuration is on the heap, because the stack has no room for its 185 KB; the loops keep
// their own, and it is given back.
void RobotAgent::readStick() {
  const auto config = makeConfig();
  const stick::StickVerdict verdict = reader.load(*config);
  const auto line = stick::lineOf(verdict);
  std::array<char, decltype(line)::kCapacity + 1> text{};
  std::copy(line.begin(), line.end(), text.begin());
  if (verdict.good()) {
    loops.make(*config, std::string(root) + "/" + stick::kScriptsPath);
    OSYSLOG1((osyslogINFO, "stick: %s; player %u, %s", text.data(), unsigned(config->player),
              behaviour::playerName()));
  } else {
    loops.refuse(static_cast<std::uint8_t>(verdict.fault));
    OSYSLOG1((osyslogERROR, "stick: %s; the robot does not play", text.data()));
  }
}

void RobotAgent::frameDone() {
  std::string line;
  if (loops.takeComplaint(line)) OSYSLOG1((osyslogERROR, "behaviour: %s", line.c_str()));
}

}  // namespace kelpie::object

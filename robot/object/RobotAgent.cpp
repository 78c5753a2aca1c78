// SPDX-License-Identifier: Apache-2.0
#include "robot/object/RobotAgent.h"

#include <OPENR/OSyslog.h>

#include <algorithm>
#include <array>
#include <string>

#include "behaviour/Behaviour.h"
#include "robot/body/Lights.h"

namespace kelpie::object {

namespace {
// Two vectors are in flight, and one is being filled.
constexpr std::uint32_t kSeenAfter = 4;
}  // namespace

void RobotAgent::beforeMotion() {
  switch (boot_) {
    case Boot::begins:
      loops.show(body::kLightReading);
      reader.begin();
      boot_ = Boot::reads;
      return;
    case Boot::reads:
      if (!reader.step()) takeStick();
      return;
    case Boot::startsPython:
      if (--waits_ > 0) return;
      loops.make(*config_, std::string(root) + "/" + stick::kScriptsPath);
      config_.reset();
      boot_ = Boot::done;
      return;
    case Boot::done: return;
  }
}

// The configuration is on the heap, because the stack has no room for its 258 KB.
void RobotAgent::takeStick() {
  config_ = makeConfig();
  const stick::StickVerdict verdict = reader.load(*config_);
  const auto line = stick::lineOf(verdict);
  std::array<char, decltype(line)::kCapacity + 1> text{};
  std::copy(line.begin(), line.end(), text.begin());
  boot_ = verdict.good() ? Boot::startsPython : Boot::done;
  waits_ = kSeenAfter;
  if (verdict.good()) {
    loops.show(body::kLightReading | body::kLightPython);
    OSYSLOG1((osyslogINFO, "stick: %s; player %u, %s", text.data(), unsigned(config_->player),
              behaviour::playerName()));
  } else {
    loops.refuse(static_cast<std::uint8_t>(verdict.fault));
    OSYSLOG1((osyslogERROR, "stick: %s; the robot does not play", text.data()));
  }
}

void RobotAgent::frameDone() {
  while (const behaviour::ReportLine* const line = loops.takeLine())
    OSYSLOG1((line->fault ? osyslogERROR : osyslogINFO, "behaviour: %s", line->text.c_str()));
}

}  // namespace kelpie::object

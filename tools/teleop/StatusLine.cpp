// SPDX-License-Identifier: Apache-2.0
#include "tools/teleop/StatusLine.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "actuator/MotionList.h"

namespace kelpie::teleop {
namespace {

constexpr std::array<const char*, kFallSideCount> kSides = {"", "its nose", "its back",
                                                            "its left side", "its right side"};

// "  ahead 10 cm/s", nothing for 0.
std::string amount(double value, const char* positive, const char* negative, const char* unit) {
  if (std::fabs(value) < 0.5) return "";
  return fmt::format("  {} {:.0f} {}", value > 0.0 ? positive : negative, std::fabs(value), unit);
}

std::string walkText(const WalkRequest& walk) {
  const std::string text =
      amount(walk.forward, "ahead", "back", "cm/s") + amount(walk.left, "left", "right", "cm/s") +
      amount(walk.turn * 180.0 / maths::kPi, "turn left", "turn right", "deg/s");
  return text.empty() ? "  stands" : text;
}

std::string motionText(const host::DriverView& view) {
  const MotionStatus& motion = view.motion;
  if (!motion.ready) return "  getting ready";
  if (motion.running != MotionKind::none)
    return fmt::format("  {} {:.1f} s", actuator::listed(motion.running).word, motion.secondsLeft);
  if (view.command.motion != MotionKind::none)
    return fmt::format("  {} asked for", actuator::listed(view.command.motion).word);
  return "";
}

std::string ballText(const host::DriverView& view) {
  if (view.motion.feeling.ballHeld) return "  ball HELD";
  if (!view.ball.present) return "  no ball";
  return fmt::format("  ball {:.0f} cm {:.0f} deg {}", view.ball.distance,
                     view.ball.heading.abs().deg(),
                     view.ball.heading.rad() >= 0 ? "left" : "right");
}

std::string headText(const HeadRequest& head) {
  if (head.aim != HeadAim::direction) return "";
  const std::string text = amount(head.direction.deg(), "left", "right", "deg") +
                           amount(head.elevation.deg(), "up", "down", "deg");
  return "  head" + (text.empty() ? "  level" : text);
}

}  // namespace

std::string statusLine(const host::DriverView& view) {
  std::string text = fmt::format("{:6.1f} s", view.time.seconds());
  const FallSide fallen = view.motion.feeling.fallen;
  if (fallen != FallSide::none)
    text += fmt::format("  FALLEN on {}", kSides[static_cast<std::size_t>(fallen)]);
  text += motionText(view) + walkText(view.command.walk) + ballText(view);
  return text + headText(view.command.head);
}

}  // namespace kelpie::teleop

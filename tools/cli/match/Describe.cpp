// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/match/Describe.h"

#include <fmt/core.h>

namespace kelpie::cli {

std::string describe(const FrameInput& input, const FrameOutput& output) {
  const auto& world = output.world;
  std::string text = fmt::format("{:6.1f} s  me ({:.0f}, {:.0f}) {:.0f} deg +-{:.0f} cm",
                                 output.time.seconds(), world.pose.position.x,
                                 world.pose.position.y, world.pose.heading.deg(), world.positionSd);
  if (world.ball.present)
    text += fmt::format("  ball {:.0f} cm {:.0f} deg {}", world.ball.distance,
                        world.ball.heading.abs().deg(),
                        world.ball.heading.rad() >= 0 ? "left" : "right");
  else
    text += "  no ball";
  if (isKick(output.command.motion)) text += "  KICK";
  if (output.command.fallback != Fallback::none) text += "  FALLBACK";
  if (input.droppedFrames > 0) text += fmt::format("  {} frames dropped", input.droppedFrames);
  return text;
}

}  // namespace kelpie::cli

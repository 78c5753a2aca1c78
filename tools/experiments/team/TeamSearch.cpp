// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/team/TeamSearch.h"

#include <algorithm>

namespace kelpie::experiments {
namespace {

bool sees(const TeamMatch& match, const TeamRobot& robot, const TeamFrame& frame) {
  const sim::TruthFrame& truth = match.at(frame.seconds + kFrameSeconds);
  for (const sim::RobotTruth& one : truth.robots)
    if (robot.is(one)) return isBall(frame.seen, one.pose, truth.ball);
  return false;
}

std::optional<double> foundBy(const TeamMatch& match, const TeamRobot& robot, double thrown) {
  bool before = false;
  for (const TeamFrame& frame : robot.frames) {
    const double since = frame.seconds - thrown;
    if (since < kFrameSeconds) continue;
    const bool now = sees(match, robot, frame);
    if (now && before) return since - kFrameSeconds;
    before = now;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> foundAfter(const TeamMatch& match, TeamColour team, double thrown) {
  std::optional<double> first;
  for (const TeamRobot& robot : match.robots) {
    if (robot.team != team) continue;
    const auto found = foundBy(match, robot, thrown);
    if (found) first = std::min(*found, first.value_or(*found));
  }
  return first;
}

}  // namespace kelpie::experiments

// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/skills/Tries.h"

#include "tools/cli/DataFolder.h"

namespace kelpie::experiments {

Status playTries(const Request& request, const Tries& tries) {
  const auto tryOf = [&](int number) {
    return Try{static_cast<std::size_t>(number / tries.each),
               trialOf(request, number % tries.each)};
  };
  Matches matches;
  matches.count = static_cast<int>(tries.ways.size()) * tries.each;
  matches.session = [&](int number) {
    const Try one = tryOf(number);
    cli::SessionOptions session = sessionOf(request, one.trial);
    session.set = tries.ways[one.way].set;
    session.keepFrames = true;
    tries.setUp(one, session);
    return session;
  };
  matches.judge = [&](int number, const cli::SessionResult& result, const Played& played) {
    tries.judge(tryOf(number), result, played);
  };
  return playMatches(request, matches);
}

sim::RobotPlace placed(TeamColour team, const Pose2& pose, std::uint8_t player) {
  return {{team, player}, pose};
}

void addKeeper(PlayerKind player, cli::SessionOptions& session) {
  cli::OtherRobot keeper;
  keeper.seed = session.seed;
  keeper.set = {"behaviour.task.player=" + std::to_string(static_cast<int>(player))};
  session.others.push_back(keeper);
}

void addStanding(const Pose2& pose, cli::SessionOptions& session, std::uint8_t player) {
  cli::OtherRobot standing;
  standing.player = player;
  standing.seed = session.seed;
  standing.pycode = cli::dataFolder() + "/tools/experiments/skills/standing";
  session.others.push_back(standing);
  session.staging.places.push_back(placed(TeamColour::blue, pose, player));
}

Angle headingTo(Point2<Field> from, Point2<Field> to) {
  return Angle::rad(maths::atan2(to.y - from.y, to.x - from.x));
}

std::optional<double> crossing(const Shot& shot, double length) {
  const maths::SinCos way = shot.direction.sinCos();
  if (way.sin <= 0.0) return std::nullopt;
  return shot.from.x + (length - shot.from.y) * way.cos / way.sin;
}

}  // namespace kelpie::experiments

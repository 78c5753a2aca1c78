// SPDX-License-Identifier: Apache-2.0
#include "tools/session/SceneSession.h"

#include <fmt/core.h>

#include "robot/core/Random.h"
#include "tools/sim/rules/MatchScene.h"
#include "tools/sim/staging/Scenes.h"

namespace kelpie::cli {
namespace {

constexpr double kPlaceSd = 10.0, kHeadingSd = 5.0;  // cm, deg: of the places that robots are told

std::vector<std::string> beliefOf(const Pose2& pose, Random& random) {
  constexpr const char* kPose = "gps.initialPose.pose";
  const auto off = [&](double sd) { return random.gaussian(0.0, sd); };
  return {"gps.initialPose.present=true",
          fmt::format("{}.position.x={:.3f}cm", kPose, pose.position.x + off(kPlaceSd)),
          fmt::format("{}.position.y={:.3f}cm", kPose, pose.position.y + off(kPlaceSd)),
          fmt::format("{}.heading={:.3f}deg", kPose,
                      (pose.heading + Angle::deg(off(kHeadingSd))).deg())};
}

void tell(const sim::RobotPlace& place, const std::vector<std::string>& words,
          SessionOptions& options) {
  const std::string team = place.robot.team == TeamColour::red ? "red" : "blue";
  const auto append = [&](std::vector<std::string>& set) {
    set.insert(set.end(), words.begin(), words.end());
  };
  if (options.team == team && options.player == place.robot.player) return append(options.set);
  for (OtherRobot& robot : options.others)
    if (robot.team == team && robot.player == place.robot.player) append(robot.set);
}

}  // namespace

Status useScene(const std::string& kind, TeamPlan plan, SessionOptions& options) {
  const auto field = body::fieldDescription(options.field);
  if (!field) return Error{field.error()};
  const auto scene = sim::drawScene(kind, *field, options.seed);
  if (!scene) return Error{scene.error()};
  const auto counts = teamPlan(scene->robots);
  if (!counts) return Error{counts.error()};
  plan.red = counts->red;
  plan.blue = counts->blue;
  const Status used = useTeams(plan, options);
  if (!used) return used;
  options.fromPlay = true;
  options.staging = scene->staging;
  options.seconds = scene->seconds;
  options.goals = 1;
  Random random(Random(options.seed ^ 0x7e11ULL).next());
  for (const sim::RobotPlace& place : scene->staging.places) {
    std::vector<std::string> told =
        beliefOf(sim::ownView(*field, place.robot.team, place.pose), random);
    if (place.robot.player == 1) told.emplace_back(kKeeps);  // also its team's only robot
    tell(place, told, options);
  }
  return Done{};
}

}  // namespace kelpie::cli

// SPDX-License-Identifier: Apache-2.0
// Grab and dribble (checklist ): a ball anywhere around a robot in the middle of the
// field. What counts is the truth: whether the ball was held, went along or round with the robot
// and left it again, and whether any hold broke the rules of 3 s and 50 cm.
#include "tools/experiments/skills/Judges.h"
#include "tools/experiments/skills/Tries.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 20.0;    // of a try
constexpr double kNearest = 50.0;    // cm, of the ball
constexpr double kFurthest = 120.0;  // cm

void setUp(const Try& one, cli::SessionOptions& session) {
  Random random = drawsOf(one);
  const Pose2 robot{{random.uniform(120.0, 240.0), random.uniform(190.0, 300.0)},
                    Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
  const Point2<Robot> ball = robotPolar(random.uniform(kNearest, kFurthest),
                                        Angle::rad(random.uniform(-maths::kPi, maths::kPi)));
  session.staging.places = {placed(TeamColour::red, robot)};
  session.staging.ball = sim::Ball{fieldFromRobot(robot, ball), {}};
  session.seconds = kSeconds;
}

Expected<Json> grabDribble(const Request& request) {
  Share kept;
  Share success;
  int tooLong = 0;
  int tooFar = 0;
  std::vector<Grabbed> all(static_cast<std::size_t>(request.trials));
  Tries tries;
  tries.ways = {{"grab", {}}};
  tries.each = request.trials;
  tries.setUp = setUp;
  tries.judge = [&](const Try& one, const cli::SessionResult&, const Played& played) {
    all[static_cast<std::size_t>(one.trial.number)] = grabbedIn(played);
  };
  const Status played = playTries(request, tries);
  if (!played) return Error{played.error()};
  Values holds;
  Values grabs;
  Values quickGrabs;
  Json failed = Json::array();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Grabbed& found = all[i];
    kept.count(found.kept);
    success.count(found.success);
    tooLong += found.tooLong;
    tooFar += found.tooFar;
    append(found.holds, holds);
    append(found.grabs, grabs);
    append(found.quickGrabs, quickGrabs);
    if (!found.success || found.tooLong + found.tooFar > 0) failed.push_back(request.seed + i);
  }
  return Json{{"success", success.value()},
              {"kept_rate", kept.value()},
              {"violations_3s", tooLong},
              {"violations_50cm", tooFar},
              {"grabs", grabs.size() + quickGrabs.size()},
              {"grab_frames", percentile(grabs, 0.5)},
              {"grab_frames_quick", percentile(quickGrabs, 0.5)},
              {"holds", holds.size()},
              {"hold_mean_s", mean(holds)},
              {"hold_longest_s", percentile(holds, 1.0)},
              {"seeds_to_look_at", failed}};
}

const Registration kGrabDribble(
    "grab-dribble", "a ball around a robot: grabbed, carried and released within 3 s and 50 cm",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 60,
    grabDribble);

}  // namespace
}  // namespace kelpie::experiments

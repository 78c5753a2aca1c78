// SPDX-License-Identifier: Apache-2.0
// A rolling ball met where it will be, beside walking at it, by the same seeds: balls that roll
// past in front of the robot over the side line beside it, at 20 to 80 cm/s. Who stands sees those
// from about 50 cm/s leave; a slower one stops less than its radius beyond the line, which is not
// out.
#include <array>
#include <cmath>

#include "tools/experiments/skills/Judges.h"
#include "tools/experiments/skills/Tries.h"

namespace kelpie::experiments {
namespace {

constexpr double kThrown = 2.5;     // s: the robot has got up and begun to walk
constexpr double kAfter = 6.0;      // s after the throw that a try goes on
constexpr double kToLine = 40.0;    // cm from the robot to the side line beside it
constexpr double kBeforeEnd = 0.9;  // of its whole way a ball has gone at the line
constexpr double kSlowest = 20.0;   // cm/s
constexpr double kFastest = 80.0;

enum : std::size_t { kIntercepting, kChasing, kVariants };

// dv/dt = -(k v + friction), to its end (sim::BallParams).
double wayOf(double speed) {
  const sim::BallParams ball;
  const double k = -maths::log(ball.keptPerFrame) / kFrameSeconds;
  return speed / k - ball.friction / (k * k) * maths::log(1.0 + k * speed / ball.friction);
}

// Each trial has its share of the speeds, drawn within it.
double speedOf(const Try& one, int trials, Random& random) {
  const double share = (one.trial.number % trials + random.uniform()) / trials;
  return kSlowest + (kFastest - kSlowest) * share;
}

void setUp(const Try& one, int trials, cli::SessionOptions& session) {
  Random random = drawsOf(one);
  const double side = random.chance(0.5) ? 1.0 : -1.0;  // the line to the right or to the left
  const Pose2 robot{{180.0 + side * (180.0 - kToLine), random.uniform(120.0, 280.0)},
                    Angle::deg(90.0)};
  const double speed = speedOf(one, trials, random);
  const double path = kBeforeEnd * wayOf(speed);
  const Angle slant = Angle::deg(random.uniform(0.0, 35.0));  // towards the robot
  const double ahead = random.uniform(20.0, 45.0);            // where it crosses the line
  const maths::SinCos way = slant.sinCos();
  const Point2<Field> start{side * (kToLine - path * way.cos), ahead + path * way.sin};
  session.staging.places = {placed(TeamColour::red, robot)};
  session.staging.ball = sim::Ball{fieldFromRobot(robot, {0.0, 150.0}), {}};
  session.staging.throws = {{kThrown,
                             {start, {side * speed * way.cos, -speed * way.sin}},
                             host::AgentHello{TeamColour::red, 1}}};
  session.seconds = kThrown + kAfter;
  session.goals = 0;
}

Json figuresOf(const std::vector<Met>& all) {
  Share reached;
  Share kept;
  Values seconds;
  for (const Met& found : all) {
    reached.count(found.reached);
    kept.count(found.kept);
    seconds.push_back(found.seconds);
  }
  return Json{{"reached_rate", reached.value()},
              {"kept_rate", kept.value()},
              {"median_s", percentile(seconds, 0.5)}};
}

Expected<Json> intercept(const Request& request) {
  std::array<std::vector<Met>, kVariants> found;
  for (auto& all : found) all.resize(static_cast<std::size_t>(request.trials));
  Tries tries;
  tries.ways = {{"intercept", {"behaviour.task.intercept=true"}},
                {"walk_at", {"behaviour.task.intercept=false"}}};
  tries.each = request.trials;
  tries.setUp = [&](const Try& one, cli::SessionOptions& session) {
    setUp(one, request.trials, session);
  };
  tries.judge = [&](const Try& one, const cli::SessionResult&, const Played& played) {
    found[one.way][static_cast<std::size_t>(one.trial.number)] = metIn(played, kThrown, kAfter);
  };
  const Status played = playTries(request, tries);
  if (!played) return Error{played.error()};
  return Json{{"intercept", figuresOf(found[kIntercepting])},
              {"walk_at", figuresOf(found[kChasing])}};
}

const Registration kIntercept(
    "intercept", "balls that roll over the side line: reached, by intercept or walking at",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 20,
    intercept);

}  // namespace
}  // namespace kelpie::experiments

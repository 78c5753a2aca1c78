// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/challenge/Challenge.h"

#include <algorithm>

#include "robot/core/Random.h"
#include "tools/cli/options/Config.h"

namespace kelpie::experiments {
namespace {

constexpr double kSlant = 8.0;        // cm of the wall's corners
constexpr double kMeasured = 1.0;     // cm, sd of the corners as given to the robot
constexpr double kStartReach = 80.0;  // cm from the middle at the start
constexpr double kFromLines = 40.0;   // cm, of the points and of the place carried to
constexpr double kMinBetween = 80.0;  // cm between two points

Point2<Field> somewhere(const body::FieldDescription& field, Random& random) {
  const double x = random.uniform(kFromLines, field.width - kFromLines);
  return {x, random.uniform(kFromLines, field.length - kFromLines)};
}

Angle anyHeading(Random& random) { return Angle::rad(random.uniform(-maths::kPi, maths::kPi)); }

Points randomPoints(const body::FieldDescription& field, Random& random) {
  Points points;
  while (points.size() < kPoints) {
    const Point2<Field> point = somewhere(field, random);
    const bool near = std::any_of(points.begin(), points.end(), [&](Point2<Field> other) {
      return distance(point, other) < kMinBetween;
    });
    if (!near) points.push_back(point);
  }
  return points;
}

}  // namespace

Challenge challengeOf(const body::FieldDescription& field, std::uint64_t seed) {
  Random random(seed ^ 0x51a4ULL);
  Challenge challenge;
  challenge.wall = sim::outerWall(field, kSlant, random.next());
  challenge.points = randomPoints(field, random);
  const double x = 0.5 * field.width + random.uniform(-kStartReach, kStartReach);
  challenge.start.position = {x, 0.5 * field.length + random.uniform(-kStartReach, kStartReach)};
  challenge.start.heading = anyHeading(random);
  challenge.carried.position = somewhere(field, random);
  challenge.carried.heading = anyHeading(random);
  for (std::size_t i = 0; i < 4; ++i) {
    challenge.measured[2 * i] = challenge.wall.corners[i].x + random.gaussian(0.0, kMeasured);
    challenge.measured[2 * i + 1] = challenge.wall.corners[i].y + random.gaussian(0.0, kMeasured);
  }
  return challenge;
}

namespace {

void configure(const Challenge& challenge, agent::AgentConfig& config) {
  config.vision.pink.onField = false;
  config.gps.pinks.wall = challenge.measured;
  config.behaviour.task.player = PlayerKind::challenger;
  for (std::size_t i = 0; i < kPoints; ++i) {
    config.behaviour.task.points[2 * i] = challenge.points[i].x;
    config.behaviour.task.points[2 * i + 1] = challenge.points[i].y;
  }
}

Status halfTime(const Challenge& challenge, LocaliseMatch& match,
                const LocaliseMatch::Watcher& watch) {
  match.halt(true);
  const Status before = match.play(kStage1 + 0.5 * kHalt, watch);
  if (!before) return before;
  const Status hidden = match.world().takeLandmarksAway();
  if (!hidden) return hidden;
  const Status carried = match.world().carry(0, challenge.carried);
  if (!carried) return carried;
  const Status after = match.play(kStage1 + kHalt, watch);
  match.halt(false);
  return after;
}

}  // namespace

Status playChallenge(const ChallengeRun& run, const Challenge& challenge,
                     const ChallengeWatch& watch) {
  agent::AgentConfig config = run.config;
  configure(challenge, config);
  LocaliseMatch match(config, cli::defaultScripts(), run.seed, run.randomised);
  Status status = match.world().putUp(challenge.wall);
  if (!status) return status;
  match.world().putBall({{4.0, 4.0}, {}});  // nobody plays with it
  status = match.world().carry(0, challenge.start);
  if (!status) return status;
  status = match.play(kStage1, watch.frame);
  if (!status) return status;
  if (watch.mapped) watch.mapped();
  status = halfTime(challenge, match, watch.frame);
  const double begin = kStage1 + kHalt;
  for (double time = 1.0; status && time <= kStage2 && !(watch.over && watch.over()); time += 1.0)
    status = match.play(begin + time, watch.frame);
  return status;
}

}  // namespace kelpie::experiments

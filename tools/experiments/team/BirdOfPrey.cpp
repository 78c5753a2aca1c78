// SPDX-License-Identifier: Apache-2.0
// The way home past who stands on it (checklist A-4.3.3.6): a forward far up the field must go home
// to defend, since a mate at the ball attacks, and two opponents stand about the straight line. On
// a curve round them and straight, by the same seeds; until it is home by its true place.
#include <array>

#include "tools/cli/DataFolder.h"
#include "tools/experiments/skills/Tries.h"
#include "tools/experiments/team/WayHome.h"

namespace kelpie::experiments {
namespace {

constexpr double kLimit = 40.0;  // s of a try; the way is 300 to 350 cm
constexpr std::uint8_t kHomer = 2;
constexpr std::uint8_t kMate = 3;
constexpr double kBeside = 45.0;  // cm from the ball to the mate: no way to the goal is kept free

enum : std::size_t { kCurved, kStraight, kVariants };

void addAttackingMate(Point2<Field> ball, cli::SessionOptions& session) {
  cli::OtherRobot mate;
  mate.team = "red";
  mate.player = kMate;
  mate.seed = session.seed;
  mate.pycode = cli::dataFolder() + "/tools/experiments/team/attacking";
  session.others.push_back(mate);
  const Pose2 pose{ball + Point2<Field>{0.0, kBeside}, Angle::deg(-90.0)};
  session.staging.places.push_back(placed(TeamColour::red, pose, kMate));
}

// Where the robot will defend: algorithm 4.9 of thesis 2006 for a ball in its own third.
Point2<Field> homeFor(Point2<Field> ball) { return {180.0 + (ball.x - 180.0) / 3.0, 100.0}; }

void setUp(const Try& one, cli::SessionOptions& session) {
  Random random = drawsOf(one);
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  // In its own corner, off any way home: a ball that it passes nearer than the mate stands is its
  // own to play.
  const Point2<Field> ball{180.0 + side * random.uniform(130.0, 145.0), random.uniform(60.0, 90.0)};
  const Pose2 start{{180.0 + side * random.uniform(-50.0, 50.0), random.uniform(410.0, 450.0)},
                    Angle::deg(random.uniform(-150.0, -30.0))};
  session.team = "red";
  session.player = kHomer;
  session.seconds = kLimit;
  session.scenario = "kickoff";
  session.staging.places = {placed(TeamColour::red, start, kHomer)};
  session.staging.ball = sim::Ball{ball, {}};
  addAttackingMate(ball, session);
  const Point2<Field> way = homeFor(ball) - start.position;
  const Point2<Field> across = Point2<Field>{-way.y, way.x} * (1.0 / way.norm());
  std::uint8_t player = 1;
  for (const double share : {0.35, 0.65}) {
    const Point2<Field> middle =
        start.position + way * share + across * random.uniform(-12.0, 12.0);
    addStanding({middle, Angle::rad(random.uniform(-maths::kPi, maths::kPi))}, session, player++);
  }
}

Json figuresOf(const std::vector<WayHome>& all) {
  Share home;
  Share touched;
  Values seconds;
  Values contacts;
  for (const WayHome& way : all) {
    home.count(way.home.has_value());
    touched.count(way.touched());
    seconds.push_back(way.home.value_or(kLimit));
    contacts.push_back(way.contacts);
  }
  return Json{{"home_rate", home.value()},
              {"median_s", percentile(seconds, 0.5)},
              {"p90_s", percentile(seconds, 0.9)},
              {"contacts_per_try", mean(contacts)},
              {"touched_rate", touched.value()}};
}

// Of pairs, by how much the straight way took longer.
Values gained(const std::vector<WayHome>& curved, const std::vector<WayHome>& straight) {
  Values seconds;
  for (std::size_t i = 0; i < curved.size(); ++i)
    seconds.push_back(straight[i].home.value_or(kLimit) - curved[i].home.value_or(kLimit));
  return seconds;
}

Expected<Json> birdOfPrey(const Request& request) {
  std::array<std::vector<WayHome>, kVariants> found;
  for (auto& all : found) all.resize(static_cast<std::size_t>(request.trials));
  Tries tries;
  tries.ways = {{"bird_of_prey", {"behaviour.task.birdOfPrey=true"}},
                {"straight", {"behaviour.task.birdOfPrey=false"}}};
  tries.each = request.trials;
  tries.setUp = setUp;
  tries.judge = [&](const Try& one, const cli::SessionResult&, const Played& played) {
    found[one.way][static_cast<std::size_t>(one.trial.number)] = wayHomeOf(played, kHomer);
  };
  const Status played = playTries(request, tries);
  if (!played) return Error{played.error()};
  const Values gain = gained(found[kCurved], found[kStraight]);
  return Json{{"gained_median_s", percentile(gain, 0.5)},
              {"gained_mean_s", mean(gain)},
              {"bird_of_prey", figuresOf(found[kCurved])},
              {"straight", figuresOf(found[kStraight])}};
}

const Registration kBirdOfPrey(
    "bird-of-prey", "two opponents on the way home: seconds and contacts, on a curve, straight",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 40,
    birdOfPrey);

}  // namespace
}  // namespace kelpie::experiments

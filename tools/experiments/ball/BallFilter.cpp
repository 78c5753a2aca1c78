// SPDX-License-Identifier: Apache-2.0
// The ball filter on balls that lie and balls that roll, seen standing and walking: errors of place
// and velocity, the speed of a lying ball, and where a rolling one will lie. Two cases pull against
// each other: a ball whose last sighting before the head turns away is wrong, which is no kick, and
// one that somebody kicks in view, which is.
#include <algorithm>
#include <cmath>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/players/Player.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::experiments {
namespace {

constexpr double kSight = 0.5;      // s of sight until the end is predicted
constexpr double kSettled = 0.3;    // s until errors count
constexpr double kMinRange = 30.0;  // cm
constexpr double kMaxRange = 300.0;
constexpr double kRecall = 0.97;
constexpr double kWatched = 1.5;      // s that a lying ball is seen
constexpr double kUnseen = 1.0;       // s after its last sighting
constexpr double kFalseSds = 4.0;     // how far off the last bearing is
constexpr double kKickWatched = 0.3;  // s after a kick

struct Errors {
  Values position;
  Values velocity;
  Values speed;  // of a ball that lies
  Values stop;
};

struct JumpErrors {
  Values position;
  Values velocity;
};

// A walk whose speed is drawn again every second or two.
class Stroll {
 public:
  explicit Stroll(std::uint64_t seed) : random_(seed) {}
  WalkSpeed next() {
    left_ -= kFrameSeconds;
    if (left_ <= 0.0) {
      left_ = random_.uniform(0.8, 2.0);
      speed_ = {random_.uniform(-5.0, 22.0), random_.uniform(-10.0, 10.0),
                random_.uniform(-0.6, 0.6)};
    }
    return speed_;
  }

 private:
  Random random_;
  WalkSpeed speed_;
  double left_ = 0.0;
};

struct Scene {
  Player player;
  sim::Ball ball;
  Stroll stroll;
  Random random;
  bool walks;
};

Scene sceneOf(std::uint64_t seed, double speed, bool walks) {
  Random random(seed);
  const Pose2 pose{{180.0, 200.0}, Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
  const Angle at = Angle::rad(random.uniform(-maths::kPi, maths::kPi));
  const double range = random.uniform(40.0, 200.0);
  Scene scene{Player(pose, 1, random.next()),
              {fieldFromRobot(pose, robotPolar(range, at)), {}},
              Stroll(random.next()),
              Random(random.next()),
              walks};
  const double way = random.uniform(-maths::kPi, maths::kPi);
  scene.ball.velocity = {speed * maths::cos(way), speed * maths::sin(way)};
  scene.player.believe(pose, 1.0, Angle::deg(0.5));
  return scene;
}

// The ball's velocity in the robot's frame, by the pose given.
Point2<Robot> turned(const Pose2& pose, Point2<Field> velocity) {
  return robotFromField({{}, pose.heading}, velocity);
}

Point2<Field> endOf(sim::Ball ball) {
  for (int i = 0; i < 2000; ++i) sim::roll(ball, 0.01, {});
  return ball.position;
}

// Compared in the robot's frame: the pose has its own experiments.
double stopError(const Scene& scene, const WorldModel& world) {
  const Point2<Robot> believed = robotFromField(world.pose, world.ball.stoppingPoint);
  return distance(believed, robotFromField(scene.player.truth.pose(), endOf(scene.ball)));
}

double positionError(const Scene& scene, const WorldModel& world) {
  return distance(world.ball.relative,
                  robotFromField(scene.player.truth.pose(), scene.ball.position));
}

// The ball's velocity in the robot's frame as believed, beside the true one.
double velocityError(const Scene& scene, const WorldModel& world) {
  return distance(turned(world.pose, world.ball.velocity),
                  turned(scene.player.truth.pose(), scene.ball.velocity));
}

// One frame; true when the ball was there to be seen.
bool advance(Scene& scene, WorldModel& world) {
  scene.player.walk(scene.walks ? scene.stroll.next() : WalkSpeed{});
  sim::roll(scene.ball, kFrameSeconds, {});
  const double range = distance(scene.player.truth.pose().position, scene.ball.position);
  if (range < kMinRange || range > kMaxRange) return false;
  scene.player.turnHead(scene.player.bearingOf(scene.ball.position).rad());
  if (scene.random.chance(kRecall)) scene.player.lookAtBall(scene.ball.position);
  world = scene.player.step();
  return true;
}

void rolling(std::uint64_t seed, bool walks, Errors& errors) {
  Random random(seed);
  Scene scene = sceneOf(random.next(), random.uniform(30.0, 150.0), walks);
  WorldModel world;
  for (double time = kFrameSeconds; time < 3.0; time += kFrameSeconds) {
    if (!advance(scene, world)) return;
    if (time > kSight - 1e-6 && time < kSight + kFrameSeconds - 1e-6 && world.ball.present)
      errors.stop.push_back(stopError(scene, world));
    if (time < kSettled || !world.ball.present) continue;
    errors.position.push_back(positionError(scene, world));
    errors.velocity.push_back(velocityError(scene, world));
  }
}

void lying(std::uint64_t seed, bool walks, bool oscillation, Errors& errors) {
  Scene scene = sceneOf(seed, 0.0, walks);
  scene.player.noise.ball.oscillation = oscillation;
  WorldModel world;
  for (double time = kFrameSeconds; time < 4.0; time += kFrameSeconds) {
    if (!advance(scene, world)) return;
    if (time < 1.0 || !world.ball.present) continue;
    errors.speed.push_back(world.ball.velocity.norm());
  }
}

bool watch(Scene& scene, WorldModel& world) {
  for (double time = 0.0; time < kWatched; time += kFrameSeconds)
    if (!advance(scene, world)) return false;
  return world.ball.present;
}

// The last sighting's bearing is so many standard deviations off; then the head looks away. The
// velocity is judged right after it, the place a second later.
void falseLast(std::uint64_t seed, double speed, double sds, JumpErrors& errors) {
  Scene scene = sceneOf(seed, speed, true);
  WorldModel world;
  if (!watch(scene, world)) return;
  for (double time = 0.0; time < kUnseen + 1e-6; time += kFrameSeconds) {
    const double away = time > 0.0 ? maths::kPi / 2 : 0.0;
    scene.player.walk(scene.stroll.next());
    sim::roll(scene.ball, kFrameSeconds, {});
    scene.player.turnHead(scene.player.bearingOf(scene.ball.position).rad() + away);
    BallPercept& ball = scene.player.percepts.ball;
    if (time == 0.0) scene.player.lookAtBall(scene.ball.position);
    ball.heading = ball.heading + Angle::rad(sds * std::sqrt(ball.headingVariance));
    world = scene.player.step();
    if (time == 0.0) errors.velocity.push_back(velocityError(scene, world));
  }
  errors.position.push_back(positionError(scene, world));
}

// Somebody else kicks the lying ball in view.
void kicked(std::uint64_t seed, JumpErrors& errors) {
  Scene scene = sceneOf(seed, 0.0, true);
  WorldModel world;
  if (!watch(scene, world)) return;
  const double way = scene.random.uniform(-maths::kPi, maths::kPi);
  const double speed = scene.random.uniform(80.0, 200.0);
  scene.ball.velocity = {speed * maths::cos(way), speed * maths::sin(way)};
  for (double time = 0.0; time < kKickWatched - 1e-6; time += kFrameSeconds) {
    if (!advance(scene, world)) return;
    errors.position.push_back(positionError(scene, world));
    errors.velocity.push_back(velocityError(scene, world));
  }
}

Expected<Json> ballFilter(const Request& request) {
  Errors standing, walking, still, stillStanding, oscillation;
  JumpErrors unseen, lyingJump, rollingJump, kick;
  Random seeds(request.seed);
  eachTrial(request, [&](const Trial& trial) {
    Random speeds(trial.seed);
    falseLast(trial.seed, 0.0, 0.0, unseen);
    falseLast(trial.seed, 0.0, kFalseSds, lyingJump);
    falseLast(trial.seed, speeds.uniform(20.0, 80.0), kFalseSds, rollingJump);
    kicked(trial.seed, kick);
    rolling(seeds.next(), false, standing);
    rolling(seeds.next(), true, walking);
    lying(seeds.next(), true, false, still);
    lying(seeds.next(), false, false, stillStanding);
    lying(seeds.next(), true, true, oscillation);
  });
  return Json{{"standing_cm", mean(standing.position)},
              {"standing_cm_s", mean(standing.velocity)},
              {"walking_cm", mean(walking.position)},
              {"walking_cm_s", mean(walking.velocity)},
              {"still_speed_cm_s", mean(still.speed)},
              {"still_speed_p95_cm_s", percentile(still.speed, 0.95)},
              {"still_standing_speed_cm_s", mean(stillStanding.speed)},
              {"still_standing_speed_p95_cm_s", percentile(stillStanding.speed, 0.95)},
              {"still_oscillation_speed_cm_s", mean(oscillation.speed)},
              {"still_oscillation_speed_p95_cm_s", percentile(oscillation.speed, 0.95)},
              {"stop_cm", mean(standing.stop)},
              {"stop_p90_cm", percentile(standing.stop, 0.9)},
              {"stop_walking_cm", mean(walking.stop)},
              {"stop_walking_p90_cm", percentile(walking.stop, 0.9)},
              {"unseen_cm", mean(unseen.position)},
              {"unseen_p95_cm", percentile(unseen.position, 0.95)},
              {"false_jump_cm", mean(lyingJump.position)},
              {"false_jump_p95_cm", percentile(lyingJump.position, 0.95)},
              {"false_jump_p95_cm_s", percentile(lyingJump.velocity, 0.95)},
              {"rolling_false_jump_cm", mean(rollingJump.position)},
              {"rolling_false_jump_p95_cm", percentile(rollingJump.position, 0.95)},
              {"rolling_false_jump_p95_cm_s", percentile(rollingJump.velocity, 0.95)},
              {"kicked_cm", mean(kick.position)},
              {"kicked_p95_cm", percentile(kick.position, 0.95)},
              {"kicked_cm_s", mean(kick.velocity)}};
}

const Registration kBall("ball",
                         "the ball filter: place, velocity, a lying ball's speed, where one stops",
                         {Option::trials, Option::seed}, 200, ballFilter);

}  // namespace
}  // namespace kelpie::experiments

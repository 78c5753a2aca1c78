// SPDX-License-Identifier: Apache-2.0
// The ball filter on balls that lie and balls that roll, seen standing and walking: errors of place
// and velocity, the speed of a lying ball, and where a rolling one will lie.
#include <algorithm>
#include <cmath>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/players/Player.h"
#include "tools/sim/Ball.h"

namespace kelpie::experiments {
namespace {

constexpr double kSight = 0.5;      // s of sight until the end is predicted
constexpr double kSettled = 0.3;    // s until errors count
constexpr double kMinRange = 30.0;  // cm
constexpr double kMaxRange = 300.0;
constexpr double kRecall = 0.97;

struct Errors {
  Values position;
  Values velocity;
  Values speed;  // of a ball that lies
  Values stop;
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
    const Pose2 truth = scene.player.truth.pose();
    errors.position.push_back(
        distance(world.ball.relative, robotFromField(truth, scene.ball.position)));
    errors.velocity.push_back(
        distance(turned(world.pose, world.ball.velocity), turned(truth, scene.ball.velocity)));
  }
}

void lying(std::uint64_t seed, bool walks, bool sway, Errors& errors) {
  Scene scene = sceneOf(seed, 0.0, walks);
  scene.player.noise.ball.sway = sway;
  WorldModel world;
  for (double time = kFrameSeconds; time < 4.0; time += kFrameSeconds) {
    if (!advance(scene, world)) return;
    if (time < 1.0 || !world.ball.present) continue;
    errors.speed.push_back(world.ball.velocity.norm());
  }
}

Expected<Json> ballFilter(const Request& request) {
  Errors standing, walking, still, stillStanding, sway;
  Random seeds(request.seed);
  eachTrial(request, [&](const Trial&) {
    rolling(seeds.next(), false, standing);
    rolling(seeds.next(), true, walking);
    lying(seeds.next(), true, false, still);
    lying(seeds.next(), false, false, stillStanding);
    lying(seeds.next(), true, true, sway);
  });
  return Json{{"standing_cm", mean(standing.position)},
              {"standing_cm_s", mean(standing.velocity)},
              {"walking_cm", mean(walking.position)},
              {"walking_cm_s", mean(walking.velocity)},
              {"still_speed_cm_s", mean(still.speed)},
              {"still_speed_p95_cm_s", percentile(still.speed, 0.95)},
              {"still_standing_speed_cm_s", mean(stillStanding.speed)},
              {"still_standing_speed_p95_cm_s", percentile(stillStanding.speed, 0.95)},
              {"still_sway_speed_cm_s", mean(sway.speed)},
              {"still_sway_speed_p95_cm_s", percentile(sway.speed, 0.95)},
              {"stop_cm", mean(standing.stop)},
              {"stop_p90_cm", percentile(standing.stop, 0.9)},
              {"stop_walking_cm", mean(walking.stop)},
              {"stop_walking_p90_cm", percentile(walking.stop, 0.9)}};
}

const Registration kBall("ball",
                         "the ball filter: place, velocity, a lying ball's speed, where one stops",
                         {Option::trials, Option::seed}, 200, ballFilter);

}  // namespace
}  // namespace kelpie::experiments

// SPDX-License-Identifier: Apache-2.0
// What the body feels of being held while it walks (actuator/feeling/Feeling.h), on physical models
// varied in friction, armature, contact, servo and mass: how often a hand that holds it, or half of
// it, is found in time, and how often a robot that walks free, is pushed lightly or stands thinks
// that it is held.
#include <array>
#include <cmath>

#include "robot/core/Random.h"
#include "tools/experiments/harness/Experiment.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/learn/motion/GetUpTrial.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::experiments {
namespace {

using learn::PhysicalWalker;

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr double kInTime = 0.7;      // s, in which a hold is to be found
constexpr int kSteady = 47;          // messages, 1.5 s, until a walk is even
constexpr int kInTimeMessages = 21;  // 0.67 s
constexpr int kFreeMessages = 1875;  // a minute
constexpr int kOneCommand = 40;      // 1.3 s
constexpr double kStep = 0.002;      // s, of the physics

Command atRandom(Random& random) {
  Command command;
  command.walk = {random.uniform(-30.0, 42.0), random.uniform(-22.0, 22.0),
                  random.uniform(-3.0, 3.0)};
  const std::size_t alone = random.index(5);
  if (alone == 0) command.walk.left = command.walk.turn = 0.0;
  if (alone == 1) command.walk.forward = command.walk.turn = 0.0;
  if (alone == 2) command.walk.forward = command.walk.left = 0.0;
  return command;
}

// Fast enough that something can hold it up; a hand that half holds does not mind turns.
Command steadily(bool turns, Random& random) {
  Command command;
  const double sign = random.chance(0.5) ? 1.0 : -1.0;
  switch (random.index(turns ? 4 : 3)) {
    case 0: command.walk.forward = random.uniform(12.0, 36.0); break;
    case 1: command.walk.forward = random.uniform(-28.0, -12.0); break;
    case 2: command.walk.left = sign * random.uniform(10.0, 20.0); break;
    default: command.walk.turn = sign * random.uniform(0.8, 2.5); break;
  }
  return command;
}

// Back to the middle of the field as it is: nothing else shall hold it.
void moveHome(PhysicalWalker& walker) {
  const Point2<Field> home{180.0, 270.0};
  walker.bodies().shove(0, home - walker.pose().position, {});
}

PhysicalWalker walkerOf(std::uint64_t seed, const actuator::ActuatorParams& params) {
  return {learn::variedModels(seed, 1, kStep).front(), params, seed};
}

// Walks steadily, is held by that share, and feels it in time.
bool found(double share, std::uint64_t seed, const actuator::ActuatorParams& params) {
  Random random(seed);
  PhysicalWalker walker = walkerOf(seed, params);
  const Command command = steadily(share >= 1.0, random);
  moveHome(walker);
  for (int i = 0; i < kSteady; ++i) walker.step(command);
  walker.bodies().hold(0, share);
  for (int i = 0; i < kInTimeMessages; ++i)
    if (walker.step(command).status.feeling.stuck) return true;
  return false;
}

// A blow of another robot: this much of speed in a moment.
void blow(Random& random, PhysicalWalker& walker) {
  constexpr double kBlow = 0.25;  // m/s: 0.4 N s
  sim::Engine& engine = walker.bodies().physics().engine();
  const int trunk = walker.bodies().physics().robot(0).trunk();
  const int dof = engine.model().jnt_dofadr[engine.model().body_jntadr[trunk]];
  const Angle way = Angle::rad(random.uniform(-maths::kPi, maths::kPi));
  engine.data().qvel[dof] += kBlow * way.cos();
  engine.data().qvel[dof + 1] += kBlow * way.sin();
}

// How often in a minute it feels held, or a paw blocked, at random commands.
struct Alarms {
  int stuck = 0;
  int pawBlocked = 0;
  int fallen = 0;
};
Alarms alarms(bool blows, std::uint64_t seed, const actuator::ActuatorParams& params) {
  Random random(seed);
  PhysicalWalker walker = walkerOf(seed, params);
  Alarms count;
  Command command;
  Feeling last;
  for (int i = 0; i < kFreeMessages; ++i) {
    if (i % kOneCommand == 0) command = atRandom(random);
    if (i % 10 == 0) moveHome(walker);
    if (blows && i % (3 * kOneCommand) == 0) blow(random, walker);
    const Feeling& now = walker.step(command).status.feeling;
    const bool lies = learn::trueSide(walker) != FallSide::none;
    count.stuck += now.stuck && !last.stuck && !lies ? 1 : 0;
    for (std::size_t paw = 0; paw < now.pawBlocked.size(); ++paw)
      count.pawBlocked += now.pawBlocked[paw] && !last.pawBlocked[paw] ? 1 : 0;
    count.fallen += now.fallen != FallSide::none && last.fallen == FallSide::none && !lies ? 1 : 0;
    last = now;
  }
  return count;
}

Expected<Json> held(const Request& request) {
  constexpr int kPerTrial = 10;
  const actuator::ActuatorParams params;
  Share whole;
  Share half;
  Alarms free;
  Alarms pushed;
  const auto add = [](const Alarms& more, Alarms& sum) {
    sum = {sum.stuck + more.stuck, sum.pawBlocked + more.pawBlocked, sum.fallen + more.fallen};
  };
  eachTrial(request, [&](const Trial& trial) {
    for (std::uint64_t i = 0; i < kPerTrial; ++i) {
      const std::uint64_t seed = 100 * trial.seed + i;
      whole.count(found(1.0, seed, params));
      half.count(found(0.5, seed + 50, params));
    }
    add(alarms(false, 100 * trial.seed, params), free);
    add(alarms(true, 100 * trial.seed + 1, params), pushed);
  });
  const double minutes = request.trials * kFreeMessages * kMessageSeconds / 60.0;
  return Json{{"held_rate", whole.value()},
              {"half_held_rate", half.value()},
              {"false_a_minute", (free.stuck + pushed.stuck) / (2.0 * minutes)},
              {"false_a_minute_free", free.stuck / minutes},
              {"false_a_minute_pushed", pushed.stuck / minutes},
              {"false_paws_a_minute", free.pawBlocked / minutes},
              {"false_falls_a_minute", (free.fallen + pushed.fallen) / (2.0 * minutes)},
              {"within_s", kInTime}};
}

const Registration kHeld("stuck-physical",
                         "a held physical robot found in time, false alarms of free ones",
                         {Option::trials, Option::seed}, 10, held);

}  // namespace
}  // namespace kelpie::experiments

// SPDX-License-Identifier: Apache-2.0
// What the actuator commands of a physical robot that is asked for anything: every walk at once and
// too fast, every motion, looks anywhere, numbers that are not finite; it falls, is held, carries
// the ball. Are all targets within the joints' limits and their changes within the rates that the
// walk or the motion under way may have?
#include <cmath>
#include <limits>

#include "actuator/ActuatorParams.h"
#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"
#include "tools/experiments/body/OnModels.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 60.0;  // on each model
constexpr double kMessage = kTickSeconds * kTicksPerMessage;
constexpr double kRounding = 1e-9;  // deg

struct Targets {
  int ticks = 0;
  int outside = 0;    // joints beyond a limit
  int tooFast = 0;    // or changed by more than they may
  double step = 0.0;  // deg, the largest change in a tick while walking
  double kick = 0.0;  // and in motions
  int motions = 0;    // that were begun
  int falls = 0;
  bool failed = false;  // the physics did
};

double drawn(double max, Random& random) {
  if (random.chance(0.02)) return std::numeric_limits<double>::quiet_NaN();
  if (random.chance(0.02)) return 1e300;
  return random.uniform(-max, max);
}

Command anyCommand(Random& random) {
  const auto angle = [&] { return Angle::rad(drawn(3.0, random)); };
  Command command;
  command.walk = {drawn(60, random), drawn(60, random), drawn(6, random), drawn(20, random),
                  static_cast<WalkKind>(random.index(kWalkKindCount))};
  if (random.chance(0.3)) command.walk = {};
  command.head.neckTilt = angle();
  command.head.headPan = angle();
  command.head.headNod = angle();
  command.head.speed = drawn(10, random);
  command.head.aim = static_cast<HeadAim>(random.index(kHeadAimCount));
  command.head.direction = angle();
  command.head.elevation = angle();
  command.head.target = {drawn(200, random), drawn(200, random), drawn(50, random)};
  command.mouthOpen = random.chance(0.5);
  command.tail = {angle(), angle()};
  if (random.chance(0.4)) command.motion = static_cast<MotionKind>(random.index(kMotionKindCount));
  return command;
}

// The joints' limits, the shoulder's coupling to the rotator included.
bool inside(const JointAngles& joints) {
  const JointAngles limited = body::withinLimits(joints);
  for (std::size_t j = 0; j < kJointCount; ++j)
    if (!(std::fabs((joints.angle[j] - limited.angle[j]).deg()) <= kRounding)) return false;
  return true;
}

double largestStep(const JointAngles& now, const JointAngles& last) {
  double largest = 0.0;
  for (std::size_t j = 0; j < kJointCount; ++j)
    largest = std::fmax(largest, std::fabs((now.angle[j] - last.angle[j]).deg()));
  return largest;
}

// A motion may begin or end within a message: then the wider rate of the two counts.
void count(const learn::PhysicalWalker& walker, MotionKind before, JointAngles& last,
           const actuator::ActuatorParams& params, Targets& targets) {
  const MotionKind now = walker.output().status.running;
  double max = std::fmax(params.walkSlew.deg(), params.headSlew.deg());
  for (const MotionKind kind : {before, now})
    if (kind != MotionKind::none) max = std::fmax(max, params.motions[kind].slew.deg());
  const bool moves = before != MotionKind::none || now != MotionKind::none;
  for (const JointFrame& frame : walker.output().joints) {
    const double step = largestStep(frame.target, last);
    double& largest = moves ? targets.kick : targets.step;
    largest = std::fmax(largest, step);
    targets.outside += inside(frame.target) ? 0 : 1;
    targets.tooFast += step <= max + kRounding ? 0 : 1;
    ++targets.ticks;
    last = frame.target;
  }
}

Targets ask(const sim::PhysicsParams& model, std::uint64_t seed) {
  const actuator::ActuatorParams params;
  learn::PhysicalWalker walker(model, params, seed);
  walker.step({});
  Random random(seed);
  Targets targets;
  Command command;
  JointAngles last = walker.output().joints.back().target;
  bool lay = false;
  for (int i = 0; i * kMessage < kSeconds; ++i) {
    if (random.chance(0.1)) command = anyCommand(random);
    if (random.chance(0.005))
      walker.bodies().putBall({fieldFromRobot(walker.pose(), {0.0, 14.0}), {}});
    if (random.chance(0.01)) walker.bodies().hold(0, random.chance(0.5) ? 1.0 : 0.0);
    const MotionKind before = walker.output().status.running;
    walker.step(command);
    count(walker, before, last, params, targets);
    targets.motions +=
        before == MotionKind::none && walker.output().status.running != MotionKind::none ? 1 : 0;
    targets.falls += !lay && walker.fallen() ? 1 : 0;
    lay = walker.fallen();
  }
  targets.failed = walker.failed();
  return targets;
}

Expected<Json> jointTargets(const Request& request) {
  Targets all;
  int failed = 0;
  for (const Targets& targets : onModels<Targets>(request, ask)) {
    all.ticks += targets.ticks;
    all.outside += targets.outside;
    all.tooFast += targets.tooFast;
    all.motions += targets.motions;
    all.falls += targets.falls;
    all.step = std::fmax(all.step, targets.step);
    all.kick = std::fmax(all.kick, targets.kick);
    failed += targets.failed ? 1 : 0;
  }
  return Json{{"ticks", all.ticks},
              {"motions", all.motions},
              {"falls", all.falls},
              {"outside_limits", all.outside},
              {"beyond_rates", all.tooFast},
              {"largest_step_walking_deg", all.step},
              {"largest_step_in_motions_deg", all.kick},
              {"physics_failed", failed}};
}

const Registration kTargets("joint-targets",
                            "joint targets of a physical robot that is asked for anything",
                            {Option::trials, Option::seed}, 10, jointTargets);

}  // namespace
}  // namespace kelpie::experiments

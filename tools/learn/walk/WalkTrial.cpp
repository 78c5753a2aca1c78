// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/walk/WalkTrial.h"

#include <cmath>

#include "actuator/walk/WalkSpeed.h"
#include "robot/core/Random.h"
#include "tools/learn/motion/BallInHold.h"

namespace kelpie::learn {
namespace {

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;

int messagesOf(double seconds) { return static_cast<int>(seconds / kMessageSeconds + 0.5); }

// Sums for the spread of an angle.
struct Spread {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;

  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double variance() const {
    return count == 0 ? 0.0 : squares / count - maths::square(sum / count);
  }
};

struct BodyOscillation {
  Spread roll;
  Spread tilt;

  void add(const sim::BodyPlace& place) {
    roll.add(place.lean.roll.rad());
    tilt.add(place.stance.bodyTilt.rad());
  }
  double rms() const { return std::sqrt(roll.variance() + tilt.variance()); }
};

Command baseCommand(WalkKind kind) {
  return kind == WalkKind::dribble ? holdingCommand() : Command{};
}

// What is walked after the speed has become even.
Walked straightOn(const WalkTrialPlan& plan, const WalkRequest& request, PhysicalWalker& walker,
                  BodyOscillation& oscillation) {
  Command command = baseCommand(request.kind);
  command.walk = request;
  const int start = messagesOf(plan.startSeconds);
  Walked sum;
  for (int m = 0; m < start + messagesOf(plan.measuredSeconds) && !walker.fallen(); ++m) {
    const Walked step = walkOn(walker, command);
    if (m < start) continue;
    sum += step;
    oscillation.add(walker.place());
  }
  return sum;
}

double bendOf(const Walked& walked) {
  return std::fabs(walked.turn) / std::fmax(1.0, std::fabs(walked.forward));
}

double along(WalkWay way, const Walked& walked) {
  switch (way) {
    case WalkWay::forward: return walked.forward;
    case WalkWay::back: return -walked.forward;
    case WalkWay::left: return walked.left;
    default: return walked.turn;
  }
}

WalkRequest randomRequest(WalkKind kind, Random& random) {
  WalkRequest request{random.uniform(-30.0, 42.0), random.uniform(-22.0, 22.0),
                      random.uniform(-3.8, 3.8)};
  // One time in four the robot stands, one in four it goes straight.
  const std::size_t choice = random.index(4);
  if (choice == 0) request = {};
  if (choice == 1) request.left = request.turn = 0.0;
  request.kind = kind;
  return request;
}

bool fallsAtRandom(const WalkTrialPlan& plan, PhysicalWalker& walker, std::uint64_t seed) {
  constexpr double kOneCommand = 1.0;  // s
  Random random(seed);
  Command command = baseCommand(plan.kind);
  for (int i = 0; i < messagesOf(plan.randomSeconds); ++i) {
    if (i % messagesOf(kOneCommand) == 0) command.walk = randomRequest(plan.kind, random);
    walker.step(command);
    if (walker.fallen()) return true;
  }
  return false;
}

}  // namespace

WalkRequest shareOf(WalkWay way, double share, const actuator::WalkSet& set, WalkKind kind) {
  const actuator::StrokeLimits& max = set.max;
  actuator::Velocity feet;
  if (way == WalkWay::forward) feet.forward = share * max.forward;
  if (way == WalkWay::back) feet.forward = -share * max.back;
  if (way == WalkWay::left) feet.left = share * max.left;
  if (way == WalkWay::turn) feet.turn = share * max.turn;
  const actuator::Velocity real = actuator::realSpeed(feet, set.calibration);
  return {real.forward, real.left, real.turn, 0.0, kind};
}

void spare(PhysicalWalker& walker) {
  constexpr double kUntilSpared = 6.0;  // s
  walker.spareLegs();
  for (int i = 0; i < messagesOf(kUntilSpared); ++i) walker.step({});
}

Walked& operator+=(Walked& sum, const Walked& more) {
  sum = {sum.forward + more.forward, sum.left + more.left, sum.turn + more.turn};
  return sum;
}

Walked walkOn(PhysicalWalker& walker, const Command& command) {
  const Pose2 last = walker.pose();
  walker.step(command);
  const Pose2 now = walker.pose();
  const Point2<Robot> moved = robotFromField(last, now.position);
  return {moved.y, -moved.x, (now.heading - last.heading).rad()};
}

WalkTrial tryWalk(const WalkTrialPlan& plan, const sim::PhysicsParams& model,
                  const actuator::ActuatorParams& params, std::uint64_t seed) {
  PhysicalWalker walker(model, params, seed);
  if (plan.kind == WalkKind::weak) spare(walker);
  const actuator::WalkSet& set = actuator::walkSet(params.walks, plan.kind);
  WalkTrial trial;
  const bool dribbles = plan.kind == WalkKind::dribble;
  BodyOscillation oscillation;
  for (const double share : {1.0, 0.5})
    for (std::size_t i = 0; i < kWalkDirections && !trial.fell; ++i) {
      const auto way = static_cast<WalkWay>(i);
      if (dribbles && !holdsBall(walker)) giveBall({0.0, kHeldAhead}, walker);
      const Walked sum = straightOn(plan, shareOf(way, share, set, plan.kind), walker, oscillation);
      trial.fell = walker.fallen();
      (share == 1.0 ? trial.speed : trial.half)[i] = along(way, sum) / plan.measuredSeconds;
      if (dribbles && !holdsBall(walker)) trial.lost += 0.5 / kWalkDirections;
      const bool straight = way == WalkWay::forward || way == WalkWay::back;
      if (straight) trial.bend = std::fmax(trial.bend, bendOf(sum));
    }
  trial.oscillation = oscillation.rms();
  if (!trial.fell) trial.fell = fallsAtRandom(plan, walker, seed);
  return trial;
}

}  // namespace kelpie::learn

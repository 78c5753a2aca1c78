// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/WalkTrial.h"

#include <cmath>

#include "robot/core/Random.h"

namespace kelpie::learn {
namespace {

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr double kAll = 1000.0;

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
  Command command;
  for (int i = 0; i < messagesOf(plan.randomSeconds); ++i) {
    if (i % messagesOf(kOneCommand) == 0) command.walk = randomRequest(plan.kind, random);
    walker.step(command);
    if (walker.fallen()) return true;
  }
  return false;
}

}  // namespace

WalkRequest allOf(WalkWay way, WalkKind kind) {
  WalkRequest request;
  request.kind = kind;
  if (way == WalkWay::forward) request.forward = kAll;
  if (way == WalkWay::back) request.forward = -kAll;
  if (way == WalkWay::left) request.left = kAll;
  if (way == WalkWay::turn) request.turn = kAll;
  return request;
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
  WalkTrial trial;
  Spread roll;
  Spread tilt;
  for (std::size_t i = 0; i < kWalkWays && !trial.fell; ++i) {
    Command command;
    command.walk = allOf(static_cast<WalkWay>(i), plan.kind);
    const int start = messagesOf(plan.startSeconds);
    const int measured = messagesOf(plan.measuredSeconds);
    Walked sum;
    for (int m = 0; m < start + measured && !walker.fallen(); ++m) {
      const Walked step = walkOn(walker, command);
      if (m < start) continue;
      sum += step;
      roll.add(walker.place().lean.roll.rad());
      tilt.add(walker.place().stance.bodyTilt.rad());
    }
    trial.fell = walker.fallen();
    trial.speed[i] = along(static_cast<WalkWay>(i), sum) / (measured * kMessageSeconds);
  }
  trial.sway = std::sqrt(roll.variance() + tilt.variance());
  if (!trial.fell) trial.fell = fallsAtRandom(plan, walker, seed);
  return trial;
}

}  // namespace kelpie::learn

// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/walk/WalkSamples.h"

#include <array>
#include <cmath>

#include "actuator/odometry/OdometryTerms.h"
#include "actuator/walk/WalkSpeed.h"
#include "robot/core/Random.h"
#include "tools/learn/Numbers.h"
#include "tools/learn/motion/BallInHold.h"

namespace kelpie::learn {
namespace {

using actuator::Velocity;

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr int kStart = 36;     // messages until the speed is even
constexpr int kMeasured = 75;  // 2.4 s
constexpr int kWay = 16;       // half a second
// Of a way whose command began earlier. Most of what is walked is even, and with 1 the fit took
// the starts and stops for it: an even turn was estimated 2 % too far.
constexpr double kEven = 4.0;
constexpr double kAlone = 2.0;  // of a way in one direction: nothing says then what others add

// Half of the speeds are asked in one direction alone, as behaviours ask, the others in all at
// once.
Velocity drawn(const actuator::WalkSet& set, int number, Random& random) {
  const actuator::StrokeLimits& max = set.max;
  const Velocity real = actuator::realSpeed({max.forward, max.left, max.turn}, set.calibration);
  const double share = random.uniform(0.2, 1.0);
  const double side = random.chance(0.5) ? share : -share;
  const auto asked = [&set](const WalkRequest& request) { return wantedSpeed(request, set); };
  const int way = number % 8;
  if (way == 0) return asked({share * real.forward, 0.0, 0.0});
  if (way == 1) return asked({-share * real.forward, 0.0, 0.0});
  if (way == 2) return asked({0.0, side * real.left, 0.0});
  if (way == 3) return asked({0.0, 0.0, side * real.turn});
  std::array<double, 3> part{};
  for (double& p : part) p = random.gaussian(0.0, 1.0);
  const double size = std::sqrt(part[0] * part[0] + part[1] * part[1] + part[2] * part[2]);
  const double forward = part[0] < 0.0 ? max.back : max.forward;
  return {share * forward * part[0] / size, share * max.left * part[1] / size,
          share * max.turn * part[2] / size};
}

// The way of an even walk bends: forward and left are those along the arc.
Velocity evenSpeed(const Walked& walked, double seconds) {
  return {walked.forward / seconds, walked.left / seconds, walked.turn / seconds};
}

// Odometry that tells what the joints say and nothing else.
actuator::WalkOdometry jointsAlone() {
  actuator::WalkOdometry odometry;
  odometry.forward.joints = odometry.left.joints = odometry.turn.joints = 1.0;
  return odometry;
}

// Nothing of the set is fitted yet: the feet go as fast as commanded.
actuator::WalkSet unfitted(const actuator::WalkSet& set) {
  actuator::WalkSet exact = set;
  exact.calibration = {};
  exact.odometry = jointsAlone();
  exact.freeLoad = {};
  exact.oscillation = {};
  return exact;
}

actuator::CommandedTick shownNow(const PhysicalWalker& walker) {
  const actuator::OdometryParams delay;
  return actuator::shown(kTicksPerMessage - 1, delay, walker.state().odometry);
}

Walked odometryOf(const PhysicalWalker& walker) {
  const Odometry& odometry = walker.output().odometry;
  return {odometry.forward, odometry.left, odometry.turn.rad()};
}

OscillationSample oscillationNow(const PhysicalWalker& walker) {
  const auto tick = shownNow(walker);
  const sim::BodyPlace place = walker.place();
  const Stance& legs = walker.output().stances.back();
  OscillationSample sample;
  sample.stride = tick.stride;
  sample.tilt = (place.stance.bodyTilt - legs.bodyTilt).rad();
  sample.roll = place.lean.roll.rad();
  sample.height = place.stance.shoulderHeight - legs.shoulderHeight;
  return sample;
}

SpeedSample sampleSpeed(const Velocity& feet, const Command& command, PhysicalWalker& walker,
                        std::vector<OscillationSample>& oscillations) {
  Walked sum;
  double load = 0.0;
  OscillationSample last = oscillationNow(walker);
  for (int m = 0; m < kMeasured; ++m) {
    const Walked moved = walkOn(walker, command);
    load += walker.output().status.feeling.load / kMeasured;
    OscillationSample sample = oscillationNow(walker);
    sample.before = last.stride;
    sample.moved = moved;
    sample.joints = odometryOf(walker);
    sample.seconds = kMessageSeconds;
    sum += moved;
    oscillations.push_back(sample);
    last = sample;
  }
  return {feet, evenSpeed(sum, kMeasured * kMessageSeconds), load};
}

// The command for it; the dribbling walk is given a ball when it has none.
Command walking(WalkKind kind, const Velocity& speed, PhysicalWalker& walker) {
  Command command = kind == WalkKind::dribble ? holdingCommand() : Command{};
  if (kind == WalkKind::dribble && !holdsBall(walker)) giveBall({0.0, kHeldAhead}, walker);
  command.walk = {speed.forward, speed.left, speed.turn, 0.0, kind};
  return command;
}

// What a player asks for: to stand, to turn, slowly or as fast as it can, to walk ahead, bending or
// not, or anything.
Velocity played(const actuator::WalkSet& set, Random& random) {
  const auto& [forward, back, left, turn] = set.max;
  const Velocity max = actuator::realSpeed({forward, left, turn}, set.calibration);
  const double ahead = random.uniform(0.2, 1.0) * max.forward;
  const double round = random.uniform(-1.0, 1.0) * max.turn;
  const double all = std::copysign(2.0 * max.turn, round);  // as fast as it can
  switch (random.index(8)) {
    case 0: return {0.0, 0.0, random.chance(0.5) ? round : 0.0};
    case 1: return {0.0, 0.0, round};
    case 2: return {0.0, 0.0, all};
    case 3: return {ahead, 0.0, 0.0};
    case 4: return {ahead, 0.0, 0.5 * round};
    case 5: return {0.0, random.uniform(-1.0, 1.0) * max.left, 0.5 * round};
    default: break;
  }
  return {random.uniform(-max.forward * back / forward, max.forward),
          random.uniform(-max.left, max.left), round};
}

bool alone(const WalkRequest& r) {
  return (r.forward != 0.0 ? 1 : 0) + (r.left != 0.0 ? 1 : 0) + (r.turn != 0.0 ? 1 : 0) <= 1;
}

void addTo(std::vector<double>& mean, const std::vector<double>& numbers) {
  mean.resize(numbers.size());
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += numbers[i] / kWay;
}

PathSample sampleWay(const Command& command, PhysicalWalker& walker) {
  PathSample sample;
  Walked sum;
  for (int m = 0; m < kWay; ++m) {
    sum += walkOn(walker, command);
    const Walked reported = odometryOf(walker);
    const Velocity joints = evenSpeed(reported, kMessageSeconds);
    const auto tick = shownNow(walker);
    const Velocity& feet = tick.stride.feet;
    const actuator::Felt& felt = tick.felt;
    addTo(sample.forward, numbersOf(actuator::alongFactors(feet, felt, joints.forward)));
    addTo(sample.left, numbersOf(actuator::leftFactors(feet, felt, joints.left)));
    addTo(sample.turn, numbersOf(actuator::turnFactors(feet, felt, joints.turn)));
  }
  sample.real = evenSpeed(sum, kWay * kMessageSeconds);
  return sample;
}

}  // namespace

void append(const WalkSamples& more, WalkSamples& all) {
  all.speeds.insert(all.speeds.end(), more.speeds.begin(), more.speeds.end());
  all.oscillations.insert(all.oscillations.end(), more.oscillations.begin(),
                          more.oscillations.end());
}

WalkSamples sampleWalk(WalkKind kind, const actuator::WalkSet& set, const sim::PhysicsParams& model,
                       int count, std::uint64_t seed) {
  actuator::ActuatorParams params;
  actuator::walkSet(params.walks, kind) = unfitted(set);
  Random random(seed);
  WalkSamples samples;
  PhysicalWalker walker(model, params, seed);
  if (kind == WalkKind::weak) spare(walker);
  for (int i = 0; i < count; ++i) {
    const Velocity feet = drawn(set, i, random);
    const Command command = walking(kind, {feet.forward, feet.left, feet.turn}, walker);
    for (int m = 0; m < kStart; ++m) walker.step(command);
    WalkSamples more;
    more.speeds.push_back(sampleSpeed(feet, command, walker, more.oscillations));
    if (walker.fallen()) {
      walker = PhysicalWalker(model, params, seed);
      continue;
    }
    append(more, samples);
  }
  return samples;
}

std::vector<PathSample> samplePaths(WalkKind kind, const actuator::WalkSet& set,
                                    const sim::PhysicsParams& model, int count,
                                    std::uint64_t seed) {
  actuator::ActuatorParams params;
  actuator::WalkSet& tried = actuator::walkSet(params.walks, kind);
  tried = unfitted(set);
  tried.calibration = set.calibration;
  tried.freeLoad = set.freeLoad;
  Random random(seed);
  std::vector<PathSample> samples;
  PhysicalWalker walker(model, params, seed);
  if (kind == WalkKind::weak) spare(walker);
  for (int i = 0; i < count; ++i) {
    const Command command = walking(kind, played(set, random), walker);
    const std::uint32_t parts = 1 + random.index(5);
    for (std::uint32_t part = 0; part < parts; ++part) {
      samples.push_back(sampleWay(command, walker));
      samples.back().weight = (part > 0 ? kEven : 1.0) * (alone(command.walk) ? kAlone : 1.0);
    }
    if (!walker.fallen()) continue;
    samples.resize(samples.size() - parts);
    walker = PhysicalWalker(model, params, seed);
  }
  return samples;
}

}  // namespace kelpie::learn

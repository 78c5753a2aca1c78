// SPDX-License-Identifier: Apache-2.0
#include "actuator/feeling/Feeling.h"

#include <algorithm>
#include <cmath>

#include "actuator/walk/Locus.h"
#include "robot/core/Maths.h"

namespace kelpie::actuator {
namespace {

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr std::array<LegId, 2> kFrontLegs{LegId::leftFront, LegId::rightFront};

std::array<bool, 2> airborne(const WalkState& walk, double share) {
  std::array<bool, 2> air{};
  for (std::size_t i = 0; i < air.size(); ++i) {
    const GaitParams& gait = walk.set.gait;
    const double phase = footPhase(kFrontLegs[i], gait, walk.phase);
    const LocusPoint at = locusPoint(gait.locus, phase, gait.frontDuty, gait.lead);
    air[i] = walk.phase.lift * at.height > share;
  }
  return air;
}

const FeltTick& ticksAgo(std::uint32_t back, const FeelingState& state) {
  return state.felt[(state.ticks - back) % state.felt.size()];
}

// Of the front paws in one tick, whose feet were commanded `delayTicks` ago to be in the air or
// not.
void feelPaws(const SensorFrame& tick, const FeelingParams& params, FeelingState& state) {
  const bool known = state.ticks > params.delayTicks;
  for (std::size_t i = 0; i < kFrontLegs.size(); ++i) {
    const bool air = known && ticksAgo(params.delayTicks + 1, state).airborne[i];
    const bool presses = air && tick.paw[index(kFrontLegs[i])];
    state.pressed[i] = presses ? state.pressed[i] + 1 : 0;
    if (state.pressed[i] >= params.pressTicks) state.blockedSeconds[i] = params.blockedSeconds;
  }
}

// Newton: what the feet push and the body does not do, something else does to it.
ContactForce resisted(const ContactForce& push, const std::array<double, 3>& acceleration,
                      double weight) {
  constexpr double kGravity = 981.0;       // cm/s2
  constexpr double kMax = 2.0 * kGravity;  // what the sensor can tell
  const auto share = [&](double a) {
    return std::isfinite(a) ? weight * maths::clamp(a, -kMax, kMax) / kGravity : 0.0;
  };
  return {push.forward + share(acceleration[0]), push.left + share(acceleration[1]), push.turn};
}

void recordTick(const SensorFrame& tick, const FeltTick& commanded, bool walking,
                const FeelingParams& params, FeelingState& state) {
  const SensedLegs now = sensedLegs(tick, state.before[0]);
  if (walking) {
    const LegCurrents currents = legCurrents(state.before[1], state.before[0], now, params.noLoad);
    FeltTick felt = commanded;
    felt.current = rotatorCurrent(currents);
    felt.resisted =
        resisted(contactForceOf(currents, state.before[0]), tick.acceleration, params.weight);
    state.felt[state.ticks++ % state.felt.size()] = felt;
  } else {
    state.ticks = 0;
  }
  state.before = {now, state.before[0]};
  feelPaws(tick, params, state);
}

// Sums of the last step: what was felt, and the feet's speed that was commanded for it.
struct StepSums {
  double current = 0.0;
  ContactForce resisted;
  Velocity feet;
};

StepSums sumsOf(std::uint32_t step, const FeelingParams& params, const FeelingState& state) {
  StepSums sums;
  for (std::uint32_t back = 1; back <= step; ++back) {
    const FeltTick& felt = ticksAgo(back, state);
    sums.current += felt.current;
    sums.resisted.forward += felt.resisted.forward;
    sums.resisted.left += felt.resisted.left;
    sums.resisted.turn += felt.resisted.turn;
    const Velocity& feet = ticksAgo(back + params.delayTicks, state).feet;
    sums.feet.forward += feet.forward;
    sums.feet.left += feet.left;
    sums.feet.turn += feet.turn;
  }
  return sums;
}

// Along the way that was commanded, a turn counted on its lever.
double loadOf(const ContactForce& resisted, const Velocity& feet, const FreeLoad& free,
              const FeelingParams& params) {
  const double turn = params.lever * feet.turn;
  const double speed =
      std::sqrt(maths::square(feet.forward) + maths::square(feet.left) + maths::square(turn));
  if (speed < params.minSpeed) return 0.0;
  const double against = resisted.forward * feet.forward + resisted.left * feet.left +
                         resisted.turn / params.lever * turn;
  return -params.legLength / kLegCount * against / speed - freeLoad(feet, free);
}

// 0 until enough was walked.
void feelLoad(const WalkState& walk, const FeelingParams& params, const FeelingState& state,
              Feeling& feeling) {
  const auto step = static_cast<std::uint32_t>(2.0 * walk.set.gait.halfStepTicks + 0.5);
  const std::uint32_t all = step + params.delayTicks;
  if (step == 0 || state.ticks < all || all > state.felt.size()) return;
  const StepSums sums = sumsOf(step, params, state);
  feeling.current = sums.current / step;
  const double share = 1.0 / step;
  const Velocity feet{share * sums.feet.forward, share * sums.feet.left, share * sums.feet.turn};
  const ContactForce resisted{share * sums.resisted.forward, share * sums.resisted.left,
                              share * sums.resisted.turn};
  feeling.load = maths::clamp(loadOf(resisted, feet, walk.set.freeLoad, params), -1.0, 1.0);
}

bool stuck(double load, const FeelingParams& params, FeelingState& state) {
  const double bound = state.stuck ? params.freeLoad : params.stuckLoad;
  state.loadedSeconds = load > bound ? state.loadedSeconds + kMessageSeconds : 0.0;
  const bool held = load > bound && state.falls.fallen == FallSide::none;
  state.stuck = held && (state.stuck || state.loadedSeconds >= params.stuckSeconds);
  return state.stuck;
}

}  // namespace

double freeLoad(const Velocity& feet, const FreeLoad& params) {
  const double ahead = feet.forward < 0.0 ? -params.back : params.forward;
  return ahead * feet.forward + params.left * std::fabs(feet.left) +
         params.turn * std::fabs(feet.turn);
}

Feeling feel(const MotionInput& in, const WalkState& walk, Legs legs, const FeelingParams& params,
             FeelingState& state) {
  stepFalls(in, params.falls, state.falls);
  const bool upright = state.falls.fallen == FallSide::none;
  const bool onFeet = legs.footing == Footing::stands || legs.footing == Footing::standsUp;
  stepLifted(in, onFeet && !upright ? Footing::other : legs.footing, params.lift, state.lift);
  const FeltTick commanded{0.0, {}, walk.feet, airborne(walk, params.airborne)};
  for (double& left : state.blockedSeconds) left = std::max(0.0, left - kMessageSeconds);
  for (const SensorFrame& tick : in.sensors) recordTick(tick, commanded, legs.walk, params, state);
  Feeling feeling;
  feelLoad(walk, params, state, feeling);
  feeling.stuck = stuck(feeling.load, params, state);
  feeling.fallen = state.falls.fallen;
  feeling.lifted = state.lift.lifted;
  for (std::size_t i = 0; i < feeling.pawBlocked.size(); ++i)
    feeling.pawBlocked[i] = state.blockedSeconds[i] > 0.0;
  return feeling;
}

}  // namespace kelpie::actuator

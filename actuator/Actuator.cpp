// SPDX-License-Identifier: Apache-2.0
#include "actuator/Actuator.h"

#include <cmath>

#include "actuator/ChestKick.h"
#include "actuator/Effort.h"
#include "actuator/Gait.h"
#include "actuator/Head.h"
#include "robot/body/Legs.h"

namespace kelpie::actuator {
namespace {

constexpr double kMouthClosed = -3.0;  // deg, the soft limit
constexpr double kMouthOpen = -50.0;   // deg
constexpr double kTailRest = 30.0;     // deg

std::uint32_t rampTicks(const ActuatorParams& params) {
  return static_cast<std::uint32_t>(params.rampSeconds / kTickSeconds + 0.5);
}

// The first message: the ramp starts where the joints are.
void begin(const MotionInput& in, ActuatorState& state) {
  state.started = true;
  state.rampFrom = in.sensors.back().joints;
  for (Angle& angle : state.rampFrom.angle)
    if (!std::isfinite(angle.rad())) angle = Angle();
  state.target = state.rampFrom;
}

// A motion starts when it is newly requested, between two steps, when all feet are down.
void startMotion(const Command& command, const ActuatorParams& params, ActuatorState& state) {
  const bool asked = command.motion != MotionKind::none;
  if (!asked) state.motion.answered = false;
  const bool between = state.gait.tick % params.gait.halfStepTicks == 0;
  if (!asked || state.motion.answered || state.motion.kind != MotionKind::none || !between) return;
  state.motion = {command.motion, 0, true};
}

bool motionRunning(const ActuatorState& state) { return state.motion.kind != MotionKind::none; }

std::uint32_t motionTicks(MotionKind kind, const ActuatorParams& params) {
  return kind == MotionKind::kickForward ? chestKickTicks(params.kick)
                                         : 2 * params.gait.halfStepTicks;
}

void stepMotion(const ActuatorParams& params, ActuatorState& state) {
  if (state.motion.kind == MotionKind::kickForward)
    stepChestKick(state.motion.tick, params, state.gait);
  else
    stepGait({}, params, state.gait);
  if (++state.motion.tick < motionTicks(state.motion.kind, params)) return;
  state.motion = {MotionKind::none, 0, true};
}

void stepLegs(const Command& command, const ActuatorParams& params, ActuatorState& state) {
  startMotion(command, params, state);
  if (motionRunning(state))
    stepMotion(params, state);
  else
    stepGait(command.walk, params, state.gait);
}

JointAngles targetsOf(const Command& command, const ActuatorParams& params,
                      const ActuatorState& state) {
  JointAngles target = headTarget(command.head, state.target, params);
  legsForFeet(state.gait, params.stance, target);
  target[Joint::mouth] = Angle::deg(command.mouthOpen ? kMouthOpen : kMouthClosed);
  target[Joint::tailTilt] = Angle::deg(kTailRest);
  return target;
}

// From the sensed pose to the stance along a straight line in joint space.
JointAngles ramped(const JointAngles& target, const ActuatorParams& params, ActuatorState& state) {
  const std::uint32_t all = rampTicks(params);
  if (state.rampTick >= all) return target;
  const double share = static_cast<double>(++state.rampTick) / static_cast<double>(all);
  JointAngles between = target;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const Angle from = state.rampFrom.angle[j];
    between.angle[j] = from + (target.angle[j] - from) * share;
  }
  return between;
}

// The one clamp that every joint passes: soft limits, and a limited change per tick.
void guard(const JointAngles& target, const ActuatorParams& params, ActuatorState& state) {
  const JointAngles limited = body::withinLimits(target);
  const bool motion = motionRunning(state);
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const bool leg = j >= index(Joint::leftFrontRotator) && j <= index(Joint::rightHindKnee);
    const double maxStep = (!leg     ? params.headSlew
                            : motion ? params.motionSlew
                                     : params.walkSlew)
                               .rad();
    const double step = (limited.angle[j] - state.target.angle[j]).rad();
    if (!std::isfinite(step)) continue;
    state.target.angle[j] =
        std::fabs(step) <= maxStep
            ? limited.angle[j]
            : Angle::rad(state.target.angle[j].rad() + (step > 0 ? maxStep : -maxStep));
  }
}

bool ready(const ActuatorParams& params, const ActuatorState& state) {
  return state.rampTick >= rampTicks(params);
}

void record(ActuatorState& state) {
  state.walked[state.walkedNext % state.walked.size()] = state.gait.velocity;
  ++state.walkedNext;
}

void tick(const Command& command, const ActuatorParams& params, ActuatorState& state) {
  const bool moving = motionRunning(state);
  if (ready(params, state))
    stepLegs(command, params, state);
  else
    stepGait({}, params, state.gait);
  guard(ramped(targetsOf(command, params, state), params, state), params, state);
  record(state);
  // A motion ends at rest: what its last tick leaves of speed would cost two half steps.
  if (moving && !motionRunning(state)) state.gait.velocity = {};
}

bool walking(const ActuatorParams& params, const ActuatorState& state) {
  return ready(params, state) && !motionRunning(state) && !state.gait.standing;
}

// A kick needs all the strength there is (facts-2005 section 2.5).
bool lowGain(const ActuatorState& state) { return state.gain.low && !motionRunning(state); }

// What the body did in the last four ticks: commanded velocity some ticks ago, calibrated.
Odometry odometry(const OdometryParams& params, const ActuatorState& state) {
  const OdometryScales& scales = lowGain(state) ? params.low : params.high;
  Odometry sum;
  for (std::uint32_t i = kTicksPerMessage; i >= 1; --i) {
    if (state.walkedNext < i + params.delayTicks) continue;
    const Velocity& v =
        state.walked[(state.walkedNext - i - params.delayTicks) % state.walked.size()];
    const double forward = v.forward * scales.forward * kTickSeconds;
    const double left = v.left * scales.left * kTickSeconds;
    sum.forward += forward * sum.turn.cos() - left * sum.turn.sin();
    sum.left += forward * sum.turn.sin() + left * sum.turn.cos();
    sum.turn = sum.turn + Angle::rad(v.turn * scales.turn * kTickSeconds);
  }
  return sum;
}

MotionStatus status(const ActuatorParams& params, const ActuatorState& state) {
  MotionStatus now;
  now.ready = ready(params, state);
  now.running = state.motion.kind;
  if (motionRunning(state))
    now.secondsLeft = kTickSeconds * (motionTicks(state.motion.kind, params) - state.motion.tick);
  now.effort = effort(state.effort, params.gait);
  now.lowGain = lowGain(state);
  return now;
}

}  // namespace

MotionOutput step(const MotionInput& in, const ActuatorParams& params, ActuatorState& state) {
  if (!state.started) begin(in, state);
  MotionOutput out;
  stepGain(in.batteryCurrent, params.gain, state.gain);
  recordEffort(in, walking(params, state), state.effort);
  for (JointFrame& frame : out.joints) {
    tick(in.command, params, state);
    frame = {state.target, in.command.leds};
  }
  out.odometry = odometry(params.odometry, state);
  out.stance = body::stanceFromLegs(in.sensors.back().joints);
  out.status = status(params, state);
  return out;
}

}  // namespace kelpie::actuator

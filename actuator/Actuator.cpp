// SPDX-License-Identifier: Apache-2.0
#include "actuator/Actuator.h"

#include <cmath>

#include "actuator/motion/Gaze.h"
#include "actuator/motion/Head.h"
#include "actuator/motion/JointLimits.h"
#include "actuator/motion/Lie.h"
#include "robot/body/Legs.h"

namespace kelpie::actuator {
namespace {

constexpr double kMouthClosed = -3.0;  // deg, the soft limits
constexpr double kMouthOpen = -55.0;

// The first message: the ramp starts where the joints are.
void begin(const MotionInput& in, const ActuatorParams& params, ActuatorState& state) {
  state.started = true;
  state.target = in.sensors.back().joints;
  for (Angle& angle : state.target.angle)
    if (!std::isfinite(angle.rad())) angle = Angle();
  state.odometry.reach.felt = state.target;
  begin(params, state.approach);
}

bool canStart(MotionKind kind, const ActuatorParams& params, const ActuatorState& state) {
  const MotionData& motion = params.motions[kind];
  return !motion.frames.empty() && (motion.atOnce || betweenSteps(state.walk));
}

// A motion starts when it is newly requested. A blend that is under way gives way to it.
void startMotion(const Command& command, const ActuatorParams& params, ActuatorState& state) {
  const bool asked = command.motion != MotionKind::none && !state.lies;
  if (!asked) state.motion.answered = false;
  if (!asked || state.motion.answered || running(state.motion)) return;
  if (canStart(command.motion, params, state)) begin(command.motion, state.target, state.motion);
}

// How the legs shall walk, what a motion wants of them first.
WalkRequest walkWanted(const Command& command, const ActuatorParams& params,
                       const ActuatorState& state) {
  WalkRequest request = command.walk;
  if (!state.ready || state.lies) request = {};
  if (running(state.motion)) {
    const KeyFrame& key = keyFrame(params.motions, state.motion);
    request = key.walk;
    if (key.legs != KeyLegs::walk) request = {0.0, 0.0, 0.0, 0.0, key.walk.kind};
  }
  if (state.gain.low && !running(state.motion)) request.kind = WalkKind::weak;
  return request;
}

// An approach ends when all joints have arrived, so that none may chase what moves faster: head,
// mouth and tail wait for the legs.
bool atEase(const ActuatorState& state) { return state.approach.active || state.lies; }

// One message's Command. Where the head shall go follows from it and from the stance, which stay
// the same for its four ticks.
struct Asked {
  const Command& command;
  HeadRequest head;
};

JointAngles targetOf(const Asked& asked, const ActuatorParams& params, ActuatorState& state) {
  const Command& command = asked.command;
  stepWalk(walkWanted(command, params, state), params, state.walk);
  JointAngles target = headTarget(asked.head, state.target, params);
  setLegs(state.walk.set, state.walk.feet, state.walk.phase, target);
  const TailRequest tail = atEase(state) ? TailRequest{} : command.tail;
  const bool open = command.mouthOpen && !atEase(state);
  target[Joint::mouth] = Angle::deg(open ? kMouthOpen : kMouthClosed);
  target[Joint::tailTilt] = tail.tilt;
  target[Joint::tailPan] = tail.pan;
  if (state.lies) lieDown(target);
  return target;
}

JointAngles blended(const JointAngles& target, ActuatorState& state) {
  if (state.blend.tick >= state.blend.ticks) return target;
  const double share = static_cast<double>(++state.blend.tick) / state.blend.ticks;
  JointAngles between = target;
  for (std::size_t j = 0; j < kJointCount; ++j)
    between.angle[j] = partWay(state.blend.from.angle[j], target.angle[j], share);
  return between;
}

bool walksOn(const ActuatorParams& params, const ActuatorState& state) {
  return !running(state.motion) || keyFrame(params.motions, state.motion).legs == KeyLegs::walk;
}

CommandedTick tickOf(const MotionData& motion) {
  const MotionWay& way = motion.way;
  const double ticks = ticksOf(motion);
  CommandedTick tick;
  const double seconds = kTickSeconds * ticks;
  tick.real = {way.forward / seconds, way.left / seconds, way.turn.rad() / seconds};
  tick.motion = {maths::square(way.forwardSd) / ticks, maths::square(way.leftSd) / ticks,
                 maths::square(way.turnSd.rad()) / ticks};
  return tick;
}

// What this tick's commands make likely, for the odometry.
CommandedTick commandedNow(const ActuatorParams& params, ActuatorState& state) {
  if (!walksOn(params, state)) return tickOf(params.motions[state.motion.kind]);
  const WalkSet& set = state.walk.set;
  CommandedTick tick;
  if (params.physical) tick.felt = felt(state.walk.feet, state.odometry);
  tick.real = likelySpeed(state.walk.feet, tick.felt, set.odometry);
  tick.stride = {state.walk.feet, state.walk.phase};
  if (params.physical) tick.swing = swing(tick.stride, set);
  if (!still(state.walk.feet))
    tick.joints = {set.odometry.forward.joints, set.odometry.left.joints, set.odometry.turn.joints};
  return tick;
}

// After its last key frame the legs go back to the walk in a straight line.
void endMotion(bool legsMoved, const ActuatorParams& params, ActuatorState& state) {
  const std::uint32_t ticks = params.motions[state.motion.kind].returnTicks;
  if (legsMoved) {
    stopWalk(state.walk);
    state.blend = {state.target, 0, ticks};
  }
  state.motion = {};
  state.motion.answered = true;
}

void moveOn(MotionKind asked, const ActuatorParams& params, ActuatorState& state) {
  const bool legsMoved = !walksOn(params, state);
  if (legsMoved) stopWalk(state.walk);
  bool goesOn = true;
  const int ticks = hurried(params.motions, asked, state.motion) ? 2 : 1;
  for (int i = 0; i < ticks && goesOn; ++i)
    goesOn = advance(params.motions, state.target, state.motion);
  if (!goesOn) endMotion(legsMoved, params, state);
}

// What is commanded of joints that stay as they were found: no walk, no odometry.
void tickAsFound(ActuatorState& state) {
  state.ready = false;
  state.legGain = 1.0;
  record({}, state.odometry);
}

void tick(const Asked& asked, const ActuatorParams& params, ActuatorState& state) {
  state.ready = !state.approach.active && !state.found;
  if (state.ready) startMotion(asked.command, params, state);
  JointAngles target = targetOf(asked, params, state);
  SlewLimits slew{params.headSlew, params.walkSlew};
  if (state.approach.active) {
    const Angle gentle = Angle::rad(params.startRate.rad() * kTickSeconds);
    slew = {gentle, gentle};
    target = approached(target, state.target, params, state.approach);
  } else if (running(state.motion)) {
    const Angle wide = params.motions[state.motion.kind].slew;
    slew = {wide, wide};
    target = played(params.motions, target, state.motion);
  } else {
    target = blended(target, state);
  }
  const JointAngles before = state.target;
  state.target = limited(target, before, slew);
  CommandedTick now = commandedNow(params, state);
  now.commanded = movedBy(before, state.target);
  record(now, state.odometry);
  state.legGain = std::fmax(state.legGain, legGain(params.motions, state.motion));
  if (running(state.motion)) moveOn(asked.command.motion, params, state);
}

// Up for a while at most, then down until it was asked down.
bool earNow(bool up, const ActuatorParams& params, std::uint32_t& ticks) {
  ticks = up ? ticks + 1 : 0;
  return up && ticks * kTickSeconds <= params.earSeconds;
}

EarRequest earsNow(const EarRequest& ears, const ActuatorParams& params, ActuatorState& state) {
  return {earNow(ears.leftUp, params, state.earTicks[0]),
          earNow(ears.rightUp, params, state.earTicks[1])};
}

bool walking(const ActuatorParams& params, const ActuatorState& state) {
  return state.ready && walksOn(params, state) && !standing(state.walk);
}

Footing footing(const ActuatorParams& params, const ActuatorState& state) {
  if (state.found) return Footing::other;
  if (state.lies) return Footing::lies;
  if (state.approach.active) return Footing::standsUp;
  if (isGetUp(state.motion.kind)) return Footing::getsUp;
  return state.ready && walksOn(params, state) ? Footing::stands : Footing::other;
}

// A kick needs all the strength there is (facts-2005 section 2.5).
bool lowGain(const ActuatorState& state) { return state.gain.low && !running(state.motion); }

Stance stanceAt(std::size_t tick, const Stance& legs, const ActuatorParams& params,
                const ActuatorState& state) {
  if (!params.physical) return legs;
  return oscillating(legs, shown(tick, params.odometry, state.odometry).stride, state.walk.set);
}

MotionStatus status(MotionKind asked, const ActuatorParams& params, const ActuatorState& state) {
  MotionStatus now;
  now.ready = state.ready;
  now.lying = state.lies && !state.approach.active;
  now.running = state.motion.kind;
  if (running(state.motion)) {
    const std::uint32_t all = ticksOf(params.motions[state.motion.kind]);
    const double pace = hurried(params.motions, asked, state.motion) ? 2.0 : 1.0;
    now.secondsLeft = kTickSeconds * (all - state.motion.tick) / pace;
  }
  now.effort = effort(state.effort, state.walk.set.gait);
  now.lowGain = lowGain(state);
  return now;
}

}  // namespace

MotionOutput step(const MotionInput& in, const ActuatorParams& params, ActuatorState& state) {
  if (!state.started) begin(in, params, state);
  stepRest(in, params, state);
  SensedPoses poses;
  for (std::size_t i = 0; i < kTicksPerMessage; ++i) poses[i] = poseOf(in.sensors[i]);
  state.stance = poses.back().stance;
  MotionOutput out;
  stepGain(in.batteryCurrent, params.gain, state.gain);
  recordEffort(in, walking(params, state), state.effort);
  const Feeling feeling = feel(in, state.walk, {footing(params, state), walking(params, state)},
                               params.feeling, state.feeling);
  if (walking(params, state)) recordLoad(feeling.load, state.odometry);
  const bool held = stepHeldBall(in, state.target, params.feeling.heldBall, state.heldBall);
  // Reported with the message that is sent as the one before it begins to be played.
  const double gain = state.legGain;
  state.legGain = 0.0;
  state.walk.known = false;
  const Asked asked{in.command,
                    asJoints(atEase(state) ? HeadRequest{} : in.command.head, state.stance)};
  for (JointFrame& frame : out.joints) {
    if (state.found) {
      tickAsFound(state);
    } else {
      tick(asked, params, state);
    }
    frame = {state.target, in.command.leds, earsNow(in.command.ears, params, state)};
  }
  out.odometry = odometry(in, poses, params.odometry, state.odometry);
  for (std::size_t i = 0; i < kTicksPerMessage; ++i)
    out.stances[i] = stanceAt(i, poses[i].stance, params, state);
  out.status = status(in.command.motion, params, state);
  out.status.legGain = gain;
  out.status.feeling = feeling;
  out.status.feeling.ballHeld = held;
  return out;
}

}  // namespace kelpie::actuator

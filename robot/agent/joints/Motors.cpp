// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/joints/Motors.h"

#include <algorithm>

namespace kelpie::agent {
namespace {

double secondsSince(TimeUs then, const MotorsIn& in) { return (in.time - then).seconds(); }

bool takesPower(const Cause& cause) { return cause.demand >= Demand::noPower; }

void enter(MotorPhase phase, const MotorsIn& in, MotorsState& state) {
  state.phase = phase;
  state.since = in.time;
}

// Nothing holds the joints from now on, and they are held again one by one.
void beginAgain(Rest why, const MotorsIn& in, MotorsState& state) {
  enter(MotorPhase::powered, in, state);
  state.why = why;
  state.messages = {};
}

void end(Rest why, const MotorsIn& in, MotorsState& state) {
  enter(MotorPhase::ended, in, state);
  state.why = why;
}

bool holds(MotorPhase phase) {
  return phase == MotorPhase::gaining || phase == MotorPhase::waiting ||
         phase == MotorPhase::plays || phase == MotorPhase::liesDown;
}

bool asks(const MotorsIn& in, const MotorsState& state) { return in.time < state.askUntil; }

void ask(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  state.askUntil = {in.time.us + TimeUs::fromSeconds(params.askSeconds).us};
}

// A press counts when it begins: a hand that stays on the head fights no jam. Whether one has
// begun that is meant for the motors.
bool askedForPower(const MotorsIn& in, MotorsState& state) {
  const bool begins = in.pressed && !state.pressed;
  const bool lacks =
      state.phase == MotorPhase::powered && !in.report.motorPower && state.why == Rest::powerless;
  const bool forMotors = begins && (lacks || state.phase == MotorPhase::ended);
  state.pressed = in.pressed;
  state.tookPress = in.pressed && (state.tookPress || forMotors);
  return forMotors;
}

// One joint more, once the one before is held.
void gainOneMore(const MotorsIn& in, MotorsState& state) {
  const auto first = std::find(state.messages.begin(), state.messages.end(), 0U);
  const auto next = static_cast<std::size_t>(first - state.messages.begin());
  const bool ready = next == 0 || (in.held >> (next - 1) & 1U) != 0;
  for (std::size_t j = 0; j < next; ++j) ++state.messages[j];
  if (next < kJointCount && ready) state.messages[next] = 1;
}

void stepPowered(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  if (in.report.motorPower) state.askUntil = {};
  const bool cut = state.hadPower && !in.report.motorPower;
  const bool never = !in.report.motorPower && !asks(in, state);
  if (cut || never) state.why = Rest::powerless;
  if (!in.report.motorPower || in.lifted) state.since = in.time;
  if (secondsSince(state.since, in) >= params.settleSeconds) enter(MotorPhase::gaining, in, state);
}

// A joint that takes no gain is none that follows.
void stepGaining(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  gainOneMore(in, state);
  const bool full = state.messages.back() >= params.rampMessages;
  if (full && in.held == kAllJoints) return enter(MotorPhase::waiting, in, state);
  if (secondsSince(state.since, in) >= params.gainSeconds) end(Rest::jointStuck, in, state);
}

void stepLying(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  const bool off = state.switchesOff || takesPower(in.cause);
  if (in.cause.rest == Rest::none && !off) return enter(MotorPhase::plays, in, state);
  if (!off) state.why = in.cause.rest;
  const bool down = in.lying || secondsSince(state.since, in) >= params.lieSeconds;
  if (down && off) end(state.why, in, state);
}

void stepPhase(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  const bool free = in.cause.rest == Rest::none;
  switch (state.phase) {
    case MotorPhase::off: ask(in, params, state); return beginAgain(Rest::starting, in, state);
    case MotorPhase::powered: return stepPowered(in, params, state);
    case MotorPhase::gaining: return stepGaining(in, params, state);
    case MotorPhase::waiting:
      if (in.asked && free) enter(MotorPhase::plays, in, state);
      return;
    case MotorPhase::plays:
      if (free) return;
      state.why = in.cause.rest;
      return enter(MotorPhase::liesDown, in, state);
    case MotorPhase::liesDown: return stepLying(in, params, state);
    case MotorPhase::ended: return;
  }
}

// In any phase: being lifted, and power or a gain that nobody here has taken away.
void stepLoss(const MotorsIn& in, MotorsState& state) {
  if (!holds(state.phase)) return;
  if (in.lifted) return beginAgain(Rest::lifted, in, state);
  const bool lost = (state.held & ~in.held) != 0;
  if (lost || !in.report.motorPower) beginAgain(Rest::powerless, in, state);
}

// In any phase: a cause that takes the power. Only a robot that stands lies down first.
void stepEnd(const MotorsIn& in, MotorsState& state) {
  const bool gravest = in.cause.demand == Demand::switchOff;
  if (takesPower(in.cause) && (gravest || !state.switchesOff)) state.why = in.cause.rest;
  state.switchesOff = state.switchesOff || gravest;
  if (!takesPower(in.cause) && !state.switchesOff) return;
  if (state.phase == MotorPhase::liesDown || state.phase == MotorPhase::ended) return;
  const bool stands = state.phase == MotorPhase::plays;
  enter(stands ? MotorPhase::liesDown : MotorPhase::ended, in, state);
}

void stepPress(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  if (!askedForPower(in, state) || takesPower(in.cause) || state.switchesOff) return;
  ask(in, params, state);
  if (state.phase == MotorPhase::ended) beginAgain(Rest::starting, in, state);
}

Rest restIn(const MotorsIn& in, const MotorsState& state) {
  switch (state.phase) {
    case MotorPhase::plays: return Rest::none;
    case MotorPhase::liesDown:
    case MotorPhase::ended: return state.why;
    case MotorPhase::waiting: return Rest::unasked;
    case MotorPhase::gaining: return Rest::starting;
    default: break;
  }
  return in.lifted ? Rest::lifted : state.why;
}

// A robot that stays as it is found tells of a pause, too; and of a camera that is silent where it
// would else ask for the head to be pressed.
Rest reasonIn(const MotorsIn& in, const MotorsState& state) {
  const Rest rest = restIn(in, state);
  const bool says = in.cause.rest == Rest::paused ||
                    (in.cause.rest != Rest::none && state.phase == MotorPhase::waiting);
  return staysAsFound(rest) && says ? in.cause.rest : rest;
}

MotorOrder orderIn(const MotorsIn& in, const MotorsParams& params, const MotorsState& state) {
  MotorOrder order;
  order.shutDown = state.phase == MotorPhase::ended && state.switchesOff;
  order.power = holds(state.phase) ||
                (state.phase == MotorPhase::powered && (in.report.motorPower || asks(in, state)));
  if (!holds(state.phase)) return order;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double share = static_cast<double>(state.messages[j]) / params.rampMessages;
    order.strength[j] = std::min(share, 1.0);
  }
  return order;
}

}  // namespace

MotorsOut step(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  stepPress(in, params, state);
  stepLoss(in, state);
  stepEnd(in, state);
  stepPhase(in, params, state);
  state.hadPower = in.report.motorPower;
  state.held = holds(state.phase) ? in.held : 0U;
  return {restIn(in, state), reasonIn(in, state), orderIn(in, params, state), state.tookPress};
}

}  // namespace kelpie::agent

// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/Motors.h"

#include <algorithm>

namespace kelpie::agent {
namespace {

// Ends with the robot switched off, as Sony's PowerMonitor has it.
bool endsTheSystem(Rest cause) { return cause == Rest::paused || cause == Rest::batteryLow; }

double secondsSince(TimeUs then, const MotorsIn& in) { return (in.time - then).seconds(); }

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

bool holds(MotorPhase phase) {
  return phase == MotorPhase::gaining || phase == MotorPhase::waiting ||
         phase == MotorPhase::plays || phase == MotorPhase::liesDown;
}

// Whether the cause takes the power away and not only the play; a short press of the pause switch
// does not.
bool forbidsPower(const MotorsIn& in, const MotorsParams& params, const MotorsState& state) {
  if (in.cause == Rest::paused) return secondsSince(state.freeAt, in) >= params.pauseHoldSeconds;
  return in.cause != Rest::none && in.cause != Rest::blind;
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
  if (!in.report.motorPower || in.lifted) state.since = in.time;
  if (secondsSince(state.since, in) >= params.settleSeconds) enter(MotorPhase::gaining, in, state);
}

void stepGaining(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  gainOneMore(in, state);
  const bool full = state.messages.back() >= params.rampMessages;
  if (full && in.held == kAllJoints) enter(MotorPhase::waiting, in, state);
}

void stepLying(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  if (in.cause == Rest::none) return enter(MotorPhase::plays, in, state);
  state.why = in.cause;
  const bool down =
      in.lying || !in.report.motorPower || secondsSince(state.since, in) >= params.lieSeconds;
  if (down && forbidsPower(in, params, state)) enter(MotorPhase::ended, in, state);
}

void stepPhase(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  switch (state.phase) {
    case MotorPhase::off: return beginAgain(Rest::starting, in, state);
    case MotorPhase::powered: return stepPowered(in, params, state);
    case MotorPhase::gaining: return stepGaining(in, params, state);
    case MotorPhase::waiting:
      if (in.asked && in.cause == Rest::none) enter(MotorPhase::plays, in, state);
      return;
    case MotorPhase::plays:
      if (in.cause == Rest::none) return;
      state.why = in.cause;
      return enter(MotorPhase::liesDown, in, state);
    case MotorPhase::liesDown: return stepLying(in, params, state);
    case MotorPhase::ended: break;
  }
  const bool over = in.cause == Rest::none && !endsTheSystem(state.why);
  if (over && in.pressed) beginAgain(Rest::starting, in, state);
}

// What befalls a robot in any phase: hands, a jam, and a cause that comes before it has stood up.
void stepBefallen(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  const bool standsOrLies = state.phase == MotorPhase::plays || state.phase == MotorPhase::liesDown;
  if (!standsOrLies && state.phase != MotorPhase::ended && forbidsPower(in, params, state)) {
    state.why = in.cause;
    return enter(MotorPhase::ended, in, state);
  }
  if (!holds(state.phase)) return;
  if (in.lifted) return beginAgain(Rest::lifted, in, state);
  // The pause switch takes the motors' power, too.
  const bool lies = state.phase == MotorPhase::liesDown;
  if (!in.report.motorPower && !lies) beginAgain(Rest::powerless, in, state);
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

// Power that the robot took away is asked for again when a person presses the head, not at once.
bool powerIn(const MotorsIn& in, const MotorsState& state) {
  if (holds(state.phase)) return in.report.motorPower;
  if (state.phase != MotorPhase::powered) return false;
  return state.why != Rest::powerless || in.report.motorPower || in.pressed;
}

MotorOrder orderIn(const MotorsIn& in, const MotorsParams& params, const MotorsState& state) {
  MotorOrder order;
  order.power = powerIn(in, state);
  order.shutDown = state.phase == MotorPhase::ended && endsTheSystem(state.why);
  if (!holds(state.phase)) return order;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double share = static_cast<double>(state.messages[j]) / params.rampMessages;
    order.strength[j] = std::min(share, 1.0);
  }
  return order;
}

}  // namespace

MotorsOut step(const MotorsIn& in, const MotorsParams& params, MotorsState& state) {
  if (in.cause == Rest::none) state.freeAt = in.time;
  stepPhase(in, params, state);
  stepBefallen(in, params, state);
  return {restIn(in, state), orderIn(in, params, state)};
}

}  // namespace kelpie::agent

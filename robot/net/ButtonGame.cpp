// SPDX-License-Identifier: Apache-2.0
#include "robot/net/ButtonGame.h"

namespace kelpie::net {
namespace {

struct Press {
  bool ended = false;
  double held = 0.0;  // s
};

Press follow(bool down, TimeUs now, ButtonState::Button& button) {
  if (down && !button.down) button = {true, now};
  const double held = button.down ? (now - button.since).seconds() : 0.0;
  const bool ended = button.down && !down;
  button.down = down;
  return {ended, held};
}

void advance(ButtonState& state) {
  if (state.penalised) {
    state.penalised = false;
    state.play = PlayState::playing;
  } else if (state.play == PlayState::initial) {
    state.play = PlayState::ready;
  } else if (state.play == PlayState::ready) {
    state.play = PlayState::set;
  } else if (state.play == PlayState::set) {
    state.play = PlayState::playing;
  }
}

void penalise(ButtonState& state) {
  if (state.play != PlayState::initial) state.penalised = true;
}

void reset(ButtonState& state) {
  state.play = PlayState::initial;
  state.penalised = false;
}

bool isPress(const Press& press, double longest, const ButtonParams& params) {
  return press.ended && press.held >= params.press && press.held < longest;
}

}  // namespace

ButtonGame step(const ButtonIn& in, const ButtonParams& params, ButtonState& state) {
  const auto& switches = in.sensors.back;
  const Press head = follow(in.sensors.headTouch >= params.headThreshold, in.time, state.head);
  const Press back = follow(switches[0] || switches[1] || switches[2], in.time, state.back);
  if (state.head.down && head.held >= params.resetHold) reset(state);
  if (state.back.down && back.held >= params.penaltyHold) penalise(state);
  if (isPress(head, params.resetHold, params) ||
      (params.backAdvances && isPress(back, params.penaltyHold, params)))
    advance(state);
  return {state.play, state.penalised};
}

}  // namespace kelpie::net

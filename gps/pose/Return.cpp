// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Return.h"

#include "gps/pose/Modes.h"
#include "robot/core/Maths.h"

namespace kelpie::gps {
namespace {

PoseMode besideHalfWay(const body::FieldDescription& field, const ReturnParams& params, bool left) {
  const double x = field.borderWidth + params.inside;
  PoseMode mode;
  mode.weight = 0.5;
  mode.pose = {{left ? x : field.width - x, 0.5 * field.length}, Angle::deg(left ? 0.0 : 180.0)};
  const double position = maths::square(params.positionSd);
  mode.covariance = {position, 0, 0, 0, position, 0, 0, 0, maths::square(params.headingSd.rad())};
  return mode;
}

}  // namespace

void stepLift(bool lifted, const body::FieldDescription& field, const ModeParams& params,
              PoseState& state) {
  if (lifted != state.lifted) lose(field, params, state);
  state.lifted = lifted;
}

void stepReturn(const GameState& game, const body::FieldDescription& field,
                const ReturnParams& params, PoseState& state) {
  const bool returns = state.penalised && !game.penalised && game.state != PlayState::initial;
  state.penalised = game.penalised;
  if (!returns || !params.use) return;
  const CameraTilt tilt = tiltOf(state.modes);
  state.modes.clear();
  for (const bool left : {true, false}) {
    state.modes.push_back(besideHalfWay(field, params, left));
    state.modes.back().tilt = tilt;
  }
  state.lost = false;
  state.unexplained = 0;
  state.surprising = {};
}

}  // namespace kelpie::gps

// SPDX-License-Identifier: Apache-2.0
#include "gps/Lines.h"

#include <cmath>

#include "gps/LineMap.h"
#include "gps/LinePoseSearch.h"
#include "gps/LineUpdate.h"
#include "gps/Pinks.h"
#include "robot/body/Camera.h"

namespace kelpie::gps {
namespace {

SeenLines linesToMatch(const Percepts& percepts, const GpsParams& params, LineMap& map) {
  const SeenLines frame = seenLines(percepts.linePoints, params.line);
  if (countOf(map, LinePointKind::line) <= frame.lines.size()) return frame;
  const SeenLines mapped = seenLines(map, params.lineMap.matched, params.lineMap);
  map.newCount = 0.0;
  return mapped;
}

}  // namespace

double headSpeedOf(const FrameInput& input) {
  constexpr double kUnknownSpeed = 1.0;  // faster than any head
  const double speed = body::headSpeed(input.headRate);
  return std::isfinite(speed) ? speed : kUnknownSpeed;
}

bool linesUsable(const GpsParams& params, const GpsState& state) {
  return params.line.use && !state.lost && !state.stuck.paused;
}

bool stepLines(const FrameInput& input, const Percepts& percepts, const GpsParams& params,
               GpsState& state) {
  if (!params.line.use) return false;
  stepMap(input, percepts.linePoints, params.line, params.lineMap, state.map);
  // Among pinks their own search finds the pose.
  if (landmarksCount(input) && stepLinePoseSearch(input, params, state)) return true;
  if (!linesUsable(params, state)) return false;
  const SeenLines seen = linesToMatch(percepts, params, state.map);
  const bool used = updateByLines(seen, headSpeedOf(input), params, state);
  const bool refused = !used && seen.lines.size() >= params.line.minPoints;
  state.map.refused = refused ? state.map.refused + 1 : 0;
  return used;
}

}  // namespace kelpie::gps

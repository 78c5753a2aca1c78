// SPDX-License-Identifier: Apache-2.0
#include "gps/Lines.h"

#include <cmath>

#include "gps/GlobalSearch.h"
#include "gps/LineMap.h"
#include "gps/LineUpdate.h"
#include "robot/body/Camera.h"

namespace kelpie::gps {
namespace {

SeenLines linesToMatch(const Percepts& percepts, const GpsParams& params, LineMap& map) {
  const SeenLines frame = seenLines(percepts.linePoints, params.line);
  if (countOf(map, LinePointKind::line) <= frame.lines.size()) return frame;
  const SeenLines mapped = seenLines(map, params.lineMap.matched, params.lineMap);
  map.fresh = 0.0;
  return mapped;
}

}  // namespace

bool stepLines(const FrameInput& input, const Percepts& percepts, const GpsParams& params,
               GpsState& state) {
  if (!params.line.use) return false;
  stepMap(input, percepts.linePoints, params.line, params.lineMap, state.map);
  if (stepSearch(input, params, state)) return true;
  if (state.lost) return false;
  const SeenLines seen = linesToMatch(percepts, params, state.map);
  constexpr double kUnknown = 1.0;  // rad a frame: faster than any head
  const double speed = body::headSpeed(input.headRate);
  const bool used = updateByLines(seen, std::isfinite(speed) ? speed : kUnknown, params, state);
  const bool refused = !used && seen.lines.size() >= params.line.minPoints;
  state.map.refused = refused ? state.map.refused + 1 : 0;
  return used;
}

}  // namespace kelpie::gps

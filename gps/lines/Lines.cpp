// SPDX-License-Identifier: Apache-2.0
#include "gps/lines/Lines.h"

#include <cmath>

#include "gps/camera/Lag.h"
#include "gps/lines/LineMap.h"
#include "robot/body/Camera.h"

namespace kelpie::gps {

double headSpeedOf(const FrameInput& input) {
  constexpr double kUnknownSpeed = 1.0;  // faster than any head
  const double speed = body::headSpeed(input.headRate);
  return std::isfinite(speed) ? speed : kUnknownSpeed;
}

SeenLines linesOfFrame(const GpsIn& in, const LineUpdateParams& params) {
  SeenLines seen = seenLines(in.percepts.linePoints, params);
  seen.headSpeed = headSpeedOf(in.input);
  seen.lateVariance = lateVariance(in.input);
  seen.eye = in.camera.position;
  seen.readWith = in.camera.tilt;
  return seen;
}

SeenLines linesOfFrameOrMap(const GpsIn& in, const LinesParams& params, LineMap& map) {
  const SeenLines frame = linesOfFrame(in, params.update);
  if (countOfWhite(map) <= frame.lines.size()) return frame;
  SeenLines mapped = seenLines(map, params.map.matched, params.map);
  mapped.headSpeed = frame.headSpeed;
  mapped.lateVariance = frame.lateVariance;
  mapped.eye = frame.eye;
  mapped.readWith = frame.readWith;
  map.newCount = 0.0;
  return mapped;
}

}  // namespace kelpie::gps

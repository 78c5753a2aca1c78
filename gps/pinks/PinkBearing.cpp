// SPDX-License-Identifier: Apache-2.0
#include "gps/pinks/PinkBearing.h"

#include <algorithm>
#include <cmath>

#include "gps/Refusal.h"
#include "robot/body/Camera.h"

namespace kelpie::gps {

std::optional<PinkBearing> bearingOf(const PinkPercept& percept, const CameraPose& camera) {
  PinkBearing seen;
  seen.eye = {camera.position.x, camera.position.y};
  seen.eyeHeight = camera.position.z;
  const Point2<Robot> way = robotPolar(percept.distance, percept.heading) - seen.eye;
  seen.heading = bearing(way);
  seen.elevation = percept.elevation;
  seen.variance = percept.headingVariance;
  const PixelBox& box = percept.box;
  seen.area = (box.right - box.left) * (box.bottom - box.top);
  const bool finite = std::isfinite(way.x) && std::isfinite(way.y) &&
                      std::isfinite(seen.eyeHeight) && std::isfinite(seen.elevation.rad()) &&
                      std::isfinite(seen.variance) && std::isfinite(seen.area);
  if (!finite || seen.variance <= 0.0 || way.norm() < 1.0) return std::nullopt;
  return seen;
}

PinkBearings bearingsOf(const GpsIn& in, GpsCounts& counts) {
  const CameraPose camera = body::cameraPose(in.input.sensors.joints, in.input.stance);
  PinkBearings bearings;
  for (const PinkPercept& percept : in.percepts.pinkPatches) {
    const auto seen = bearingOf(percept, camera);
    if (seen) bearings.push_back(*seen);
    if (!seen) count(Refusal::pinkNotFinite, counts);
  }
  for (std::size_t i = 1; i < bearings.size(); ++i)
    for (std::size_t j = i; j > 0 && bearings[j - 1].area < bearings[j].area; --j)
      std::swap(bearings[j - 1], bearings[j]);
  return bearings;
}

Angle headingAt(const PinkBearing& seen, double distance) {
  const Point2<Robot> along = robotPolar(1.0, seen.heading);
  const double ahead = seen.eye.x * along.x + seen.eye.y * along.y;
  const double lateral2 = maths::square(seen.eye.norm()) - ahead * ahead;
  const double reach = std::sqrt(std::max(1.0, distance * distance - lateral2));
  return bearing(seen.eye + along * (reach - ahead));
}

}  // namespace kelpie::gps

// SPDX-License-Identifier: Apache-2.0
#include "gps/PinkSight.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"

namespace kelpie::gps {

std::optional<PinkSight> sightOf(const PinkPercept& percept, const CameraPose& camera) {
  PinkSight sight;
  sight.eye = {camera.position.x, camera.position.y};
  sight.eyeHeight = camera.position.z;
  const Point2<Robot> way = robotPolar(percept.distance, percept.heading) - sight.eye;
  sight.heading = bearing(way);
  sight.elevation = percept.elevation;
  sight.variance = percept.headingVariance;
  const PixelBox& box = percept.box;
  sight.area = (box.right - box.left) * (box.bottom - box.top);
  const bool finite = std::isfinite(way.x) && std::isfinite(way.y) &&
                      std::isfinite(sight.eyeHeight) && std::isfinite(sight.elevation.rad()) &&
                      std::isfinite(sight.variance) && std::isfinite(sight.area);
  if (!finite || sight.variance <= 0.0 || way.norm() < 1.0) return std::nullopt;
  return sight;
}

PinkSights sightsOf(const FrameInput& input, const Percepts& percepts, GpsState& state) {
  const CameraPose camera = body::cameraPose(input.sensors.joints, input.stance);
  PinkSights sights;
  for (const PinkPercept& percept : percepts.pinkPatches) {
    const auto sight = sightOf(percept, camera);
    if (sight) sights.push_back(*sight);
    if (!sight) state.count(Refusal::pinkNotFinite);
  }
  for (std::size_t i = 1; i < sights.size(); ++i)
    for (std::size_t j = i; j > 0 && sights[j - 1].area < sights[j].area; --j)
      std::swap(sights[j - 1], sights[j]);
  return sights;
}

Angle headingAt(const PinkSight& sight, double distance) {
  const Point2<Robot> along = robotPolar(1.0, sight.heading);
  const double ahead = sight.eye.x * along.x + sight.eye.y * along.y;
  const double aside2 = maths::square(sight.eye.norm()) - ahead * ahead;
  const double reach = std::sqrt(std::max(1.0, distance * distance - aside2));
  return bearing(sight.eye + along * (reach - ahead));
}

}  // namespace kelpie::gps

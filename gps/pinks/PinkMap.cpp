// SPDX-License-Identifier: Apache-2.0
#include "gps/pinks/PinkMap.h"

#include <algorithm>
#include <cmath>

#include "gps/Refusal.h"

namespace kelpie::gps {
namespace {

double cross(Point2<Field> a, Point2<Field> b) { return a.x * b.y - a.y * b.x; }
double dot(Point2<Field> a, Point2<Field> b) { return a.x * b.x + a.y * b.y; }

bool knowsItsPlace(const PoseState& pose, const PinkMapParams& params) {
  if (pose.lost || pose.modes.empty()) return false;
  const std::array<double, 9>& c = pose.modes[0].covariance;
  const double max = maths::square(params.maxPositionSd);
  return c[0] <= max && c[4] <= max && c[8] <= maths::square(params.maxHeadingSd.rad());
}

std::optional<Refusal> refusal(const PinkBearing& bearing, const PinkSightings& seen,
                               const PinkMapParams& params) {
  if (!knowsItsPlace(seen.pose, params)) return Refusal::pinkPoseUnsure;
  const Ray ray = rayOf(seen.pose.modes[0].pose, bearing);
  const auto place = meetWall(ray, params.wall);
  if (!place) return Refusal::pinkOffWall;
  if (!mayHangOnWall(bearing.eyeHeight, bearing.elevation, distance(*place, ray.from), params))
    return Refusal::pinkElevation;
  if (!clearOfBeacons(ray, seen.landmarks, params.beaconClearance)) return Refusal::pinkNearBeacon;
  return std::nullopt;
}

}  // namespace

Ray rayOf(const Pose2& pose, const PinkBearing& bearing) {
  const Angle direction = pose.heading + bearing.heading;
  return {fieldFromRobot(pose, bearing.eye), {direction.cos(), direction.sin()}};
}

std::optional<Point2<Field>> meetWall(const Ray& ray, const std::array<double, 8>& wall) {
  double nearest = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    const Point2<Field> a{wall[2 * i], wall[2 * i + 1]};
    const Point2<Field> side = Point2<Field>{wall[2 * next], wall[2 * next + 1]} - a;
    const double slant = cross(ray.along, side);
    if (std::fabs(slant) < 1e-9) continue;  // parallel
    const double ahead = cross(a - ray.from, side) / slant;
    const double share = cross(a - ray.from, ray.along) / slant;
    if (!(ahead > 0.0) || share < 0.0 || share > 1.0) continue;
    if (nearest == 0.0 || ahead < nearest) nearest = ahead;
  }
  if (nearest == 0.0) return std::nullopt;
  return ray.from + ray.along * nearest;
}

bool mayHangOnWall(double eyeHeight, Angle elevation, double distance,
                   const PinkMapParams& params) {
  const double height = eyeHeight + distance * maths::tan(elevation.rad());
  return height >= params.minHeight && height <= params.maxHeight;
}

bool clearOfBeacons(const Ray& ray, const body::LandmarkMap& landmarks, double clearance) {
  for (const body::Landmark& mark : landmarks) {
    if (mark.kind <= LandmarkKind::goalYellow) continue;
    const Point2<Field> way = mark.position - ray.from;
    if (dot(way, ray.along) > 0.0 && std::fabs(cross(ray.along, way)) <= clearance) return false;
  }
  return true;
}

PinkLandmark* glancedAt(const Ray& ray, Point2<Field> place, const PinkMapParams& params,
                        PinkLandmarks& map) {
  for (PinkLandmark& landmark : map) {
    const double away = distance(landmark.position, place);
    if (landmark.weight < params.minWeight || away <= params.mergeRadius) continue;
    const double lateral = std::fabs(cross(ray.along, landmark.position - ray.from));
    if (away <= params.glanceReach && lateral <= params.glanceLateral) return &landmark;
  }
  return nullptr;
}

bool addToMap(Point2<Field> place, double mergeRadius, PinkLandmarks& map) {
  PinkLandmark* nearest = nullptr;
  double min = mergeRadius;
  for (PinkLandmark& landmark : map) {
    const double away = distance(landmark.position, place);
    if (away > min) continue;
    min = away;
    nearest = &landmark;
  }
  if (nearest == nullptr) return map.push_back({place, 1.0});
  nearest->weight += 1.0;
  nearest->position = nearest->position + (place - nearest->position) * (1.0 / nearest->weight);
  return true;
}

void forget(double seconds, const PinkMapParams& params, PinkState& state) {
  state.sinceForgotten += seconds;
  if (state.sinceForgotten < params.forgetSeconds) return;
  state.sinceForgotten = 0.0;
  PinkLandmarks kept;
  for (PinkLandmark landmark : state.map) {
    landmark.weight -= 1.0;
    if (landmark.weight > 0.0) kept.push_back(landmark);
  }
  state.map = kept;
}

void mapPatches(const PinkSightings& seen, const PinkMapParams& params, PinkLandmarks& map,
                GpsCounts& counts) {
  for (const PinkBearing& bearing : seen.bearings) {
    if (const auto reason = refusal(bearing, seen, params)) {
      count(*reason, counts);
      continue;
    }
    const Ray ray = rayOf(seen.pose.modes[0].pose, bearing);
    const auto place = meetWall(ray, params.wall);
    if (PinkLandmark* known = glancedAt(ray, *place, params, map)) {
      known->weight += 1.0;
      continue;
    }
    if (!addToMap(*place, params.mergeRadius, map)) count(Refusal::pinkMapFull, counts);
  }
}

}  // namespace kelpie::gps

// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/EdgeElevation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/body/Camera.h"

namespace kelpie::gps {
namespace {

constexpr double kWidest = 25.0;                    // cm, sd of a mode that tells the distance
constexpr double kMaxHeadingSd = 0.15;              // rad
constexpr double kNearest = 120.0;                  // cm
constexpr double kFarthest = 700.0;                 // cm, beyond any carpet
constexpr double kEdgePlace = 5.0;                  // cm, sd of the carpet's end
constexpr std::array<double, 2> kColumns{52, 156};  // px

// A ray on the field: from where, and its direction.
struct FieldRay {
  Point2<Field> from;
  double x = 0.0;
  double y = 0.0;
};

// The carpet is convex: the ray leaves it at the nearest of the borders that it runs towards.
double wayToEnd(const body::FieldDescription& field, const FieldRay& ray) {
  const body::Carpet carpet = body::carpetOf(field);
  const double b = field.borderWidth;
  const double acrossWay =
      ray.x > 0.0 ? carpet.high.x - b - ray.from.x : ray.from.x - carpet.low.x - b;
  const double alongWay =
      ray.y > 0.0 ? carpet.high.y - b - ray.from.y : ray.from.y - carpet.low.y - b;
  return std::min(acrossWay / std::max(std::fabs(ray.x), 1e-6),
                  alongWay / std::max(std::fabs(ray.y), 1e-6));
}

FieldRay fieldRay(const PoseMode& mode, const Point3<Robot>& eye, double right, double forward) {
  const Pose2 turn{{0.0, 0.0}, mode.pose.heading};
  const Point2<Field> way = fieldFromRobot(turn, {right, forward});
  return {fieldFromRobot(mode.pose, {eye.x, eye.y}), way.x, way.y};
}

bool isNarrow(const PoseMode& mode) {
  return mode.covariance[0] + mode.covariance[4] < maths::square(kWidest) &&
         mode.covariance[8] < maths::square(kMaxHeadingSd);
}

void addEdge(const GpsIn& in, const body::FieldDescription& field, const TiltParams& params,
             const PoseMode& mode, const FieldEdgePercept& edge, TiltSightings& sightings) {
  for (const double column : kColumns) {
    const double row = edge.atLeft + (edge.atRight - edge.atLeft) * column / kImageWidth;
    if (!(row > 0.0 && row < kImageHeight)) continue;
    const Point3<Robot> ray = body::rayThrough(in.camera, {column, row});
    const double level = maths::hypot(ray.x, ray.y);
    if (level < 0.1) continue;
    const double right = ray.x / level;
    const double forward = ray.y / level;
    const double h = in.camera.position.z;
    const double away = wayToEnd(field, fieldRay(mode, in.camera.position, right, forward));
    if (!(away > kNearest && away < kFarthest)) continue;
    const double pixel = std::max(edge.rms, 0.5) / in.camera.lens.focalLength;
    const double place = mode.covariance[0] + mode.covariance[4] + maths::square(kEdgePlace);
    const double variance = pixel * pixel + place * maths::square(h / (away * away)) +
                            maths::square(params.swaySd.rad());
    sightings.push_back(
        {right, forward, -maths::atan(ray.z / level) - maths::atan(h / away), variance});
  }
}

}  // namespace

TiltSightings edgeSightings(const GpsIn& in, const body::FieldDescription& field,
                            const TiltParams& params, const PoseMode& mode) {
  TiltSightings sightings;
  if (!isNarrow(mode)) return sightings;
  for (const FieldEdgePercept& edge : in.percepts.fieldEdges)
    addEdge(in, field, params, mode, edge, sightings);
  return sightings;
}

}  // namespace kelpie::gps

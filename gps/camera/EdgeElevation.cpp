// SPDX-License-Identifier: Apache-2.0
#include "gps/camera/EdgeElevation.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"

namespace kelpie::gps {
namespace {

constexpr double kWidest = 25.0;        // cm, sd of a mode that tells the distance
constexpr double kMaxHeadingSd = 0.15;  // rad
constexpr double kNearest = 120.0;      // cm
constexpr double kFarthest = 700.0;     // cm, beyond any carpet
constexpr double kEdgePlace = 5.0;      // cm, sd of the carpet's end
constexpr double kLeftColumn = 52.0;    // px
constexpr double kRightColumn = 156.0;

// Where a ray leaves the carpet, which is convex: at the nearest of the borders that it runs
// towards.
struct CarpetEnd {
  int border = 0;
  double away = 0.0;  // cm
};

CarpetEnd endAlong(const body::FieldDescription& field, Point2<Field> from, Point2<Field> way) {
  const body::Carpet carpet = body::carpetOf(field);
  const double x = (way.x > 0.0 ? carpet.high.x : carpet.low.x) - from.x;
  const double y = (way.y > 0.0 ? carpet.high.y : carpet.low.y) - from.y;
  const double across = x / (std::fabs(way.x) > 1e-6 ? way.x : 1e-6);
  const double along = y / (std::fabs(way.y) > 1e-6 ? way.y : 1e-6);
  if (across < along) return {way.x > 0.0 ? 0 : 1, across - field.borderWidth / std::fabs(way.x)};
  return {way.y > 0.0 ? 2 : 3, along - field.borderWidth / std::fabs(way.y)};
}

bool isNarrow(const PoseMode& mode) {
  return mode.covariance[0] + mode.covariance[4] < maths::square(kWidest) &&
         mode.covariance[8] < maths::square(kMaxHeadingSd);
}

struct EdgeView {
  const GpsIn& in;
  const body::FieldDescription& field;
  const TiltParams& params;
  const PoseMode& mode;
};

double rowOf(const FieldEdgePercept& edge, double column) {
  return edge.atLeft + (edge.atRight - edge.atLeft) * column / kImageWidth;
}

bool isLowest(const Percepts& seen, const FieldEdgePercept& edge, double column) {
  return std::all_of(seen.fieldEdges.begin(), seen.fieldEdges.end(), [&](const auto& other) {
    return rowOf(other, column) <= rowOf(edge, column);
  });
}

// A border of the carpet in one column of the image.
struct SeenEnd {
  bool usable = false;
  TiltSighting sighting;
  int border = 0;
};

SeenEnd endIn(const EdgeView& view, const FieldEdgePercept& edge, double column) {
  const CameraPose& camera = view.in.camera;
  const PixelPoint pixel{column, rowOf(edge, column)};
  if (!(pixel.y > 0.0 && pixel.y < kImageHeight) || !isLowest(view.in.percepts, edge, column))
    return {};
  const Point3<Robot> ray = body::rayThrough(camera, pixel);
  const double level = maths::hypot(ray.x, ray.y);
  if (level < 0.1) return {};
  const Point2<Robot> way{ray.x / level, ray.y / level};
  const Point2<Robot> eye{camera.position.x, camera.position.y};
  const CarpetEnd end = endAlong(view.field, fieldFromRobot(view.mode.pose, eye),
                                 fieldFromRobot({{0.0, 0.0}, view.mode.pose.heading}, way));
  if (!(end.away > kNearest && end.away < kFarthest)) return {};
  const double h = camera.position.z;
  const double pixelSd = std::max(edge.rms, 0.5) / camera.lens.focalLength;
  const double place =
      view.mode.covariance[0] + view.mode.covariance[4] + maths::square(kEdgePlace);
  const double variance = pixelSd * pixelSd + place * maths::square(h / (end.away * end.away)) +
                          maths::square(view.params.oscillationSd.rad());
  const double excess = -maths::atan(ray.z / level) - maths::atan(h / end.away);
  return {true, {way.x, way.y, excess, variance}, end.border};
}

// Past a corner of the carpet the line of a border runs on above what lies there.
void addEdge(const EdgeView& view, const FieldEdgePercept& edge, TiltSightings& sightings) {
  const SeenEnd left = endIn(view, edge, kLeftColumn);
  const SeenEnd right = endIn(view, edge, kRightColumn);
  if (!left.usable || !right.usable || left.border != right.border) return;
  sightings.push_back(left.sighting);
  sightings.push_back(right.sighting);
}

}  // namespace

TiltSightings edgeSightings(const GpsIn& in, const body::FieldDescription& field,
                            const TiltParams& params, const PoseMode& mode) {
  TiltSightings sightings;
  if (!isNarrow(mode)) return sightings;
  for (const FieldEdgePercept& edge : in.percepts.fieldEdges)
    addEdge({in, field, params, mode}, edge, sightings);
  return sightings;
}

}  // namespace kelpie::gps

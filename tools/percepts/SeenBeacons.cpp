// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "tools/percepts/Eye.h"
#include "tools/percepts/Shown.h"
#include "vision/pixels/GroundRay.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::percepts {
namespace {

constexpr double kEdgeSd = 0.35;      // px of a band's edge, as vision says of it
constexpr double kHeadingSd = 0.7;    // deg, so
constexpr double kOwnVariance = 4.0;  // cm2, so

bool isBeacon(LandmarkKind kind) { return kind > LandmarkKind::goalYellow; }

void add(const Look& look, const body::Landmark& mark, const ShownBands& bands,
         Percepts& percepts) {
  const BeaconErrors& errors = look.noise.beacon;
  const CameraPose& camera = look.view.believed();
  const double along = look.view.distance(mark.position);
  const auto middle =
      look.view.spot({mark.position.x, mark.position.y, 0.75 * look.field.beaconHeight});
  if (!middle) return;
  const double height = (bands.cut ? 0.25 : 0.5) * look.field.beaconHeight;
  const double sd = vision::sizeSd(camera, along, height, errors.edge);
  const PixelPoint pixel{middle->pixel.x + look.random.gaussian(0.0, errors.pixel),
                         middle->pixel.y + look.random.gaussian(0.0, errors.pixel)};
  const double part = bands.share < 1.0 ? errors.partShare * along : 0.0;
  const double seenAlong =
      std::max(10.0, along + look.random.gaussian(0.0, maths::hypot(sd, part)));
  const Point2<Robot> place = readPlace(camera, pixel, seenAlong);
  LandmarkPercept p;
  p.kind = mark.kind;
  p.distance = place.norm();
  p.heading = bearing(place);
  p.elevation = Angle::rad(maths::atan(readSlope(camera, pixel)));
  p.distanceVariance =
      maths::square(vision::sizeSd(camera, seenAlong, height, kEdgeSd)) + kOwnVariance;
  p.headingVariance = maths::square(Angle::deg(kHeadingSd).rad());
  const double pixelAngle = kEdgeSd / camera.lens.focalLength;
  const double share = vision::kRootTwo * (0.75 * look.field.beaconHeight - camera.position.z) /
                       (0.5 * look.field.beaconHeight);
  p.elevationError = elevationErrorAt(look, pixel, 0.75 * look.field.beaconHeight, seenAlong,
                                      pixelAngle * pixelAngle * (1.0 + share * share));
  p.leftEdge = p.rightEdge = p.heading;
  p.box = bands.box;
  p.leftEdgeCut = p.box.left <= vision::kUsableLeft + 1;
  p.rightEdgeCut = p.box.right >= vision::kUsableRight - 1;
  percepts.landmarks.push_back(p);
}

}  // namespace

ShownBands shownBands(const View& view, const body::FieldDescription& field, Point2<Field> foot) {
  constexpr int kHeights = 5;
  ShownBands bands{{1e9, 1e9, -1e9, -1e9}};
  int shown = 0, all = 0;
  for (int i = 0; i < kHeights; ++i) {
    const double z = field.beaconHeight * (0.5 + 0.5 * i / (kHeights - 1));
    const auto spot = view.spot({foot.x, foot.y, z});
    if (!spot) return bands;
    const double half = view.eye().lens.focal * field.beaconRadius / spot->depth;
    for (const double side : {-0.7, 0.7}) {
      const PixelPoint p{spot->pixel.x + side * half, spot->pixel.y};
      bands.box = {std::min(bands.box.left, p.x), std::min(bands.box.top, p.y),
                   std::max(bands.box.right, p.x), std::max(bands.box.bottom, p.y)};
      ++all;
      shown += view.shows({p, spot->depth}) ? 1 : 0;
      bands.cut = bands.cut || !usable(p);
    }
  }
  bands.share = static_cast<double>(shown) / all;
  return bands;
}

void seeBeacons(const Look& look, Percepts& percepts) {
  const BeaconErrors& errors = look.noise.beacon;
  for (const body::Landmark& mark : look.field.landmarks) {
    if (!isBeacon(mark.kind) || look.view.distance(mark.position) > errors.farthest) continue;
    const ShownBands bands = shownBands(look.view, look.field, mark.position);
    if (look.random.chance(recallOf(errors.recall, bands.share))) add(look, mark, bands, percepts);
  }
}

}  // namespace kelpie::percepts

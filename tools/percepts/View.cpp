// SPDX-License-Identifier: Apache-2.0
#include "tools/percepts/View.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/body/Camera.h"
#include "vision/pixels/GroundRay.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::percepts {
namespace {

constexpr double kNearest = 1.0;      // cm before the camera; what is nearer or behind is there
constexpr double kFarthest = 500.0;   // cm; robots farther off hide nothing that matters
constexpr double kWidestView = 0.45;  // of the depth and a body's length, beyond which it is beside

double dot(sim::FieldPoint3 a, sim::FieldPoint3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// A box in the robot frame; heights are over the ground, as shares of the shoulder's and in cm.
struct Part {
  Point2<Robot> low;
  Point2<Robot> high;
  double fromShare = 0.0, fromCm = 0.0;
  double toShare = 0.0, toCm = 0.0;
  bool lowerLeg = false;
};

// As sim's SceneRobot draws them; the legs' upper halves count as trunk.
constexpr std::array<Part, 6> kParts{{{{-7.2, -15.0}, {7.2, 2.5}, 0.45, 0.0, 1.0, 2.5},
                                      {{-3.5, 2.0}, {3.5, 13.0}, 1.0, 5.0, 1.0, 11.0},
                                      {{-7.0, -2.0}, {-4.2, 2.0}, 0.0, 0.0, 0.45, 0.0, true},
                                      {{4.2, -2.0}, {7.0, 2.0}, 0.0, 0.0, 0.45, 0.0, true},
                                      {{-7.0, -15.0}, {-4.2, -11.0}, 0.0, 0.0, 0.45, 0.0, true},
                                      {{4.2, -15.0}, {7.0, -11.0}, 0.0, 0.0, 0.45, 0.0, true}}};

}  // namespace

bool usable(PixelPoint p, double margin) {
  return p.x > vision::kUsableLeft - margin && p.x < vision::kUsableRight + margin &&
         p.y > vision::kUsableTop - margin && p.y < vision::kUsableBottom + margin;
}

Point2<Robot> readPlace(const CameraPose& believed, PixelPoint pixel, double distance) {
  return vision::placeAt(believed, vision::groundRayThrough(believed, pixel), distance);
}

double readSlope(const CameraPose& believed, PixelPoint pixel) {
  return vision::groundRayThrough(believed, pixel).slope;
}

void View::turnTo(const Moment& moment, std::size_t self, const CameraPose& believed) {
  const sim::BodyPlace& place = moment.robots[self];
  pose_ = place.pose;
  eye_ = sim::fieldCamera(place.pose, sim::trueCamera(place));
  believed_ = believed;
  believed_.turn = {};  // every column is exposed at the same time
  blockers_.clear();
  for (std::size_t i = 0; i < moment.robots.size(); ++i)
    if (i != self) addRobot(moment.robots[i], i);
}

std::optional<Spot> View::spot(sim::FieldPoint3 point) const {
  const sim::FieldPoint3 way = point - eye_.position;
  const double depth = dot(eye_.forward, way);
  if (!(depth > kNearest)) return std::nullopt;
  const double scale = eye_.lens.focal / depth;
  return Spot{{eye_.lens.principalX + scale * dot(eye_.right, way),
               eye_.lens.principalY + scale * dot(eye_.down, way)},
              depth};
}

double View::distance(Point2<Field> place) const {
  return std::hypot(place.x - eye_.position.x, place.y - eye_.position.y);
}

void View::addRobot(const sim::BodyPlace& place, std::size_t robot) {
  constexpr double kReach = 25.0;  // cm, of a body from its neck base
  const Point2<Field> at = place.pose.position;
  const sim::FieldPoint3 way = sim::FieldPoint3{at.x, at.y, 0.0} - eye_.position;
  const double ahead = dot(eye_.forward, way);
  const double widest = kReach + (1.0 + kWidestView) * (ahead + kReach);
  if (ahead < -kReach || ahead > kFarthest || std::fabs(dot(eye_.right, way)) > widest) return;
  const maths::SinCos turn = place.pose.heading.sinCos();
  for (const Part& part : kParts) {
    Blocker blocker{{1e9, 1e9, -1e9, -1e9}, 0.0, robot, part.lowerLeg};
    bool before = false;
    for (int corner = 0; corner < 8; ++corner) {
      const double x = (corner & 1) != 0 ? part.high.x : part.low.x;
      const double y = (corner & 2) != 0 ? part.high.y : part.low.y;
      const double h = place.stance.shoulderHeight;
      const double z =
          (corner & 4) != 0 ? part.toShare * h + part.toCm : part.fromShare * h + part.fromCm;
      const double depth = addCorner(
          {way.x + turn.sin * x + turn.cos * y, way.y - turn.cos * x + turn.sin * y, way.z + z},
          blocker.box);
      before = before || depth > kNearest;
      blocker.depth += 0.125 * depth;
    }
    const PixelBox& box = blocker.box;
    const bool inImage =
        box.right > 0.0 && box.left < kImageWidth && box.bottom > 0.0 && box.top < kImageHeight;
    if (before && inImage) blockers_.push_back(blocker);
  }
}

// Widens the box to a corner that lies that way from the camera; the corner's depth.
double View::addCorner(sim::FieldPoint3 way, PixelBox& box) const {
  const double depth = dot(eye_.forward, way);
  const double scale = eye_.lens.focal / std::max(depth, kNearest);
  const double x = eye_.lens.principalX + scale * dot(eye_.right, way);
  const double y = eye_.lens.principalY + scale * dot(eye_.down, way);
  box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x),
         std::max(box.bottom, y)};
  return depth;
}

bool View::hidden(const Spot& spot) const {
  return std::any_of(blockers_.begin(), blockers_.end(), [&spot](const Blocker& b) {
    return b.depth < spot.depth && spot.pixel.x > b.box.left && spot.pixel.x < b.box.right &&
           spot.pixel.y > b.box.top && spot.pixel.y < b.box.bottom;
  });
}

bool View::shows(const Spot& spot) const { return usable(spot.pixel) && !hidden(spot); }

std::optional<Point2<Field>> View::ground(PixelPoint pixel) const {
  const double x = (pixel.x - eye_.lens.principalX) / eye_.lens.focal;
  const double y = (pixel.y - eye_.lens.principalY) / eye_.lens.focal;
  const sim::FieldPoint3 ray{eye_.forward.x + x * eye_.right.x + y * eye_.down.x,
                             eye_.forward.y + x * eye_.right.y + y * eye_.down.y,
                             eye_.forward.z + x * eye_.right.z + y * eye_.down.z};
  constexpr double kFlattest = -1e-3;
  if (ray.z > kFlattest) return std::nullopt;
  const double depth = -eye_.position.z / ray.z;
  return Point2<Field>{eye_.position.x + depth * ray.x, eye_.position.y + depth * ray.y};
}

}  // namespace kelpie::percepts

// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/body/BodySightings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "vision/Scene.h"
#include "vision/Vision.h"
#include "vision/pixels/HorizonFrame.h"

namespace kelpie::calibrate {
namespace {

using FieldPoint = Point2<Field>;

// px, of one measured coordinate. What frames of one stop share is for the fit's groups.
constexpr double kBorderSd = 0.6;
constexpr double kAskew = 1.0;  // bands away from their border, where a beacon's middle is taken
constexpr double kEndSd = 0.8;
constexpr double kPostSd = 2.0;  // made from a fit of the whole goal
constexpr double kLineSd = 1.0;
constexpr double kCarpetSd = 1.5;
constexpr double kLinePointsOwn = 8.0;  // of a frame; more share their information

PixelPoint minus(PixelPoint a, PixelPoint b) { return {a.x - b.x, a.y - b.y}; }
PixelPoint plus(PixelPoint a, PixelPoint b, double times) {
  return {a.x + b.x * times, a.y + b.y * times};
}
double dot(PixelPoint a, PixelPoint b) { return a.x * b.x + a.y * b.y; }
double dot(FieldPoint a, FieldPoint b) { return a.x * b.x + a.y * b.y; }
PixelPoint across(PixelPoint a) { return {-a.y, a.x}; }

std::optional<PixelPoint> unit(PixelPoint a) {
  const double length = std::hypot(a.x, a.y);
  if (length < 1e-9) return std::nullopt;
  return PixelPoint{a.x / length, a.y / length};
}

std::optional<PixelPoint> pixelOf(const CameraPose& camera, const Pose2& robot, FieldPoint place,
                                  double height) {
  const Point2<Robot> p = robotFromField(robot, place);
  return body::project(camera, {p.x, p.y, height});
}

FieldPoint cameraOnField(const CameraPose& camera, const Pose2& robot) {
  return fieldFromRobot(robot, {camera.position.x, camera.position.y});
}

// The place moved towards the camera.
FieldPoint frontOf(FieldPoint place, double radius, FieldPoint camera) {
  const double away = distance(place, camera);
  return away < 1.0 ? place : place + (camera - place) * (radius / away);
}

// A line on the ground, for association.
struct GroundLine {
  FieldPoint nearest;
  FieldPoint along;
  double away = 1e9;  // cm
};

GroundLine toSegment(const body::FieldLine& line, FieldPoint p) {
  const FieldPoint way = line.end - line.start;
  const double length = way.norm();
  const FieldPoint along = way * (1.0 / length);
  const double at = maths::clamp(dot(p - line.start, along), 0.0, length);
  const FieldPoint nearest = line.start + along * at;
  return {nearest, along, distance(nearest, p)};
}

GroundLine toCircle(const body::FieldDescription& field, FieldPoint p) {
  const FieldPoint centre{0.5 * field.width, 0.5 * field.length};
  const FieldPoint out = p - centre;
  const double away = std::max(out.norm(), 1e-6);
  const double radius = 0.5 * (field.circleDiameter - field.lineWidth);
  const FieldPoint radial = out * (1.0 / away);
  return {centre + radial * radius, {-radial.y, radial.x}, std::fabs(away - radius)};
}

GroundLine nearestPainted(const body::FieldDescription& field, FieldPoint p) {
  GroundLine best = field.circleDiameter > 0.0 ? toCircle(field, p) : GroundLine{};
  for (const body::FieldLine& line : field.lines) {
    const GroundLine here = toSegment(line, p);
    if (here.away < best.away) best = here;
  }
  return best;
}

// Its lines go round counter-clockwise, so that across() of one leads outwards in the image.
GroundLine nearestCarpetEnd(const body::FieldDescription& field, FieldPoint p) {
  const body::Carpet carpet = body::carpetOf(field);
  const FieldPoint a = carpet.low;
  const FieldPoint c = carpet.high;
  const FieldPoint b{c.x, a.y};
  const FieldPoint d{a.x, c.y};
  GroundLine best;
  for (const body::FieldLine& line : {body::FieldLine{a, b}, {b, c}, {c, d}, {d, a}}) {
    const GroundLine here = toSegment(line, p);
    if (here.away < best.away) best = here;
  }
  return best;
}

Unknown spreadOf(SightKind kind) { return kind == SightKind::carpetEnd ? kCarpetSpread : kSpread; }

bool inside(PixelPoint p, double margin) {
  return p.x > margin && p.x < kImageWidth - margin && p.y > margin && p.y < kImageHeight - margin;
}

// Collects the sightings of one frame.
class Collector {
 public:
  Collector(const StandingLog& log, const Seen& seen, const Numbers& values, std::size_t frame,
            const CameraPose& camera, double gate, Sightings& out)
      : field_(log.config->field),
        landmarks_(body::landmarksFor(field_, log.config->team)),
        percepts_(seen.percepts[frame]),
        seenWith_(seen.cameras[frame]),
        camera_(camera),
        values_(values),
        robot_(placeOf(values)),
        frame_(frame),
        gate_(gate),
        out_(out) {}

  void landmarks() {
    for (const LandmarkPercept& percept : percepts_.landmarks) {
      const body::Landmark* known = body::findLandmark(landmarks_, percept.kind);
      if (known == nullptr) continue;
      const bool goal =
          percept.kind == LandmarkKind::goalBlue || percept.kind == LandmarkKind::goalYellow;
      if (goal)
        posts(percept, known->position);
      else
        beacon(percept, known->position);
    }
  }

  void linePoints() {
    double count = 0.0;
    for (const LinePoint& point : percepts_.linePoints)
      count += point.kind == LinePointKind::line ? 1.0 : 0.0;
    const double sd = kLineSd * std::sqrt(std::max(1.0, count / kLinePointsOwn));
    for (const LinePoint& point : percepts_.linePoints)
      if (point.kind == LinePointKind::line)
        onLine(SightKind::linePoint, point.pixel, sd, nearestPainted);
  }

  void carpetEnds() {
    if (field_.borderWidth > 0.0) return;  // a white border stands there
    for (const FieldEdgePercept& edge : percepts_.fieldEdges)
      for (const double x : {30.0, 104.0, 178.0})
        onLine(SightKind::carpetEnd, {x, vision::edgeRow(edge, x)}, kCarpetSd, nearestCarpetEnd);
  }

 private:
  // The pixel where vision saw the border between a beacon's bands.
  std::optional<PixelPoint> borderPixel(const LandmarkPercept& percept) const {
    const Point2<Robot> place = robotPolar(percept.distance, percept.heading);
    const Point2<Robot> eye{seenWith_.position.x, seenWith_.position.y};
    const double slope = maths::tan(percept.elevation.rad());
    return body::project(seenWith_,
                         {place.x, place.y, seenWith_.position.z + slope * distance(place, eye)});
  }

  void point(SightKind kind, PixelPoint pixel, PixelPoint normal, FieldPoint place, double height,
             double radius, double outwards, double sd) {
    Sighting sighting;
    sighting.kind = kind;
    sighting.frame = frame_;
    sighting.pixel = pixel;
    sighting.normal = normal;
    sighting.place = place;
    sighting.height = height;
    sighting.radius = radius;
    sighting.outwards = outwards;
    sighting.sd = sd;
    if (std::fabs(missOf(sighting, camera_, values_).size) < gate_) out_.push_back(sighting);
  }

  std::optional<PixelPoint> upAt(FieldPoint place, double height) const {
    const auto low = pixelOf(camera_, robot_, place, height - 5.0);
    const auto high = pixelOf(camera_, robot_, place, height + 5.0);
    if (!low || !high) return std::nullopt;
    return unit(minus(*high, *low));
  }

  // Sine of the angle between what is upright at a place and what vision takes for it, which is the
  // upright of the image's middle. It takes a beacon's middle at one of its bands, then goes along
  // that to the border.
  double leaning(PixelPoint up) const {
    const vision::HorizonFrame frame = vision::horizonFrameOf(seenWith_);
    return up.x * frame.up().dy - up.y * frame.up().dx;
  }

  void beacon(const LandmarkPercept& percept, FieldPoint place) {
    const double band = 0.25 * field_.beaconHeight;
    const double radius = field_.beaconRadius;
    const auto border = borderPixel(percept);
    const auto up = upAt(place, 3.0 * band);
    if (!border || !up || !inside(*border, 6.0)) return;
    point(SightKind::bandBorder, *border, *up, place, 3.0 * band, radius, 0.0, kBorderSd);
    const double askew = 0.5 * (percept.box.bottom - percept.box.top) * leaning(*up);
    if (!percept.leftEdgeCut && !percept.rightEdgeCut)
      point(SightKind::bandBorder, *border, across(*up), place, 3.0 * band, radius, 0.0,
            std::hypot(kBorderSd, kAskew * askew));
    if (up->y > -0.7) return;  // its box does not tell where it ends
    for (const bool top : {true, false}) {
      const double row = top ? percept.box.top : percept.box.bottom;
      if (row < 7.0 || row > kImageHeight - 7.0) continue;
      const PixelPoint end = plus(*border, *up, (row - border->y) / up->y);
      point(SightKind::beaconEnd, end, *up, place, (top ? 4.0 : 2.0) * band, radius,
            top ? 1.0 : -1.0, kEndSd);
    }
  }

  // A post's direction as a pixel at half its height.
  void posts(const LandmarkPercept& percept, FieldPoint middle) {
    const FieldPoint half{0.5 * field_.goalWidth, 0.0};
    for (const FieldPoint place : {middle - half, middle + half}) {
      const FieldPoint other = middle + (middle - place);
      const Angle here = bearing(robotFromField(robot_, place));
      const bool left = (here - bearing(robotFromField(robot_, other))).rad() > 0.0;
      if (left ? percept.leftEdgeCut : percept.rightEdgeCut) continue;
      const double away = distance(place, robot_.position);
      const Point2<Robot> seen = robotPolar(away, left ? percept.leftEdge : percept.rightEdge);
      const double height = 0.5 * field_.goalHeight;
      const auto pixel = body::project(seenWith_, {seen.x, seen.y, height});
      const auto up = upAt(place, height);
      if (!pixel || !up || !inside(*pixel, 6.0)) continue;
      point(SightKind::goalPost, *pixel, across(*up), place, height, 0.0, 0.0, kPostSd);
    }
  }

  template <class Nearest>
  void onLine(SightKind kind, PixelPoint pixel, double sd, Nearest&& nearest) {
    if (!inside(pixel, 6.0)) return;
    const auto ground = body::groundPoint(camera_, pixel);
    if (!ground) return;
    const GroundLine line = nearest(field_, fieldFromRobot(robot_, *ground));
    Sighting sighting;
    sighting.kind = kind;
    sighting.frame = frame_;
    sighting.pixel = pixel;
    sighting.place = line.nearest;
    sighting.along = line.along;
    sighting.outwards = kind == SightKind::carpetEnd ? 1.0 : 0.0;
    sighting.sd = sd;
    if (std::fabs(missOf(sighting, camera_, values_).size) < gate_) out_.push_back(sighting);
  }

  const body::FieldDescription& field_;
  body::LandmarkMap landmarks_;
  const Percepts& percepts_;
  const CameraPose& seenWith_;
  const CameraPose& camera_;
  const Numbers& values_;
  Pose2 robot_;
  std::size_t frame_;
  double gate_;
  Sightings& out_;
};

}  // namespace

const char* nameOf(SightKind kind) {
  constexpr std::array<const char*, kSightKindCount> kNames = {
      "borders of bands", "ends of beacons", "goal posts", "line points", "ends of the carpet"};
  return kNames[static_cast<std::size_t>(kind)];
}

Seen look(const StandingLog& log, const Numbers& values, std::size_t every) {
  Seen seen;
  const body::BodyParams params = paramsWith(log.config->body, values);
  const std::vector<double> slack = panSlack(log.pans, values[kPanPlay]);
  const auto state = std::make_unique<vision::VisionState>(log.config->calibration);
  const auto input = std::make_unique<FrameInput>();
  vision::VisionParams vision = log.config->vision;
  vision.field = log.config->field;
  for (std::size_t i = 0; i < log.frames.size(); i += every) {
    *input = log.frames[i].input;
    input->cameraTilt = CameraTilt{};  // what the robot believed of it then is not asked
    Angle& pan = input->sensors.joints[Joint::headPan];
    pan = pan + Angle::rad(slack[log.frames[i].pan]);
    const BodyState body = body::step(*input, params);
    seen.percepts.push_back(vision::step({*input, body}, vision, *state));
    seen.cameras.push_back(body.camera);
  }
  return seen;
}

Sightings sightings(const StandingLog& log, const Seen& seen, const BodyModel& model,
                    const Numbers& values, const Gathering& gathering) {
  Sightings found;
  const std::vector<CameraPose> cameras = model.cameras(values);
  for (std::size_t i = 0; i < seen.percepts.size(); ++i) {
    Collector collector(log, seen, values, i, cameras[i], gathering.gate, found);
    collector.landmarks();
    if (!gathering.lines) continue;
    collector.linePoints();
    collector.carpetEnds();
  }
  return found;
}

Miss missOf(const Sighting& s, const CameraPose& camera, const Numbers& values) {
  const Pose2 robot = placeOf(values);
  const FieldPoint place =
      s.radius > 0.0 ? frontOf(s.place, s.radius, cameraOnField(camera, robot)) : s.place;
  const auto pixel = pixelOf(camera, robot, place, s.height);
  if (!pixel) return {kLost, {}};
  PixelPoint normal = s.normal;
  if (s.along.x != 0.0 || s.along.y != 0.0) {
    const auto beside = pixelOf(camera, robot, place + s.along * 2.0, s.height);
    const auto way = beside ? unit(minus(*beside, *pixel)) : std::nullopt;
    if (!way) return {kLost, {}};
    normal = across(*way);
  }
  const double spread = s.outwards * values[spreadOf(s.kind)];
  return {dot(minus(s.pixel, *pixel), normal) - spread, normal};
}

}  // namespace kelpie::calibrate

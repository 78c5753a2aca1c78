// SPDX-License-Identifier: Apache-2.0
// Line points lie where vision's grid crosses the painted lines, field points deep in the green,
// and the carpet ends at the field edges.
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/body/Camera.h"
#include "tools/percepts/Eye.h"
#include "vision/line/BrightSegments.h"
#include "vision/line/LinePointParams.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::percepts {
namespace {

// A straight piece of the ground as the image has it.
struct Stretch {
  Spot from;
  Spot to;
};

// What of it lies before the camera.
std::optional<Stretch> stretchOf(const View& view, Point2<Field> a, Point2<Field> b) {
  constexpr double kNear = 2.0;  // cm before the camera
  const auto depthOf = [&view](Point2<Field> p) {
    const sim::FieldPoint3 way = sim::FieldPoint3{p.x, p.y, 0.0} - view.eye().position;
    const sim::FieldPoint3& f = view.eye().forward;
    return f.x * way.x + f.y * way.y + f.z * way.z;
  };
  const double da = depthOf(a), db = depthOf(b);
  if (da < kNear && db < kNear) return std::nullopt;
  if (da < kNear) a = a + (b - a) * ((kNear - da) / (db - da));
  if (db < kNear) b = b + (a - b) * ((kNear - db) / (da - db));
  const auto from = view.spot({a.x, a.y, 0.0}), to = view.spot({b.x, b.y, 0.0});
  if (!from || !to) return std::nullopt;
  return Stretch{*from, *to};
}

// Inverse depths go evenly along a straight line of the image.
Spot spotAt(const Stretch& s, double share) {
  const double inverse = (1.0 - share) / s.from.depth + share / s.to.depth;
  return {{s.from.pixel.x + share * (s.to.pixel.x - s.from.pixel.x),
           s.from.pixel.y + share * (s.to.pixel.y - s.from.pixel.y)},
          1.0 / inverse};
}

bool besideObjects(const Percepts& seen, PixelPoint p, double margin) {
  const BallPercept& ball = seen.ball;
  if (ball.present && std::fabs(p.x - ball.centre.x) < ball.radius + margin &&
      std::fabs(p.y - ball.centre.y) < ball.radius + margin)
    return true;
  return std::any_of(seen.robots.begin(), seen.robots.end(), [&](const RobotPercept& r) {
    return p.x > r.box.left - margin && p.x < r.box.right + margin && p.y > r.box.top - margin &&
           p.y < r.box.bottom + margin;
  });
}

bool inCorner(PixelPoint p, double buffer) {
  return std::min(p.x, kImageWidth - p.x) + std::min(p.y, kImageHeight - p.y) < buffer;
}

double recallAt(const LineErrors& errors, double depth) {
  return errors.recall *
         maths::clamp((errors.farthest - depth) / (errors.farthest - errors.near), 0.0, 1.0);
}

class Finder {
 public:
  Finder(const Look& look, Percepts& percepts) : look_(look), out_(percepts) {}

  void addLine(Point2<Field> a, Point2<Field> b) {
    const auto stretch = stretchOf(look_.view, a, b);
    if (!stretch) return;
    crossings(*stretch, true);
    crossings(*stretch, false);
  }
  void addField() {
    for (double x = vision::kGridLeft + 0.5; x < vision::kUsableRight;
         x += vision::kFieldGridSpacing)
      fieldColumn(x);
  }

 private:
  // With the columns or the rows of vision's grid.
  void crossings(const Stretch& s, bool columns) {
    const double from = columns ? s.from.pixel.x : s.from.pixel.y;
    const double to = columns ? s.to.pixel.x : s.to.pixel.y;
    const double first = columns ? vision::kGridLeft : vision::kGridTop;
    const double end = columns ? vision::kUsableRight : vision::kUsableBottom;
    const double low = std::max(first, std::min(from, to)),
                 high = std::min(end, std::max(from, to));
    if (!(high > low)) return;
    double at = first + vision::kGridSpacing * std::ceil((low - first) / vision::kGridSpacing);
    for (; at < high; at += vision::kGridSpacing) addCrossing(spotAt(s, (at - from) / (to - from)));
  }
  void addCrossing(const Spot& spot) {
    if (!look_.view.shows(spot) || !look_.random.chance(recallAt(look_.noise.line, spot.depth)))
      return;
    const double sd = look_.noise.line.pixel;
    add(LinePointKind::line, {spot.pixel.x + look_.random.gaussian(0.0, sd),
                              spot.pixel.y + look_.random.gaussian(0.0, sd)});
  }
  void add(LinePointKind kind, PixelPoint pixel) {
    if (inCorner(pixel, params_.cornerBuffer) || besideObjects(out_, pixel, params_.objectMargin))
      return;
    const auto place = body::groundPoint(look_.view.believed(), pixel);
    if (!place) return;
    const double away = place->norm();
    if (away > params_.noWeight) return;
    const double weight =
        kind == LinePointKind::field
            ? 1.0
            : maths::clamp((params_.noWeight - away) / (params_.noWeight - params_.fullWeight), 0.0,
                           1.0);
    out_.linePoints.push_back({kind, *place, weight, pixel});
  }
  void fieldColumn(double x) {
    const CameraPose& camera = look_.view.believed();
    const double share = x / kImageWidth;
    const Horizon& h = look_.body.horizon;
    const double horizon = h.atLeft + share * (h.atRight - h.atLeft);
    double lowest = vision::kUsableBottom;
    while (lowest > vision::kUsableTop) {
      const double rows = lowest - horizon;
      if (rows < params_.minFieldInterval) return;
      const double interval = maths::clamp(
          params_.fieldSpacing * rows * rows / (camera.position.z * camera.lens.focalLength),
          params_.minFieldInterval, params_.maxFieldInterval);
      addFieldPoint({x, lowest - 0.5 * interval});
      lowest -= interval;
    }
  }
  void addFieldPoint(PixelPoint pixel) {
    const auto place = look_.view.ground(pixel);
    if (!place || !look_.random.chance(look_.noise.line.fieldRecall) || !isGreen(*place)) return;
    const double depth = look_.view.distance(*place);
    const double beside = params_.fieldSide;
    for (const double side : {-beside, 0.0, beside})
      if (look_.view.hidden({{pixel.x + side, pixel.y}, depth})) return;
    const double reach = beside * depth / look_.view.eye().lens.focal;
    if (!nearLine(*place, reach)) add(LinePointKind::field, pixel);
  }
  bool isGreen(Point2<Field> p) const {
    return distance(p, body::carpetOf(look_.field).nearest(p)) <= 0.0;
  }
  bool nearLine(Point2<Field> p, double reach) const {
    for (const body::FieldLine& line : look_.field.lines) {
      const bool beside = p.x > std::min(line.start.x, line.end.x) - reach &&
                          p.x < std::max(line.start.x, line.end.x) + reach &&
                          p.y > std::min(line.start.y, line.end.y) - reach &&
                          p.y < std::max(line.start.y, line.end.y) + reach;
      if (beside) return true;
    }
    return false;
  }

  const Look& look_;
  Percepts& out_;
  vision::LinePointParams params_;
};

// A few of a kind are dropped, as vision drops them.
void dropFew(LinePointKind kind, double min, Percepts& percepts) {
  auto& points = percepts.linePoints;
  const auto isKind = [kind](const LinePoint& p) { return p.kind == kind; };
  const auto count = std::count_if(points.begin(), points.end(), isKind);
  if (static_cast<double>(count) >= min) return;
  const auto* end = std::remove_if(points.begin(), points.end(), isKind);
  points.resize(static_cast<std::size_t>(end - points.begin()));
}

void addEdge(const Look& look, Point2<Field> a, Point2<Field> b, Percepts& percepts) {
  constexpr double kMinWidth = 40.0;  // px of it in the image
  const auto s = stretchOf(look.view, a, b);
  if (!s || std::fabs(s->to.pixel.x - s->from.pixel.x) < kMinWidth) return;
  const double slope = (s->to.pixel.y - s->from.pixel.y) / (s->to.pixel.x - s->from.pixel.x);
  double shown = 0.0;
  constexpr double kScanLine = 8.0;  // px
  const double low = std::max(4.0, std::min(s->from.pixel.x, s->to.pixel.x));
  const double high = std::min(kImageWidth - 4.0, std::max(s->from.pixel.x, s->to.pixel.x));
  for (double x = low; x < high; x += kScanLine)
    shown += look.view.shows(spotAt(*s, (x - s->from.pixel.x) / (s->to.pixel.x - s->from.pixel.x)))
                 ? 1.0
                 : 0.0;
  if (shown * kScanLine < kMinWidth) return;
  const double sd = look.noise.edgeRms / std::sqrt(shown);
  const double at = s->from.pixel.y - slope * s->from.pixel.x;
  FieldEdgePercept edge;
  edge.atLeft = at + look.random.gaussian(0.0, sd);
  edge.atRight = at + slope * kImageWidth + look.random.gaussian(0.0, sd);
  edge.support = shown;
  edge.rms = look.noise.edgeRms;
  percepts.fieldEdges.push_back(edge);
}

}  // namespace

void seeFieldEdges(const Look& look, Percepts& percepts) {
  const body::Carpet carpet = body::carpetOf(look.field);
  const std::array<Point2<Field>, 5> corners{{carpet.low,
                                              {carpet.high.x, carpet.low.y},
                                              carpet.high,
                                              {carpet.low.x, carpet.high.y},
                                              carpet.low}};
  for (std::size_t i = 0; i < 4; ++i) addEdge(look, corners[i], corners[i + 1], percepts);
}

void seeLines(const Look& look, Percepts& percepts) {
  const vision::LinePointParams params;
  if (look.body.headSpeed >= params.maxHeadSpeed.rad()) return;
  Finder finder(look, percepts);
  for (const body::FieldLine& line : look.field.lines) finder.addLine(line.start, line.end);
  constexpr int kSides = 12;  // of the circle
  const double radius = 0.5 * (look.field.circleDiameter - look.field.lineWidth);
  const Point2<Field> middle{0.5 * look.field.width, 0.5 * look.field.length};
  const auto rim = [&](int i) {
    const Angle turn = Angle::deg(360.0 * i / kSides);
    return middle + Point2<Field>{radius * turn.cos(), radius * turn.sin()};
  };
  for (int i = 0; i < kSides; ++i) finder.addLine(rim(i), rim(i + 1));
  finder.addField();
  for (const LinePointKind kind : {LinePointKind::line, LinePointKind::field})
    dropFew(kind, params.minOfKind, percepts);
}

}  // namespace kelpie::percepts

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tools/experiments/views/Objects.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::experiments {
namespace {

constexpr double kBallShare = 0.5;    // of its disc must show
constexpr double kBeaconShare = 0.7;  // of its two bands
constexpr double kGoalShare = 0.5;    // of the whole, and of what would show without robots
constexpr double kRobotShare = 0.6;   // of what would show without anything before it
constexpr double kMouthInside = 0.6;  // of a goal's width must be between the image's borders
constexpr double kFlattestView = 60;  // deg from the goal's normal
constexpr double kMarginPx = 40.0;    // around the image, for `inView`

bool inUsable(const std::optional<PixelPoint>& p, double margin = 0.0) {
  return p && p->x > vision::kUsableLeft - margin && p->x < vision::kUsableRight + margin &&
         p->y > vision::kUsableTop - margin && p->y < vision::kUsableBottom + margin;
}

std::optional<PixelPoint> pixelOf(const View& view, Point2<Field> p, double height) {
  return sim::pixelIn(view.eye, {p.x, p.y, height});
}

TrueObject placed(const View& view, ObjectKind kind, Point2<Field> p) {
  TrueObject object;
  object.kind = kind;
  const Point2<Robot> q = robotFromField(view.pose, p);
  object.distance = q.norm();
  object.heading = bearing(q);
  return object;
}

bool isCut(const PixelBox& box) {
  return box.left <= vision::kUsableLeft || box.right >= vision::kUsableRight ||
         box.top <= vision::kUsableTop || box.bottom >= vision::kUsableBottom;
}

void keepShown(TrueObject& object, const Shown& shown, int alone) {
  object.pixels = shown.pixels;
  object.pixelsAlone = alone;
  object.cut = shown.pixels > 0 && isCut(shown.box);
}

// Pixels that a centimetre fills at a place.
double scaleAt(const View& view, Point2<Field> p) {
  const double range = maths::hypot(p.x - view.eye.position.x, p.y - view.eye.position.y);
  return view.eye.lens.focal / std::max(range, 5.0);
}

// Pixels that a flat thing of `width` by `height` cm would show, seen from the front.
double areaPx(const View& view, Point2<Field> p, double width, double height) {
  return width * height * maths::square(scaleAt(view, p));
}

TrueObject ballOf(const View& view, Visibility& visibility) {
  TrueObject object = placed(view, ObjectKind::ball, view.ball);
  const auto pixel = pixelOf(view, view.ball, body::kBallRadius);
  object.inView = inUsable(pixel, kMarginPx + body::kBallRadius * scaleAt(view, view.ball));
  if (!object.inView) return object;
  const double r = body::kBallRadius;
  const double area = areaPx(view, view.ball, r * maths::kPi, r);
  keepShown(object, visibility.ball(view), visibility.ballAlone(view).pixels);
  object.toSee = object.pixels >= kBallShare * area;
  return object;
}

TrueObject beaconOf(const View& view, const body::FieldDescription& field,
                    const body::Landmark& mark, std::size_t index, Visibility& visibility) {
  TrueObject object = placed(view, ObjectKind::beacon, mark.position);
  object.landmark = mark.kind;
  const double margin = kMarginPx + field.beaconRadius * scaleAt(view, mark.position);
  object.inView = inUsable(pixelOf(view, mark.position, 0.75 * field.beaconHeight), margin) ||
                  inUsable(pixelOf(view, mark.position, 0.25 * field.beaconHeight), margin);
  if (!object.inView) return object;
  const double area =
      areaPx(view, mark.position, 2.0 * field.beaconRadius, 0.5 * field.beaconHeight);
  keepShown(object, visibility.beacon(view, index), visibility.beaconAlone(view, index).pixels);
  object.toSee = object.pixels >= kBeaconShare * area;
  return object;
}

// Share of the mouth, left to right, that is between the image's borders.
double mouthInside(const View& view, const body::FieldDescription& field, Point2<Field> middle) {
  int inside = 0;
  constexpr int kParts = 20;
  for (int i = 0; i <= kParts; ++i) {
    const double x = middle.x + field.goalWidth * (static_cast<double>(i) / kParts - 0.5);
    const auto foot = pixelOf(view, {x, middle.y}, 0.0);
    const bool here = foot && foot->x > vision::kUsableLeft && foot->x < vision::kUsableRight &&
                      foot->y > vision::kUsableTop && foot->y < vision::kUsableBottom - 2.0;
    inside += here ? 1 : 0;
  }
  return inside / (kParts + 1.0);
}

TrueObject goalOf(const View& view, const body::FieldDescription& field, const body::Landmark& mark,
                  std::size_t index, Visibility& visibility) {
  TrueObject object = placed(view, ObjectKind::goal, mark.position);
  object.landmark = mark.kind;
  const double outwards = mark.position.y > field.length / 2 ? 1.0 : -1.0;
  const Point2<Field> way = mark.position - view.pose.position;
  const double obliquity = maths::atan2(std::fabs(way.x), outwards * way.y);
  const Shown shown = visibility.goal(view, index);
  object.inView = shown.pixels > 0;
  if (!object.inView) return object;
  const int alone = visibility.goalAlone(view, index).pixels;
  keepShown(object, shown, alone);
  const double whole =
      areaPx(view, mark.position, field.goalWidth * Angle::rad(obliquity).cos(), field.goalHeight);
  object.toSee = Angle::rad(obliquity).deg() <= kFlattestView &&
                 mouthInside(view, field, mark.position) >= kMouthInside &&
                 object.pixels >= kGoalShare * whole && object.pixels >= kGoalShare * alone;
  return object;
}

TrueObject robotOf(const View& view, std::size_t index, Visibility& visibility) {
  const auto& look = view.robots[index];
  const Point2<Field> middle = fieldFromRobot(look.pose, {0.0, -4.0});
  TrueObject object = placed(view, ObjectKind::robot, middle);
  object.team = look.team;
  object.inView = inUsable(pixelOf(view, middle, 8.0), 2.0 * kMarginPx);
  if (!object.inView) return object;
  const Shown alone = visibility.robotAlone(view, index);
  keepShown(object, visibility.robot(view, index), alone.pixels);
  object.toSee =
      alone.pixels > 20 && !isCut(alone.box) && object.pixels >= kRobotShare * alone.pixels;
  return object;
}

bool isGoal(LandmarkKind kind) { return kind <= LandmarkKind::goalYellow; }

struct Interval {
  double low;
  double high;
};

// Where a robot hides the mouth's line, as an interval of field x; nothing when it is behind it.
std::optional<Interval> hidden(const View& view, const sim::Solid& robot, double mouthY) {
  const Point2<Field> eye{view.eye.position.x, view.eye.position.y};
  Interval interval{1e9, -1e9};
  for (const auto& quad : robot.quads)
    for (const auto& corner : quad.corner) {
      const double share = (mouthY - eye.y) / (corner.y - eye.y);
      if (!(share > 0.0)) return std::nullopt;
      const double x = eye.x + share * (corner.x - eye.x);
      interval = {std::min(interval.low, x), std::max(interval.high, x)};
    }
  return interval;
}

}  // namespace

std::vector<TrueObject> trueObjects(const View& view, const body::FieldDescription& field,
                                    Visibility& visibility) {
  std::vector<TrueObject> objects;
  if (!view.scene.balls.empty()) objects.push_back(ballOf(view, visibility));
  std::size_t goals = 0;
  std::size_t beacons = 0;
  for (const auto& mark : field.landmarks)
    objects.push_back(isGoal(mark.kind) ? goalOf(view, field, mark, goals++, visibility)
                                        : beaconOf(view, field, mark, beacons++, visibility));
  for (std::size_t i = 0; i < view.robots.size(); ++i)
    objects.push_back(robotOf(view, i, visibility));
  return objects;
}

std::vector<TrueGap> trueGaps(const View& view, const body::FieldDescription& field,
                              LandmarkKind goal) {
  const auto mark = std::find_if(field.landmarks.begin(), field.landmarks.end(),
                                 [goal](const auto& l) { return l.kind == goal; });
  const Point2<Field> middle = mark->position;
  std::vector<Interval> blocked;
  for (const auto& robot : view.scene.robots)
    if (const auto interval = hidden(view, robot, middle.y)) blocked.push_back(*interval);
  std::sort(blocked.begin(), blocked.end(), [](auto& a, auto& b) { return a.low < b.low; });
  std::vector<Interval> free;
  double from = middle.x - field.goalWidth / 2;
  const double end = middle.x + field.goalWidth / 2;
  for (const auto& interval : blocked) {
    if (interval.low > from) free.push_back({from, std::min(interval.low, end)});
    from = std::max(from, interval.high);
    if (from >= end) break;
  }
  if (from < end) free.push_back({from, end});

  std::vector<TrueGap> gaps;
  for (const auto& interval : free) {
    const auto endAt = [&](double x) { return robotFromField(view.pose, {x, middle.y}); };
    const auto seen = [&](double x) { return inUsable(pixelOf(view, {x, middle.y}, 10.0), -2.0); };
    TrueGap gap{goal, bearing(endAt(interval.low)), bearing(endAt(interval.high)),
                seen(interval.low), seen(interval.high)};
    if ((gap.left - gap.right).rad() < 0.0) {
      std::swap(gap.left, gap.right);
      std::swap(gap.leftInImage, gap.rightInImage);
    }
    gaps.push_back(gap);
  }
  return gaps;
}

}  // namespace kelpie::experiments

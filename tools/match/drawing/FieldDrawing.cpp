// SPDX-License-Identifier: Apache-2.0
#include "tools/match/drawing/FieldDrawing.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/match/drawing/Inks.h"

namespace kelpie::match {
namespace {

using namespace picture;

constexpr double kAside = 42.0;          // cm beside the side lines
constexpr double kBeyond = 40.0;         // beyond the goal lines
constexpr double kFastestRobot = 120.0;  // cm/s
constexpr double kFastestBall = 500.0;
constexpr double kJitter = 15.0;   // cm
constexpr int kShades = 24;        // of a path that fades
constexpr double kWeakest = 0.22;  // of them

bool isBreak(const TimedPoint& a, const TimedPoint& b, double fastest) {
  return distance(a.place, b.place) > kJitter + fastest * (b.seconds - a.seconds);
}

}  // namespace

double timeBetweenMarks(double seconds, int most) {
  constexpr std::array<double, 9> kTimes = {1, 2, 5, 10, 20, 30, 60, 120, 300};
  for (const double time : kTimes)
    if (seconds / time <= most) return time;
  return 600.0;
}

TimedPath timeMarks(const TimedPath& path, double every) {
  TimedPath marks;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double mark = every * std::floor(path[i].seconds / every);
    if (mark <= path[i - 1].seconds || mark <= 0.0) continue;
    marks.push_back({mark, path[i].place});
  }
  return marks;
}

std::vector<TimedPath> unbroken(const TimedPath& path, double fastest) {
  std::vector<TimedPath> pieces;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i == 0 || isBreak(path[i - 1], path[i], fastest)) pieces.emplace_back();
    pieces.back().push_back(path[i]);
  }
  return pieces;
}

std::vector<Spot> besideEach(const std::vector<Spot>& spots, double away) {
  constexpr int kWays = 12;
  std::vector<Spot> chosen;
  for (const Spot& spot : spots) {
    const auto clearance = [&](const Spot& at) {
      double nearest = 1e9;
      for (const auto& list : {spots, chosen})
        for (const Spot& other : list)
          nearest = std::min(nearest, std::hypot(at.x - other.x, at.y - other.y));
      return nearest;
    };
    Spot best{spot.x + away, spot.y};
    for (int way = 1; way < kWays; ++way) {
      const double turn = 2.0 * maths::kPi * way / kWays;
      const Spot at{spot.x + away * std::cos(turn), spot.y - away * std::sin(turn)};
      if (clearance(at) > clearance(best) + 0.5) best = at;
    }
    chosen.push_back(best);
  }
  return chosen;
}

FieldDrawing::FieldDrawing(const body::FieldDescription& field, TeamColour team, double left,
                           double top, double width)
    : field_(field),
      team_(team),
      frame_{left, top, width, 0.0},
      scale_(width / (field.width + 2 * kAside)) {
  frame_.height = (field.length + 2 * kBeyond) * scale_;
}

Spot FieldDrawing::spot(Point2<Field> place) const {
  return {frame_.x + (place.x + kAside) * scale_,
          frame_.y + (field_.length + kBeyond - place.y) * scale_};
}

void FieldDrawing::goal(Canvas& canvas, bool own) const {
  const double middle = 0.5 * field_.width;
  const double line = own ? 0.0 : field_.length + field_.goalDepth;
  const Spot corner = spot({middle - 0.5 * field_.goalWidth, line});
  const bool yellow = own == (team_ == TeamColour::red);
  canvas.box({corner.x, corner.y, pixels(field_.goalWidth), pixels(field_.goalDepth)},
             yellow ? inks::kYellowGoal : inks::kBlueGoal, 2.0);
}

void FieldDrawing::ground(Canvas& canvas) const {
  canvas.box(frame_, inks::kCarpet, 10.0);
  goal(canvas, true);
  goal(canvas, false);
  const double width = std::max(1.5, pixels(field_.lineWidth));
  for (const auto& line : field_.lines)
    canvas.line({spot(line.start), spot(line.end)}, inks::kPaint, width);
  canvas.ring(spot({0.5 * field_.width, 0.5 * field_.length}), pixels(0.5 * field_.circleDiameter),
              inks::kPaint, width);
  for (const auto& landmark : field_.landmarks)
    if (landmark.kind > LandmarkKind::goalYellow)
      canvas.disc(spot(landmark.position), pixels(field_.beaconRadius) + 2.0, inks::kPink);
}

void FieldDrawing::attack(Canvas& canvas, const std::string& words) const {
  const double x = frame_.x + 0.5 * pixels(kAside) - 4.0;
  const Spot tail = spot({0.0, 0.34 * field_.length});
  const Spot tip = spot({0.0, 0.60 * field_.length});
  canvas.arrow({x, tail.y}, {x, tip.y}, inks::of(team_), 5.0);
  canvas.text({frame_.x + 12.0, tail.y + 8.0}, words, {12.0, inks::kText, true});
}

void FieldDrawing::fadingPath(Canvas& canvas, const std::vector<TimedPath>& pieces,
                              const Fading& fading, const Ink& ink, double width) const {
  const auto shadeAt = [&](double seconds) {
    const double age = std::clamp((fading.now - seconds) / std::max(fading.fade, 0.1), 0.0, 1.0);
    return static_cast<int>(std::lround((1.0 - age) * kShades));
  };
  for (const TimedPath& piece : pieces) {
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      spots.push_back(spot(piece[i].place));
      const int shade = shadeAt(piece[i].seconds);
      const bool last = i + 1 == piece.size();
      if (!last && shadeAt(piece[i + 1].seconds) == shade) continue;
      const double share = kWeakest + (1.0 - kWeakest) * shade / kShades;
      if (!last) spots.push_back(spot(piece[i + 1].place));
      canvas.line(spots, inks::mixed(inks::kCarpet, ink, share), width);
      spots.clear();
    }
  }
}

void FieldDrawing::robotPath(Canvas& canvas, const TimedPath& path, const Fading& fading) const {
  fadingPath(canvas, unbroken(path, kFastestRobot), fading, inks::kRobot, 3.0);
}

void FieldDrawing::ballPath(Canvas& canvas, const TimedPath& path, const Fading& fading) const {
  fadingPath(canvas, unbroken(path, kFastestBall), fading, inks::kBall, 2.4);
}

void FieldDrawing::belief(Canvas& canvas, const TimedPath& path) const {
  for (const TimedPath& piece : unbroken(path, kFastestRobot)) {
    std::vector<Spot> spots;
    for (const TimedPoint& point : piece) spots.push_back(spot(point.place));
    canvas.dashes(spots, inks::kBelief.faded(0.8), 1.6, 4.0);
  }
}

void FieldDrawing::marks(Canvas& canvas, const TimedPath& marks) const {
  for (const TimedPoint& mark : marks) {
    const Spot at = spot(mark.place);
    canvas.disc(at, 4.0, inks::kGround);
    canvas.disc(at, 2.5, inks::kRobot);
    canvas.label({at.x + 7.0, at.y - 7.0}, fmt::format("{:.0f} s", mark.seconds),
                 {11.0, inks::kText});
  }
}

void FieldDrawing::robot(Canvas& canvas, const TrueRobot& robot) const {
  // Neck base in front, body 20 cm behind it, 14 cm wide.
  constexpr std::array<Point2<Robot>, 5> kOutline = {
      {{0.0, 5.0}, {7.0, 0.0}, {7.0, -20.0}, {-7.0, -20.0}, {-7.0, 0.0}}};
  std::vector<Spot> corners;
  for (const auto& corner : kOutline) corners.push_back(spot(fieldFromRobot(robot.pose, corner)));
  canvas.shape(corners, inks::of(robot.team));
  corners.push_back(corners.front());
  canvas.line(corners, robot.own ? inks::kRobot : inks::kGround, robot.own ? 2.5 : 1.5);
  const Spot middle = spot(fieldFromRobot(robot.pose, Point2<Robot>{0.0, -9.0}));
  Type type{12.0, inks::kText, true, Align::centre};
  canvas.label({middle.x, middle.y - 8.0}, std::to_string(robot.player), type);
}

void FieldDrawing::believed(Canvas& canvas, const WorldModel& world) const {
  const auto& c = world.covariance;
  const double middle = 0.5 * (c[0] + c[4]);
  const double spread = std::sqrt(maths::square(0.5 * (c[0] - c[4])) + c[1] * c[1]);
  const auto radius = [&](double variance) {
    return std::clamp(pixels(2.0 * std::sqrt(std::max(0.0, variance))), 1.0, 3000.0);
  };
  const double turn = -0.5 * std::atan2(2.0 * c[1], c[0] - c[4]);
  const Spot at = spot(world.pose.position);
  canvas.ellipse(at, {radius(middle + spread), radius(middle - spread)}, turn, inks::kBelief, 1.5);
  canvas.arrow(at, spot(fieldFromRobot(world.pose, Point2<Robot>{0.0, 20.0})), inks::kBelief, 2.2);
  if (world.ball.present)
    canvas.ring(spot(world.ball.position), std::max(5.0, pixels(6.0)), inks::kBelief, 2.0);
}

void FieldDrawing::places(Canvas& canvas, const Moment& moment) const {
  canvas.cut(frame_, 10.0);
  for (const TrueRobot& one : moment.truth.robots) robot(canvas, one);
  if (moment.truth.present && moment.truth.ballThere)
    canvas.disc(spot(moment.truth.ball), std::max(4.5, pixels(body::kBallRadius)), inks::kBall);
  believed(canvas, moment.output.world);
  canvas.uncut();
}

void FieldDrawing::badges(Canvas& canvas, const std::vector<Point2<Field>>& places) const {
  std::vector<Spot> spots;
  for (const auto& place : places) spots.push_back(spot(place));
  const std::vector<Spot> beside = besideEach(spots, 24.0);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    canvas.line({spots[i], beside[i]}, inks::kText, 1.2);
    canvas.disc(spots[i], 3.0, inks::kText);
  }
  for (std::size_t i = 0; i < spots.size(); ++i)
    drawBadge(canvas, beside[i], static_cast<int>(i) + 1);
}

void drawBadge(Canvas& canvas, Spot middle, int number) {
  canvas.disc(middle, 10.0, inks::kGround);
  canvas.ring(middle, 10.0, inks::kText, 1.5);
  Type type{12.0, inks::kText, true, Align::centre};
  canvas.text({middle.x, middle.y - 7.5}, std::to_string(number), type);
}

}  // namespace kelpie::match

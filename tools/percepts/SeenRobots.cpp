// SPDX-License-Identifier: Apache-2.0
// Robots are recognised by the patches of their uniforms, which their flanks and head show; their
// feet are the dark points that stand on the carpet.
#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "tools/percepts/Eye.h"
#include "tools/percepts/Shown.h"
#include "vision/robot/ObstacleParams.h"
#include "vision/robot/RobotFinderParams.h"

namespace kelpie::percepts {
namespace {

constexpr double kFlanks = 43.0;  // cm2 of uniform that a robot shows from the side
constexpr double kEnds = 4.0;     // and from before or behind
constexpr double kMiddle = -4.0;  // cm ahead of the neck base, of a percept's place

// Share of its patches' places that show.
double patchesShown(const View& view, const sim::BodyPlace& robot) {
  const double h = robot.stance.shoulderHeight;
  const Point3<Robot> places[] = {{0.0, -9.0, h}, {0.0, -5.5, h + 1.0}, {0.0, 5.0, h + 9.0}};
  int shown = 0;
  for (const Point3<Robot>& place : places) {
    const Point2<Field> at = fieldFromRobot(robot.pose, {place.x, place.y});
    const auto spot = view.spot({at.x, at.y, place.z});
    if (!spot || !usable(spot->pixel)) continue;
    // The robot's own trunk does not hide its patches.
    const Spot before{spot->pixel, spot->depth - 16.0};
    shown += view.hidden(before) ? 0 : 1;
  }
  return shown / 3.0;
}

double recallAt(const RobotErrors& errors, TeamColour team, double pixels, double along) {
  if (pixels <= 0.0) return 0.0;
  if (along < errors.near) return errors.nearRecall;
  if (pixels > errors.tooMany) return errors.tooManyRecall;
  const bool red = team == TeamColour::red;
  const double few = red ? errors.redFew : errors.blueFew;
  const double many = red ? errors.redMany : errors.blueMany;
  return errors.recall * maths::clamp(std::log(pixels / few) / std::log(many / few), 0.0, 1.0);
}

PixelBox boxOf(const Look& look, std::size_t robot) {
  PixelBox box{1e9, 1e9, -1e9, -1e9};
  for (const Blocker& b : look.view.blockers())
    if (b.robot == robot && !b.lowerLeg)
      box = {std::min(box.left, b.box.left), std::min(box.top, b.box.top),
             std::max(box.right, b.box.right), std::max(box.bottom, b.box.bottom)};
  return box;
}

void add(const Look& look, std::size_t robot, Point2<Field> middle, double along,
         Percepts& percepts) {
  const RobotErrors& errors = look.noise.robot;
  const vision::RobotFinderParams said;
  const CameraPose& camera = look.view.believed();
  const auto spot =
      look.view.spot({middle.x, middle.y, look.moment.robots[robot].stance.shoulderHeight});
  if (!spot) return;
  PixelPoint pixel = spot->pixel;
  pixel.x += look.random.gaussian(0.0, errors.across) * camera.lens.focalLength / spot->depth;
  const double seenAlong =
      along * std::max(0.3, look.random.gaussian(1.0 + errors.bias, errors.share));
  const Point2<Robot> place = readPlace(camera, pixel, seenAlong);
  RobotPercept p;
  p.team = look.moment.teams[robot];
  p.distance = place.norm();
  p.heading = bearing(place);
  p.elevation = Angle::rad(maths::atan(readSlope(camera, pixel)));
  const double above = camera.position.z;
  const double direction =
      maths::hypot(said.directionSd.rad(), said.edgeSd / camera.lens.focalLength);
  p.distanceVariance = maths::square((along * along + above * above) / above * direction) +
                       maths::square(0.5 * said.depth);
  p.headingVariance = maths::square(said.headingSd / std::max(p.distance, 10.0));
  p.box = boxOf(look, robot);
  percepts.robots.push_back(p);
}

bool standsAhead(Point2<Robot> place, const vision::ObstacleParams& p) {
  return std::fabs(place.x) <= p.aheadSide && place.y > 0.0 && place.y <= p.aheadFar;
}

// The pixels of one column of a leg, from its foot up.
void addColumn(const Look& look, double x, const Blocker& leg, Percepts& percepts) {
  constexpr double kRow = 2.0;  // px of the lattice
  const vision::ObstacleParams p;
  const double foot = leg.box.bottom + look.random.gaussian(0.0, look.noise.obstacle.pixel);
  const PixelPoint lowest{x, foot};
  if (!usable(lowest)) return;
  const auto place = body::groundPoint(look.view.believed(), lowest);
  if (!place || place->norm() > p.maxDistance) return;
  percepts.obstacles.push_back({*place, lowest});
  double counted = 0.0;
  for (double y = foot; y > leg.box.top && counted < p.maxPerLine; y -= kRow, counted += 1.0) {
    const auto at = body::groundPoint(look.view.believed(), {x, y});
    if (!at || at->norm() > p.maxDistance) break;
    if (standsAhead(*at, p)) ++percepts.obstaclesAhead;
  }
}

}  // namespace

double shownUniform(const View& view, const sim::BodyPlace& robot) {
  const Point2<Field> at = robot.pose.position;
  const double way = std::atan2(at.y - view.eye().position.y, at.x - view.eye().position.x);
  const double side = std::fabs(std::sin(way - robot.pose.heading.rad()));
  const double scale = view.eye().lens.focal / std::max(view.distance(at), 10.0);
  return patchesShown(view, robot) * (kFlanks * side + kEnds) * scale * scale;
}

void seeRobots(const Look& look, Percepts& percepts) {
  const RobotErrors& errors = look.noise.robot;
  for (std::size_t i = 0; i < look.moment.robots.size(); ++i) {
    const sim::BodyPlace& robot = look.moment.robots[i];
    const Point2<Field> middle = fieldFromRobot(robot.pose, {0.0, kMiddle});
    const double along = look.view.distance(middle);
    if (along > errors.farthest || !look.view.spot({middle.x, middle.y, 12.0}) ||
        boxOf(look, i).right < 0.0)
      continue;
    const double pixels = shownUniform(look.view, robot);
    if (look.random.chance(recallAt(errors, look.moment.teams[i], pixels, along)))
      add(look, i, middle, along, percepts);
  }
}

void seeObstacles(const Look& look, Percepts& percepts) {
  constexpr double kColumnStep = 8.0;  // px
  for (double x = 4.0; x < kImageWidth; x += kColumnStep) {
    const Blocker* lowest = nullptr;
    for (const Blocker& b : look.view.blockers())
      if (b.lowerLeg && x > b.box.left && x < b.box.right && b.box.bottom < kImageHeight - 4.0 &&
          (lowest == nullptr || b.box.bottom > lowest->box.bottom))
        lowest = &b;
    if (lowest != nullptr && look.random.chance(look.noise.obstacle.recall))
      addColumn(look, x, *lowest, percepts);
  }
}

}  // namespace kelpie::percepts

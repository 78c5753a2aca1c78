// SPDX-License-Identifier: Apache-2.0
#include "tools/league/value/State.h"

#include <algorithm>
#include <cmath>

#include "tools/sim/bodies/HoldWatch.h"
#include "tools/sim/rules/MatchScene.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::value {
namespace {

using Poses = FixedVector<Pose2, sim::kMaxRobots>;

// A robot covers two discs, below its neck and below its hips; a ball whose centre passes closer
// meets it.
constexpr double kHips = 13.0;    // cm behind the neck base
constexpr double kCovers = 12.0;  // cm: half a body's width with its legs, and the ball's radius
// The mouth is looked at through so many points between the posts.
constexpr int kPoints = 20;
constexpr double kAhead = 0.5;     // s in which robots come to where the ball will be
constexpr double kLongest = 60.0;  // s; every ball lies by then

Point2<Field> middleOfMouth(const body::FieldDescription& field) {
  return {0.5 * field.width, field.length};
}

Point2<Field> nearestOfMouth(const body::FieldDescription& field, Point2<Field> p) {
  const double half = 0.5 * field.goalWidth;
  const double middle = 0.5 * field.width;
  return {maths::clamp(p.x, middle - half, middle + half), field.length};
}

bool inGoal(const body::FieldDescription& field, Point2<Field> p) {
  return p.y >= field.length && std::fabs(p.x - 0.5 * field.width) <= 0.5 * field.goalWidth;
}

double dot(Point2<Field> a, Point2<Field> b) { return a.x * b.x + a.y * b.y; }

// In degrees, without sign; 0 when one of them has no direction.
double angleBetween(Point2<Field> a, Point2<Field> b) {
  const double cross = a.x * b.y - a.y * b.x;
  return std::fabs(Angle::rad(maths::atan2(cross, dot(a, b))).deg());
}

Point2<Field> ahead(Angle heading) { return {heading.cos(), heading.sin()}; }

bool standsBetween(Point2<Field> disc, Point2<Field> from, Point2<Field> to) {
  const sim::Obstacle way{from, to, 0.0};
  return dot(disc - from, to - from) > 0.0 && distance(sim::nearestOn(way, disc), disc) < kCovers;
}

bool isCovered(const Poses& robots, Point2<Field> from, Point2<Field> to) {
  return std::any_of(robots.begin(), robots.end(), [&](const Pose2& robot) {
    const Point2<Field> hips = robot.position - ahead(robot.heading) * kHips;
    return standsBetween(robot.position, from, to) || standsBetween(hips, from, to);
  });
}

Point2<Field> restOf(Point2<Field> ball, Point2<Field> velocity, double seconds) {
  sim::Ball rolled{ball, velocity};
  sim::roll(rolled, seconds, sim::BallParams{});
  return rolled.position;
}

const Pose2* nearestTo(const Poses& robots, Point2<Field> p) {
  const auto nearest =
      std::min_element(robots.begin(), robots.end(), [&](const Pose2& a, const Pose2& b) {
        return distance(a.position, p) < distance(b.position, p);
      });
  return nearest == robots.end() ? nullptr : nearest;
}

double reach(const Poses& robots, Point2<Field> p) {
  const Pose2* const nearest = nearestTo(robots, p);
  return nearest == nullptr ? kFar : std::min(kFar, distance(nearest->position, p));
}

bool holds(const Poses& robots, Point2<Field> ball) {
  return std::any_of(robots.begin(), robots.end(),
                     [&](const Pose2& robot) { return sim::inHold(robot, ball); });
}

// Half an angle between two posts as seen from the line itself is nothing.
void lookAtMouth(const TeamState& state, const body::FieldDescription& field, Features& features) {
  const double half = 0.5 * field.goalWidth;
  const Point2<Field> middle = middleOfMouth(field);
  const Point2<Field> left = middle - Point2<Field>{half, 0.0};
  const Point2<Field> right = middle + Point2<Field>{half, 0.0};
  features.mouth = angleBetween(left - state.ball, right - state.ball);
  Poses all = state.other;
  for (const Pose2& robot : state.own) all.push_back(robot);
  int free = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double x = left.x + (i + 0.5) * field.goalWidth / kPoints;
    free += isCovered(all, state.ball, {x, field.length}) ? 0 : 1;
  }
  features.opening = features.mouth * free / kPoints;
}

// Where a ball that rolls crosses the line between the posts, and how far it would go from there.
void followBall(const TeamState& state, const body::FieldDescription& field, Features& features) {
  const Point2<Field> rest = restOf(state.ball, state.velocity, kLongest);
  features.restGoal = distance(rest, nearestOfMouth(field, rest));
  const double up = rest.y - state.ball.y;
  if (up <= 0.0 || rest.y < field.length || state.ball.y >= field.length) return;
  const double share = (field.length - state.ball.y) / up;
  const Point2<Field> crossing = state.ball + (rest - state.ball) * share;
  if (distance(crossing, nearestOfMouth(field, crossing)) > 0.0) return;
  features.restGoal = 0.0;
  features.entering = std::min(kBeyond, distance(rest, crossing));
  if (!isCovered(state.other, state.ball, crossing) && !isCovered(state.own, state.ball, crossing))
    features.free = features.entering;
}

void lookAtRobots(const TeamState& state, const body::FieldDescription& field, Features& features) {
  const Point2<Field> toGoal = middleOfMouth(field) - state.ball;
  const Point2<Field> toOwnGoal = Point2<Field>{0.5 * field.width, 0.0} - state.ball;
  const Point2<Field> soon = restOf(state.ball, state.velocity, kAhead);
  features.ownReach = reach(state.own, state.ball);
  features.otherReach = reach(state.other, state.ball);
  features.lead = reach(state.other, soon) - reach(state.own, soon);
  features.ownBehind = features.ownAim = features.otherBehind = 180.0;
  if (const Pose2* const own = nearestTo(state.own, state.ball); own != nullptr) {
    features.ownBehind = angleBetween(state.ball - own->position, toGoal);
    features.ownAim = angleBetween(ahead(own->heading), toGoal);
  }
  if (const Pose2* const other = nearestTo(state.other, state.ball); other != nullptr)
    features.otherBehind = angleBetween(state.ball - other->position, toOwnGoal);
  for (const Pose2& robot : state.other)
    features.guards += distance(robot.position, middleOfMouth(field)) < toGoal.norm() ? 1.0 : 0.0;
}

}  // namespace

TeamState stateOf(const sim::TruthFrame& truth, TeamColour team,
                  const body::FieldDescription& field) {
  TeamState state;
  state.ball = sim::ownView(field, team, truth.ball);
  state.velocity = team == TeamColour::blue ? truth.ballVelocity * -1.0 : truth.ballVelocity;
  for (const sim::RobotTruth& robot : truth.robots) {
    if (body::carpetDistance(field, robot.pose.position) > 0.0) continue;
    Poses& side = robot.team == team ? state.own : state.other;
    side.push_back(sim::ownView(field, team, robot.pose));
  }
  return state;
}

Features featuresOf(const TeamState& state, const body::FieldDescription& field) {
  Features features;
  const Point2<Field> toGoal = middleOfMouth(field) - state.ball;
  features.goal =
      inGoal(field, state.ball) ? 0.0 : distance(state.ball, nearestOfMouth(field, state.ball));
  features.towards = dot(state.velocity, toGoal) / std::max(1.0, toGoal.norm());
  lookAtMouth(state, field, features);
  followBall(state, field, features);
  lookAtRobots(state, field, features);
  features.ownHold = holds(state.own, state.ball) ? 1.0 : 0.0;
  features.otherHold = holds(state.other, state.ball) ? 1.0 : 0.0;
  features.own = static_cast<double>(state.own.size());
  features.other = static_cast<double>(state.other.size());
  return features;
}

}  // namespace kelpie::value

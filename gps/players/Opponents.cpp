// SPDX-License-Identifier: Apache-2.0
#include "gps/players/Opponents.h"

#include <algorithm>
#include <cmath>

#include "gps/Refusal.h"
#include "gps/players/Information.h"
#include "gps/pose/Predict.h"
#include "robot/body/Camera.h"

namespace kelpie::gps {
namespace {

constexpr double kImageMargin = 20.0;    // px; robots cut by the image border may be missed
constexpr double kBodyMiddle = 9.0;      // cm above the ground
constexpr double kMaxDistance = 1000.0;  // cm, of a sighting

using Filters = std::array<OpponentFilter, kOpponents>;

void forget(std::size_t index, const PlayersContext& context, Filters& filters) {
  filters[index] = OpponentFilter{};
  filters[index].belief = informationOf(startPlace(index, context));
}

// Thesis 2004 equation 2.15, kept as printed (checklist H08): sqrt(C00^2 + C11^2).
double vagueness(const OpponentFilter& filter) {
  const Place place = placeOf(filter.belief);
  return maths::hypot(place.covariance(0, 0), place.covariance(1, 1));
}

// The vaguest filter not yet assigned: an unknown one when there is any. -1: all are assigned.
int vaguest(const Filters& filters) {
  int best = -1;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    if (filters[i].assigned) continue;
    const bool first = best < 0;
    const OpponentFilter& other = filters[first ? i : static_cast<std::size_t>(best)];
    if (first || (!filters[i].known && other.known) ||
        (filters[i].known == other.known && vagueness(filters[i]) > vagueness(other))) {
      best = static_cast<int>(i);
    }
  }
  return best;
}

bool shouldBeSeen(const FrameInput& input, Point2<Robot> at, const OpponentParams& p) {
  if (at.norm() > p.missedReach) return false;
  const CameraPose camera = body::cameraPose(input.sensors.joints, input.stance);
  const auto pixel = body::project(camera, {at.x, at.y, kBodyMiddle});
  return pixel && pixel->x > kImageMargin && pixel->x < kImageWidth - kImageMargin &&
         pixel->y > kImageMargin && pixel->y < kImageHeight - kImageMargin;
}

void widen(double variance, OpponentFilter& filter) {
  Place place = placeOf(filter.belief);
  place.covariance += variance * Matrix2::Identity();
  filter.belief = informationOf(place);
}

void passTime(double elapsed, const OpponentParams& p, Filters& filters) {
  for (OpponentFilter& filter : filters) {
    filter.assigned = false;
    filter.secondsSinceSeen += elapsed;
    if (filter.known) widen(p.walkNoise * elapsed, filter);
  }
}

// A filter whose place is in the image, where no robot stands, is soon no longer believed.
void missUnseen(const FrameInput& input, const Pose2& pose, const OpponentParams& p,
                Filters& filters) {
  for (OpponentFilter& filter : filters) {
    if (!filter.known || filter.assigned) continue;
    const Point2<Field> at = pointOf(placeOf(filter.belief).mean);
    if (shouldBeSeen(input, robotFromField(pose, at), p))
      widen(p.missedNoise * elapsedOf(input), filter);
  }
}

void forgetVague(const PlayersContext& context, Filters& filters, GpsCounts& counts) {
  const OpponentParams& p = context.players.opponents;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    if (!filters[i].known) continue;
    const Place place = placeOf(filters[i].belief);
    const bool sound = place.mean.allFinite() && place.covariance.allFinite();
    if (!sound) count(Refusal::opponentNotFinite, counts);
    const double variance = 0.5 * place.covariance.trace();
    if (!sound || variance > p.forgetVariance || filters[i].secondsSinceSeen > p.keep) {
      forget(i, context, filters);
    }
  }
}

bool usable(const RobotPercept& r) {
  return std::isfinite(r.distance) && r.distance > 0.0 && r.distance < kMaxDistance &&
         std::isfinite(r.heading.rad()) && std::isfinite(r.distanceVariance) &&
         r.distanceVariance > 0.0 && std::isfinite(r.headingVariance) && r.headingVariance > 0.0;
}

bool nearField(const Place& place, const PlayersContext& context) {
  const double margin = context.players.team.offField;
  return place.mean(0) > -margin && place.mean(0) < context.field.width + margin &&
         place.mean(1) > -margin && place.mean(1) < context.field.length + margin;
}

// The filter that this sighting is of: nearest in angle (thesis 2004 equation 2.14) among those
// whose distance does not contradict it. -1: none.
int matchByAngle(const Place& seen, Angle heading, const Pose2& pose, const OpponentParams& p,
                 const Filters& filters) {
  int best = -1;
  Angle min = p.angleGate;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    if (!filters[i].known || filters[i].assigned) continue;
    const Place place = placeOf(filters[i].belief);
    const Angle off = (bearing(robotFromField(pose, pointOf(place.mean))) - heading).abs();
    const bool far =
        p.matchGate > 0.0 && mahalanobisSquared(place, seen) > maths::square(p.matchGate);
    if (far || off.rad() >= min.rad()) continue;
    best = static_cast<int>(i);
    min = off;
  }
  return best;
}

// The filter nearest to what a mate saw, which has no angle here. -1: none within the gate.
int matchByPlace(const Place& seen, double gate, const Filters& filters) {
  int best = -1;
  double min = gate * gate;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    if (!filters[i].known || filters[i].assigned) continue;
    const double squared = mahalanobisSquared(placeOf(filters[i].belief), seen);
    if (squared >= min) continue;
    best = static_cast<int>(i);
    min = squared;
  }
  return best;
}

// Two filters on one robot: the one seen now stays.
void forgetTwins(std::size_t index, const PlayersContext& context, Filters& filters) {
  const Vector2 at = placeOf(filters[index].belief).mean;
  for (std::size_t i = 0; i < filters.size(); ++i) {
    if (i == index || !filters[i].known || filters[i].assigned) continue;
    const Vector2 off = placeOf(filters[i].belief).mean - at;
    if (off.norm() < context.players.opponents.joinDistance) forget(i, context, filters);
  }
}

// Exactly one filter takes the sighting: the matched one, else the vaguest begins with it.
std::size_t take(int match, int spare, const Place& seen, Filters& filters) {
  const auto index = static_cast<std::size_t>(match >= 0 ? match : spare);
  OpponentFilter& filter = filters[index];
  if (match < 0) {
    filter = OpponentFilter{};
    filter.known = true;
  }
  add(informationOf(seen), filter.belief);
  filter.assigned = true;
  return index;
}

void see(const RobotPercept& percept, const PoseMode& pose, const PlayersContext& context,
         Filters& filters, GpsCounts& counts) {
  const OpponentParams& p = context.players.opponents;
  if (!usable(percept)) {
    count(Refusal::opponentNotFinite, counts);
    return;
  }
  const Place seen = sightingOf(percept, pose, p.varianceFactor);
  const double variance = 0.5 * seen.covariance.trace();
  if (!(variance < p.maxVariance) || !nearField(seen, context)) {
    count(Refusal::opponentUncertain, counts);
    return;
  }
  const int match = matchByAngle(seen, percept.heading, pose.pose, p, filters);
  const int spare = vaguest(filters);
  if (spare < 0) return;  // a fifth robot in one image
  const std::size_t index = take(match, spare, seen, filters);
  filters[index].secondsSinceSeen = 0.0;
  add(informationOf(seen), filters[index].unsent);
  filters[index].seenSinceMessage = true;
  forgetTwins(index, context, filters);
}

}  // namespace

Place startPlace(std::size_t index, const PlayersContext& context) {
  const double w = context.field.width;
  const double l = context.field.length;
  const std::array<Vector2, kOpponents> places{Vector2(0.5 * w, l), Vector2(0.5 * w, 0.75 * l),
                                               Vector2(0.75 * w, 0.75 * l),
                                               Vector2(0.5 * w, 0.5 * l)};
  return {places[index], context.players.opponents.startVariance * Matrix2::Identity()};
}

Place sightingOf(const RobotPercept& r, const PoseMode& pose, double factor) {
  const Point2<Robot> at = robotPolar(r.distance, r.heading);
  const Vector2 along(at.x / r.distance, at.y / r.distance);
  const Vector2 across(-along(1), along(0));
  const double sideways = maths::square(r.distance) * r.headingVariance;
  const Matrix2 covariance = factor * (r.distanceVariance * along * along.transpose() +
                                       sideways * across * across.transpose());
  return placeOnField(pose, at, covariance);
}

void stepOpponents(const GpsIn& in, const PoseMode& pose, const PlayersContext& context,
                   Opponents& opponents, GpsCounts& counts) {
  Filters& filters = opponents.filters;
  if (!opponents.started) {
    for (std::size_t i = 0; i < filters.size(); ++i) forget(i, context, filters);
    opponents.started = true;
  }
  passTime(elapsedOf(in.input), context.players.opponents, filters);
  for (const RobotPercept& percept : in.percepts.robots) {
    if (percept.team != in.input.game.team) see(percept, pose, context, filters, counts);
  }
  missUnseen(in.input, pose.pose, context.players.opponents, filters);
  forgetVague(context, filters, counts);
}

void hearOpponents(const TeamMessage& message, const PlayersContext& context,
                   Opponents& opponents) {
  Filters& filters = opponents.filters;
  for (OpponentFilter& filter : filters) filter.assigned = false;
  const OpponentParams& p = context.players.opponents;
  const double older = p.walkNoise * message.age;
  for (const SharedOpponent& opponent : message.opponents) {
    const Place seen{vectorOf(opponent.position),
                     matrixOf(opponent.covariance) + older * Matrix2::Identity()};
    const int match = matchByPlace(seen, std::max(p.matchGate, 1.0), filters);
    const int spare = vaguest(filters);
    if (spare < 0) return;
    const std::size_t index = take(match, spare, seen, filters);
    double& since = filters[index].secondsSinceSeen;
    since = match >= 0 ? std::min(since, message.age) : message.age;
    forgetTwins(index, context, filters);
  }
}

FixedVector<SharedOpponent, kOpponents> takeUnsent(Opponents& opponents) {
  FixedVector<SharedOpponent, kOpponents> list;
  for (OpponentFilter& filter : opponents.filters) {
    if (filter.seenSinceMessage) {
      const Place place = placeOf(filter.unsent);
      list.push_back({pointOf(place.mean), rowsOf(place.covariance)});
    }
    filter.unsent = Information{};
    filter.seenSinceMessage = false;
  }
  return list;
}

FixedVector<OpponentEstimate, kOpponents> extractOpponents(const Opponents& opponents) {
  FixedVector<OpponentEstimate, kOpponents> list;
  for (const OpponentFilter& filter : opponents.filters) {
    if (!filter.known) continue;
    const Place place = placeOf(filter.belief);
    list.push_back({pointOf(place.mean), rowsOf(place.covariance), filter.secondsSinceSeen});
  }
  return list;
}

}  // namespace kelpie::gps

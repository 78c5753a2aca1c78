// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/Course.h"

#include <algorithm>
#include <cmath>

#include "tools/broadcast/Gait.h"

namespace kelpie::broadcast {
namespace {

constexpr double kLegReach = 9.0;      // cm from the middle of a body to its feet: a turn as a way
constexpr double kJump = 15.0;         // cm between two samples: somebody was carried
constexpr double kLongAgo = 1.0;       // s: what was known so long ago is known no more
constexpr double kDense = 0.15;        // s between joints that are taken as they are
constexpr double kStandingPace = 2.0;  // cm/s: up to it a robot stands, from twice of it it walks
constexpr double kPaceSpan = 0.25;     // s, over which a robot's pace is taken
constexpr double kBallAhead = 16.0;  // cm ahead of the neck base, and aside, of a ball that is had
constexpr double kBallAside = 8.0;

// The sample at that time or the last before it, and the share of the way to the next.
template <class Sample>
struct Between {
  const Sample* before = nullptr;  // none: not known at that time
  const Sample* after = nullptr;
  double share = 0.0;
};

template <class Sample>
Between<Sample> between(const std::vector<Sample>& samples, double seconds) {
  if (samples.empty()) return {};
  auto after = std::upper_bound(samples.begin(), samples.end(), seconds,
                                [](double t, const Sample& s) { return t < s.seconds; });
  if (after == samples.begin()) {
    const bool soon = after->seconds - seconds < kLongAgo;
    return soon ? Between<Sample>{&*after, &*after, 0.0} : Between<Sample>{};
  }
  const Sample& before = *std::prev(after);
  if (after == samples.end() || after->seconds - before.seconds > kLongAgo) {
    if (seconds - before.seconds > kLongAgo) return {};
    return {&before, &before, 0.0};
  }
  return {&before, &*after, (seconds - before.seconds) / (after->seconds - before.seconds)};
}

double mixed(double a, double b, double share) { return a + share * (b - a); }
Angle mixed(Angle a, Angle b, double share) { return a + (b - a) * share; }

PlaceSample mixed(const PlaceSample& a, const PlaceSample& b, double share) {
  PlaceSample out = a;
  if (distance(a.pose.position, b.pose.position) > kJump) return share < 0.5 ? a : b;
  out.pose.position = a.pose.position + (b.pose.position - a.pose.position) * share;
  out.pose.heading = mixed(a.pose.heading, b.pose.heading, share);
  out.stance.shoulderHeight = mixed(a.stance.shoulderHeight, b.stance.shoulderHeight, share);
  out.stance.bodyTilt = mixed(a.stance.bodyTilt, b.stance.bodyTilt, share);
  out.stance.bodyRoll = mixed(a.stance.bodyRoll, b.stance.bodyRoll, share);
  out.way = mixed(a.way, b.way, share);
  return out;
}

JointAngles mixed(const JointAngles& a, const JointAngles& b, double share) {
  JointAngles out;
  for (std::size_t j = 0; j < kJointCount; ++j)
    out.angle[j] = partWay(a.angle[j], b.angle[j], share);
  return out;
}

double paceAt(const std::vector<PlaceSample>& samples, double seconds) {
  const auto way = [&](double t) {
    const auto found = between(samples, t);
    return found.before == nullptr ? 0.0 : mixed(found.before->way, found.after->way, found.share);
  };
  return (way(seconds + kPaceSpan) - way(seconds - kPaceSpan)) / (2.0 * kPaceSpan);
}

}  // namespace

void Course::addPlace(const Player& player, PlaceSample sample) {
  std::vector<PlaceSample>& samples = places_[player];
  if (!samples.empty()) {
    const PlaceSample& last = samples.back();
    if (sample.seconds <= last.seconds) return;
    const double moved = distance(last.pose.position, sample.pose.position);
    const double turned = std::fabs((sample.pose.heading - last.pose.heading).rad()) * kLegReach;
    sample.way = last.way + (moved > kJump ? 0.0 : moved + turned);
  }
  samples.push_back(sample);
}

void Course::addTruth(const sim::TruthFrame& truth) {
  const double seconds = truth.time.seconds();
  if (!ball_.empty() && seconds <= ball_.back().seconds) return;
  ball_.push_back({seconds, truth.ball, distance(truth.ball, sim::kAwayBall) > 1.0});
  for (const sim::RobotTruth& robot : truth.robots)
    addPlace({robot.team, robot.player}, {seconds, robot.pose, robot.stance, 0.0});
}

void Course::addEvent(const sim::MatchEvent& event) {
  for (const sim::MatchEvent& known : events_)
    if (known.time.us == event.time.us && known.kind == event.kind && known.team == event.team &&
        known.player == event.player)
      return;
  events_.push_back(event);
}

void Course::addJoints(const Player& player, const JointSample& sample) {
  std::vector<JointSample>& samples = joints_[player];
  if (samples.empty() || sample.seconds > samples.back().seconds) samples.push_back(sample);
}

void Course::addFrame(const Player& player, const FrameSample& sample) {
  std::vector<FrameSample>& samples = frames_[player];
  if (samples.empty() || sample.seconds > samples.back().seconds) samples.push_back(sample);
}

void Course::addBelief(const Player& player, double seconds, const WorldModel& world) {
  const auto found = frames_.find(player);
  if (found == frames_.end()) return;
  addPlace(player, {seconds, world.pose, found->second.back().stance, 0.0});
  if (ball_.empty() || seconds > ball_.back().seconds)
    ball_.push_back({seconds, world.ball.position, world.ball.present});
}

std::set<Player> Course::players() const {
  std::set<Player> players;
  for (const auto& known : places_) players.insert(known.first);
  return players;
}

std::vector<double> Course::frameTimes(const Player& player) const {
  std::vector<double> times;
  const auto known = frames_.find(player);
  if (known == frames_.end()) return times;
  for (const FrameSample& sample : known->second) times.push_back(sample.seconds);
  return times;
}

// Joints that are near each other in time are taken as they are; of those farther apart the head's
// are, and the legs' while the robot does not walk.
JointAngles Course::jointsAt(const Player& player, const PlaceSample& place, double seconds) const {
  const double pace = paceAt(places_.at(player), seconds);
  const JointAngles steps = walkingJoints(place.stance, place.way, pace);
  const auto known = joints_.find(player);
  const auto found =
      known == joints_.end() ? Between<JointSample>{} : between(known->second, seconds);
  if (found.before == nullptr) return steps;
  JointAngles joints = mixed(found.before->joints, found.after->joints, found.share);
  const double apart = found.before == found.after ? std::fabs(seconds - found.before->seconds)
                                                   : found.after->seconds - found.before->seconds;
  if (apart < kDense) return joints;
  const double walks = std::clamp((std::fabs(pace) - kStandingPace) / kStandingPace, 0.0, 1.0);
  for (std::size_t j = firstJoint(LegId::leftFront); j < kHinges; ++j)
    joints.angle[j] = partWay(joints.angle[j], steps.angle[j], walks);
  return joints;
}

Tableau Course::at(double seconds) const {
  Tableau tableau;
  for (const auto& [player, samples] : places_) {
    const auto found = between(samples, seconds);
    if (found.before == nullptr) continue;
    const PlaceSample place = mixed(*found.before, *found.after, found.share);
    Actor actor{player.first, player.second, place.pose, place.stance, {}};
    actor.joints = jointsAt(player, place, seconds);
    tableau.actors.push_back(actor);
  }
  const auto ball = between(ball_, seconds);
  if (ball.before == nullptr) return tableau;
  const bool jumped = distance(ball.before->place, ball.after->place) > 4.0 * kJump;
  tableau.ballThere = ball.before->there;
  tableau.ball = jumped
                     ? ball.before->place
                     : ball.before->place + (ball.after->place - ball.before->place) * ball.share;
  return tableau;
}

const Actor* Course::holderOf(const Tableau& tableau, double seconds) const {
  const Actor* holder = nullptr;
  double nearest = 1e9;
  for (const Actor& actor : tableau.actors) {
    if (!tableau.ballThere) break;
    const Point2<Robot> ball = robotFromField(actor.pose, tableau.ball);
    const auto known = frames_.find({actor.team, actor.player});
    const auto felt =
        known == frames_.end() ? Between<FrameSample>{} : between(known->second, seconds);
    const bool feels = felt.before != nullptr && felt.before->holds;
    const bool before = std::fabs(ball.x) < kBallAside && ball.y > 0.0 && ball.y < kBallAhead;
    if (!(before || (feels && ball.norm() < 2.0 * kBallAhead)) || ball.norm() >= nearest) continue;
    nearest = ball.norm();
    holder = &actor;
  }
  return holder;
}

}  // namespace kelpie::broadcast

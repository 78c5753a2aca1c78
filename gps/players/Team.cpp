// SPDX-License-Identifier: Apache-2.0
#include "gps/players/Team.h"

#include <algorithm>
#include <cmath>

#include "gps/OnField.h"
#include "gps/Refusal.h"
#include "gps/players/Opponents.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {
namespace {

constexpr double kMinVariance = 0.01;         // cm2
constexpr double kMaxVariance = 1e6;          // cm2
constexpr double kMaxHeadingVariance = 40.0;  // rad2
constexpr double kMaxSpeed = 500.0;           // cm/s, of a ball
constexpr double kMaxCount = 1e4;             // of an obstacle's points

// False for NaN, too.
bool near(Point2<Field> p, const body::FieldDescription& field, double margin) {
  return p.x > -margin && p.x < field.width + margin && p.y > -margin &&
         p.y < field.length + margin;
}

bool soundPose(const TeamMessage& m) {
  const std::array<double, 4> block{m.covariance[0], m.covariance[1], m.covariance[3],
                                    m.covariance[4]};
  const double heading = m.covariance[8];
  return std::isfinite(m.pose.heading.rad()) &&
         soundCovariance(block, kMinVariance, kMaxVariance) && heading >= 0.0 &&
         heading < kMaxHeadingVariance;
}

bool soundNote(const TeamNote& note, const body::FieldDescription& field, double margin) {
  return note.timeToBall >= 0.0 && note.timeToBall <= kNoTime && near(note.wanted, field, margin);
}

// What a script wants beyond the carpet would have mates refuse all of the message.
TeamNote onCarpet(TeamNote note, const body::FieldDescription& field) {
  note.wanted = body::carpetOf(field).nearest(note.wanted);
  return note;
}

bool soundBall(const SharedBall& b) {
  return std::fabs(b.velocity.x) < kMaxSpeed && std::fabs(b.velocity.y) < kMaxSpeed &&
         b.secondsSinceSeen >= 0.0 && std::isfinite(b.secondsSinceSeen) &&
         soundCovariance(b.covariance, kMinVariance, kMaxVariance);
}

// Numbers wrap round; a mate silent for long may have restarted.
bool newer(const TeamMessage& message, const Teammate& mate) {
  if (!mate.present) return true;
  const auto ahead = static_cast<std::uint16_t>(message.number - mate.last.number);
  return ahead != 0 && ahead < 0x8000;
}

// Mates that hear of it a sixth of a second late attack, too, or none does: a third of all frames
// without exactly one attacker.
bool takesOrLeavesBall(const TeamNote& before, const TeamNote& now) {
  return (before.role == Role::attacker) != (now.role == Role::attacker) ||
         before.grabs != now.grabs;
}

double largerRoot(const std::array<double, 9>& c, double more) {
  const double mean = 0.5 * (c[0] + c[4]);
  const double half = 0.5 * (c[0] - c[4]);
  return std::sqrt(std::max(0.0, mean + more + std::sqrt(half * half + c[1] * c[1])));
}

}  // namespace

bool believable(const TeamMessage& message, const body::FieldDescription& field,
                const TeamParams& params) {
  const auto nearField = [&](Point2<Field> p) { return near(p, field, params.offField); };
  const SharedBall& ball = message.ball;
  if (message.player < 1 || message.player > kTeammates + 1 || message.number == 0) return false;
  if (!(message.age >= 0.0 && message.age <= params.maxAge)) return false;
  if (!nearField(message.pose.position) || !soundPose(message)) return false;
  if (!soundNote(message.note, field, params.offField)) return false;
  if (ball.present && !(nearField(ball.position) && soundBall(ball))) return false;
  return std::all_of(message.opponents.begin(), message.opponents.end(),
                     [&](const SharedOpponent& o) {
                       return nearField(o.position) &&
                              soundCovariance(o.covariance, kMinVariance, kMaxVariance);
                     }) &&
         std::all_of(message.obstacles.begin(), message.obstacles.end(),
                     [&](const SharedObstacle& o) {
                       return nearField(o.position) && o.count >= 0.0 && o.count < kMaxCount;
                     });
}

FixedVector<TeamMessage, kTeammates> hear(const FrameInput& input, const PlayersContext& context,
                                          Teammates& mates, GpsCounts& counts) {
  const TeamParams& params = context.players.team;
  FixedVector<TeamMessage, kTeammates> heard;
  for (Teammate& mate : mates) {
    mate.last.age += elapsedOf(input);
    if (mate.last.age > params.keep) mate = Teammate{};
  }
  for (const TeamMessage& message : input.team) {
    if (!believable(message, context.field, params) || message.player == input.game.player) {
      count(Refusal::messageBroken, counts);
      continue;
    }
    Teammate& mate = mates[message.player - std::size_t{1}];
    if (!newer(message, mate)) {
      count(Refusal::messageRepeated, counts);
      continue;
    }
    mate = {true, message};
    heard.push_back(message);
  }
  return heard;
}

FixedVector<TeammateEstimate, kTeammates> extractMates(const TeamParams& params,
                                                       const Teammates& mates) {
  FixedVector<TeammateEstimate, kTeammates> list;
  for (const Teammate& mate : mates) {
    if (!mate.present) continue;
    const TeamMessage& m = mate.last;
    const double headingSd = std::min(std::sqrt(std::max(0.0, m.covariance[8])), maths::kPi);
    list.push_back({m.player, m.note, m.pose, largerRoot(m.covariance, params.walkNoise * m.age),
                    Angle::rad(headingSd), m.age,
                    m.ball.present ? m.ball.secondsSinceSeen + m.age : kNoTime});
  }
  return list;
}

void speak(const FrameInput& input, const WorldModel& world, const PlayersContext& context,
           PlayersState& players) {
  constexpr double kHalfFrame = 0.5 / 30.0;
  players.secondsSinceMessage += elapsedOf(input);
  const TeamParams& params = context.players.team;
  const bool isNews = takesOrLeavesBall(players.message.note, input.lastCommand.team);
  if (players.secondsSinceMessage + kHalfFrame < (isNews ? params.shortest : params.interval))
    return;
  players.secondsSinceMessage = 0.0;
  TeamMessage& m = players.message;
  m.number = static_cast<std::uint16_t>(m.number + 1);
  if (m.number == 0) m.number = 1;
  m.player = input.game.player;
  m.pose = world.pose;
  m.covariance = world.covariance;
  m.note = onCarpet(input.lastCommand.team, context.field);
  const BallEstimate& ball = world.ball;
  m.ball = SharedBall{};
  if (ball.present) {
    m.ball = {true, ball.position, ball.velocity, ball.fieldCovariance, ball.secondsSinceSeen};
  }
  m.opponents = takeUnsent(players.opponents);
  m.obstacles = fullest(players.obstacles, context.field, context.players.obstacles);
}

}  // namespace kelpie::gps

// SPDX-License-Identifier: Apache-2.0
#include "gps/players/BallLandmark.h"

#include <optional>

#include "gps/OnField.h"
#include "gps/ball/BallModels.h"
#include "gps/players/TeamBall.h"
#include "gps/pose/Outliers.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

BallSighting sightingOf(const BallTrack& own) {
  return {meanOf(own.both).head<2>(), covarianceOf(own.both).topLeftCorner<2, 2>()};
}

Point2<Robot> robotPoint(const BallSighting& seen) { return {seen.position(0), seen.position(1)}; }

// The innovation is the ball's place less where the mode sees it.
InformationSum informationOf(const PoseMode& mode, const BallSighting& seen, const Place& ball) {
  const PlaceFromPose expected = placeFrom(mode.pose, robotPoint(seen), seen.covariance);
  const Vector2 innovation = ball.mean - expected.place.mean;
  const Matrix2 inverse = (ball.covariance + expected.place.covariance).inverse();
  InformationSum sum;
  sum.matrix = expected.jacobian.transpose() * inverse * expected.jacobian;
  sum.vector = expected.jacobian.transpose() * inverse * innovation;
  sum.chiSquared = innovation.dot(inverse * innovation);
  return sum;
}

// What a message says of the ball now, if it can correct a robot that believes the ball at `own`.
std::optional<Place> surerBall(const TeamMessage& message, const Place& own,
                               const PlayersContext& context) {
  const BallLandmarkParams& p = context.players.ballLandmark;
  // Who has no role is penalised, and may be carried: it is sure of where it no longer stands.
  if (!message.ball.present || message.note.role == Role::none) return std::nullopt;
  const Witness witness = witnessOf(message, context);
  const Matrix2& reported = witness.place.covariance;
  if (witness.secondsSinceSeen > p.mateUnseen ||
      reported.trace() > p.surer * own.covariance.trace())
    return std::nullopt;
  const double late = p.lateSd * maths::hypot(witness.velocity.x, witness.velocity.y);
  return Place{witness.place.mean,
               reported + (p.noise + maths::square(late)) * Matrix2::Identity()};
}

void correctAll(const BallSighting& seen, const Place& ball, double outlierWeight, Modes& modes) {
  const std::size_t before = modes.size();
  for (std::size_t i = 0; i < before; ++i) {
    modes.push_back(outlierCopy(modes[i], outlierWeight));
    modes[i] = corrected(modes[i], informationOf(modes[i], seen, ball));
  }
}

// Once each: a message says nothing new in the next frame.
bool isNew(const Teammate& mate, std::uint16_t& used) {
  const bool fresh = mate.present && mate.last.number != used;
  used = mate.last.number;
  return fresh;
}

}  // namespace

bool correctByBall(const BallTrack& own, const PlayersContext& context, PlayersState& players,
                   Modes& modes) {
  const BallLandmarkParams& p = context.players.ballLandmark;
  if (!p.use || !own.present || own.secondsSinceSeen > p.ownUnseen) return false;
  const BallSighting seen = sightingOf(own);
  const Place here = placeOnField(modes[0], robotPoint(seen), seen.covariance);
  for (std::size_t i = 0; i < players.mates.size(); ++i) {
    const Teammate& mate = players.mates[i];
    if (!isNew(mate, players.usedBalls[i])) continue;
    if (const auto ball = surerBall(mate.last, here, context)) {
      correctAll(seen, *ball, p.outlierWeight, modes);
      return true;
    }
  }
  return false;
}

}  // namespace kelpie::gps

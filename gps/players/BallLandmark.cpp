// SPDX-License-Identifier: Apache-2.0
#include "gps/players/BallLandmark.h"

#include <optional>

#include "gps/OnField.h"
#include "gps/players/TeamBall.h"
#include "gps/pose/Outliers.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

// In the robot frame.
struct SeenBall {
  Point2<Robot> place;
  Matrix2 covariance;
};

SeenBall seenBall(const BallTrack& own) {
  const std::array<double, 4>& mean = own.both.mean;
  const std::array<double, 16>& c = own.both.covariance;
  return {{mean[0], mean[1]}, matrixOf({c[0], c[1], c[4], c[5]})};
}

// The innovation is the ball's place less pose + R(heading) times the place in the robot frame,
// which the heading moves along the tangent of a circle round the robot.
InformationSum informationOf(const PoseMode& mode, const SeenBall& seen, const Place& ball) {
  PoseMode exact = mode;
  exact.covariance = {};
  const Place expected = placeOnField(exact, seen.place, seen.covariance);
  const Vector2 innovation = ball.mean - expected.mean;
  const Vector2 arm = expected.mean - vectorOf(mode.pose.position);
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << 1.0, 0.0, -arm(1), 0.0, 1.0, arm(0);
  const Matrix2 inverse = (ball.covariance + expected.covariance).inverse();
  InformationSum sum;
  sum.matrix = jacobian.transpose() * inverse * jacobian;
  sum.vector = jacobian.transpose() * inverse * innovation;
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
  const Matrix2& told = witness.place.covariance;
  if (witness.secondsSinceSeen > p.mateUnseen || told.trace() > p.surer * own.covariance.trace())
    return std::nullopt;
  const double late = p.lateSd * maths::hypot(witness.velocity.x, witness.velocity.y);
  return Place{witness.place.mean, told + (p.noise + maths::square(late)) * Matrix2::Identity()};
}

void correctAll(const SeenBall& seen, const Place& ball, double outlierWeight, Modes& modes) {
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
  const SeenBall seen = seenBall(own);
  const Place here = placeOnField(modes[0], seen.place, seen.covariance);
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

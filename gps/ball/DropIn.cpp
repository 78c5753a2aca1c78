// SPDX-License-Identifier: Apache-2.0
#include "gps/ball/DropIn.h"

#include <algorithm>
#include <cmath>

#include "gps/OnField.h"
#include "gps/ball/BallModels.h"

namespace kelpie::gps {
namespace {

void place(Point2<Field> point, double variance, const PoseMode& pose, BallTrack& ball) {
  const Point2<Robot> relative = robotFromField(pose.pose, point);
  const Matrix2 onField = placeOnField(pose, relative, Matrix2::Zero()).covariance;
  const double s = pose.pose.heading.sin();
  const double c = pose.pose.heading.cos();
  Matrix2 turned;  // from the field's axes into the robot's
  turned << s, -c, c, s;
  placeModels({{relative.x, relative.y},
               variance * Matrix2::Identity() + turned * onField * turned.transpose()},
              ball);
  ball.missed = 0;
  ball.weightedUnseenSeconds = 0.0;
}

bool believedOut(const body::FieldDescription& field, const BallFilterParams& params,
                 const PoseMode& pose, const BallTrack& ball) {
  const DropInParams& p = params.dropIn;
  if (!ball.present || ball.secondsSinceSeen < p.unseen) return false;
  if (pose.covariance[0] + pose.covariance[4] > 2.0 * maths::square(p.maxPoseSd)) return false;
  const Matrix2 covariance = covarianceOf(ball.both).topLeftCorner<2, 2>();
  const Place at = placeOnField(pose, {ball.both.mean[0], ball.both.mean[1]}, covariance);
  const double beyond = beyondLines(field, pointOf(at.mean));
  const Point2<Field> middle{0.5 * field.width, 0.5 * field.length};
  const double side = std::fabs(at.mean(0) - middle.x) - middle.x;
  const double end = std::fabs(at.mean(1) - middle.y) - middle.y;
  const double variance = side > end ? at.covariance(0, 0) : at.covariance(1, 1);
  const bool gone = ball.missed > params.missedFrames;  // its place is in sight and empty
  return beyond > (gone ? 0.0 : p.outSds * std::sqrt(std::max(0.0, variance)));
}

}  // namespace

double beyondLines(const body::FieldDescription& field, Point2<Field> ball) {
  const double side = std::max(-ball.x, ball.x - field.width);
  const double end = std::max(-ball.y, ball.y - field.length);
  const bool inGoal = std::fabs(ball.x - 0.5 * field.width) < 0.5 * field.goalWidth;
  return std::max(side, inGoal ? std::min(end, 0.0) : end) - body::kBallRadius;
}

void applyReferee(const GameState& game, const body::FieldDescription& field,
                  const BallFilterParams& params, const PoseState& pose, BallState& ball) {
  const PoseMode& mode = pose.modes[0];
  BallTrack& track = ball.track;
  const std::uint32_t goals = std::uint32_t{game.ownScore} + game.opponentScore;
  const bool scored = goals > ball.goals;
  ball.goals = goals;
  if (scored && track.present && track.secondsSinceSeen > 0.0) {
    const Point2<Field> centre{0.5 * field.width, 0.5 * field.length};
    place(centre, params.dropIn.variance, mode, track);
    return;
  }
  if (field.borderWidth > 0.0 || pose.lost || !believedOut(field, params, mode, track)) return;
  const Point2<Field> at = fieldFromRobot(mode.pose, {track.both.mean[0], track.both.mean[1]});
  place(body::throwInPlace(field, at), params.dropIn.variance, mode, track);
}

}  // namespace kelpie::gps

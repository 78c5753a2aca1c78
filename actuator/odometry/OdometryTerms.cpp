// SPDX-License-Identifier: Apache-2.0
#include "actuator/odometry/OdometryTerms.h"

#include <cmath>

namespace kelpie::actuator {
namespace {

double bent(double s) { return s * std::fabs(s); }
double cubed(double s) { return s * s * s; }

SideReach meanOf(const Reach& reach) {
  const auto& [left, right] = reach;
  return {0.5 * (left.frontRotator + right.frontRotator),
          0.5 * (left.frontShoulder + right.frontShoulder),
          0.5 * (left.frontKnee + right.frontKnee),
          0.5 * (left.hindRotator + right.hindRotator),
          0.5 * (left.hindShoulder + right.hindShoulder),
          0.5 * (left.hindKnee + right.hindKnee)};
}

// A turn or side step is the mirror image of that to the other side.
void feel(double speed, double change, const Felt& felt, AcrossTerms& f) {
  const SideReach& near = speed > 0.0 ? felt.reach.left : felt.reach.right;
  const SideReach& other = speed > 0.0 ? felt.reach.right : felt.reach.left;
  f.felt = {felt.load * speed, change, near * speed, near * bent(speed)};
  f.otherLegs = other * speed;
  f.otherLegsBent = other * bent(speed);
}

AcrossTerms acrossFactors(const Velocity& feet, double joints) {
  const auto& [forward, left, turn] = feet;
  AcrossTerms f;
  f.joints = joints;
  f.left = left;
  f.leftBent = bent(left);
  f.leftCubed = cubed(left);
  f.turn = turn;
  f.turnBent = bent(turn);
  f.turnCubed = cubed(turn);
  f.forwardLeft = forward * left;
  f.forwardTurn = forward * turn;
  f.speedLeft = std::fabs(forward) * left;
  f.speedTurn = std::fabs(forward) * turn;
  f.leftTurning = left * std::fabs(turn);
  f.turnLateral = turn * std::fabs(left);
  return f;
}

double sum(const FeltTerms& f, const FeltTerms& share) {
  return f.load * share.load + f.change * share.change + sum(f.legs, share.legs) +
         sum(f.legsBent, share.legsBent);
}

double sum(const AlongTerms& f, const AlongTerms& share) {
  return f.joints * share.joints + f.ahead * share.ahead + f.aheadBent * share.aheadBent +
         f.behind * share.behind + f.behindBent * share.behindBent + f.left * share.left +
         f.leftBent * share.leftBent + f.turn * share.turn + f.turnBent * share.turnBent +
         f.leftTurn * share.leftTurn + f.aheadLeft * share.aheadLeft +
         f.aheadTurn * share.aheadTurn + f.behindLeft * share.behindLeft +
         f.behindTurn * share.behindTurn + sum(f.felt, share.felt);
}

double sum(const AcrossTerms& f, const AcrossTerms& share) {
  return f.joints * share.joints + f.left * share.left + f.leftBent * share.leftBent +
         f.leftCubed * share.leftCubed + f.turn * share.turn + f.turnBent * share.turnBent +
         f.turnCubed * share.turnCubed + f.forwardLeft * share.forwardLeft +
         f.forwardTurn * share.forwardTurn + f.speedLeft * share.speedLeft +
         f.speedTurn * share.speedTurn + f.leftTurning * share.leftTurning +
         f.turnLateral * share.turnLateral + sum(f.felt, share.felt) +
         sum(f.otherLegs, share.otherLegs) + sum(f.otherLegsBent, share.otherLegsBent);
}

}  // namespace

AlongTerms alongFactors(const Velocity& feet, const Felt& felt, double joints) {
  const double ahead = std::fmax(feet.forward, 0.0);
  const double behind = std::fmin(feet.forward, 0.0);
  const double left = std::fabs(feet.left);
  const double turn = std::fabs(feet.turn);
  AlongTerms f;
  f.joints = joints;
  f.ahead = ahead;
  f.aheadBent = bent(ahead);
  f.behind = behind;
  f.behindBent = bent(behind);
  f.left = left;
  f.leftBent = bent(left);
  f.turn = turn;
  f.turnBent = bent(turn);
  f.leftTurn = feet.left * feet.turn;
  f.aheadLeft = ahead * left;
  f.aheadTurn = ahead * turn;
  f.behindLeft = behind * left;
  f.behindTurn = behind * turn;
  const SideReach reach = meanOf(felt.reach);
  f.felt = {felt.load * feet.forward, felt.change.forward, reach * feet.forward,
            reach * bent(feet.forward)};
  return f;
}

AcrossTerms leftFactors(const Velocity& feet, const Felt& felt, double joints) {
  AcrossTerms f = acrossFactors(feet, joints);
  feel(feet.left, felt.change.left, felt, f);
  return f;
}

AcrossTerms turnFactors(const Velocity& feet, const Felt& felt, double joints) {
  AcrossTerms f = acrossFactors(feet, joints);
  feel(feet.turn, felt.change.turn, felt, f);
  return f;
}

Velocity likelySpeed(const Velocity& feet, const Felt& felt, const WalkOdometry& odometry) {
  return {sum(alongFactors(feet, felt, 0.0), odometry.forward),
          sum(leftFactors(feet, felt, 0.0), odometry.left),
          sum(turnFactors(feet, felt, 0.0), odometry.turn)};
}

}  // namespace kelpie::actuator

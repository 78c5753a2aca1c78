// SPDX-License-Identifier: Apache-2.0
// How the way of a walk is estimated, as numbers of that walk: each is a share of one term of
// OdometryTerms.h. `kelpie calibrate walk` fits them to walks on varied models.
#pragma once

#include "actuator/walk/SideReach.h"

namespace kelpie::actuator {

// Shares of what the body feels, each times the feet's speed in the direction that is estimated.
struct FeltTerms {
  double load = 0.0;    // Feeling.h
  double change = 0.0;  // times the change of that speed in the last quarter of a second, alone
  SideReach legs;       // Reach.h; of the side that it goes to, ahead the mean of both
  SideReach legsBent;   // times |speed| as well

  template <int = 0>
  static constexpr auto fields() {
    using P = FeltTerms;
    return fieldList(field("load", &P::load, "", -50, 50), field("change", &P::change, "", -50, 50),
                     field("legs", &P::legs), field("legsBent", &P::legsBent));
  }
};

// Of the way ahead, which is the same for a walk and its mirror image. `ahead` and `behind` are the
// two signs of the feet's speed forward, left and turn the amounts to either side.
struct AlongTerms {
  double joints = 0.0;  // of the standing feet's motion by the joints (FootMotion.h)
  double ahead = 0.0;
  double aheadBent = 0.0;  // times |speed| as well
  double behind = 0.0;
  double behindBent = 0.0;
  double left = 0.0;
  double leftBent = 0.0;
  double turn = 0.0;
  double turnBent = 0.0;
  double leftTurn = 0.0;  // of both with their signs
  double aheadLeft = 0.0;
  double aheadTurn = 0.0;
  double behindLeft = 0.0;
  double behindTurn = 0.0;
  FeltTerms felt;

  template <int = 0>
  static constexpr auto fields() {
    using P = AlongTerms;
    return fieldList(
        field("joints", &P::joints, "", -2, 2), field("ahead", &P::ahead, "", -30, 30),
        field("aheadBent", &P::aheadBent, "", -30, 30), field("behind", &P::behind, "", -30, 30),
        field("behindBent", &P::behindBent, "", -30, 30), field("left", &P::left, "", -30, 30),
        field("leftBent", &P::leftBent, "", -30, 30), field("turn", &P::turn, "", -30, 30),
        field("turnBent", &P::turnBent, "", -30, 30), field("leftTurn", &P::leftTurn, "", -30, 30),
        field("aheadLeft", &P::aheadLeft, "", -30, 30),
        field("aheadTurn", &P::aheadTurn, "", -30, 30),
        field("behindLeft", &P::behindLeft, "", -30, 30),
        field("behindTurn", &P::behindTurn, "", -30, 30), field("felt", &P::felt));
  }
};

// Of the lateral way and of the turn, which are the opposite for the mirror image.
struct AcrossTerms {
  double joints = 0.0;
  double left = 0.0;
  double leftBent = 0.0;   // times |left| as well
  double leftCubed = 0.0;  // and once more
  double turn = 0.0;
  double turnBent = 0.0;
  double turnCubed = 0.0;
  double forwardLeft = 0.0;  // with the sign of forward
  double forwardTurn = 0.0;
  double speedLeft = 0.0;  // |forward| times left
  double speedTurn = 0.0;
  double leftTurning = 0.0;  // left times |turn|
  double turnLateral = 0.0;  // turn times |left|
  FeltTerms felt;
  SideReach otherLegs;
  SideReach otherLegsBent;

  template <int = 0>
  static constexpr auto fields() {
    using P = AcrossTerms;
    return fieldList(field("joints", &P::joints, "", -2, 2), field("left", &P::left, "", -30, 30),
                     field("leftBent", &P::leftBent, "", -30, 30),
                     field("leftCubed", &P::leftCubed, "", -30, 30),
                     field("turn", &P::turn, "", -30, 30),
                     field("turnBent", &P::turnBent, "", -30, 30),
                     field("turnCubed", &P::turnCubed, "", -30, 30),
                     field("forwardLeft", &P::forwardLeft, "", -30, 30),
                     field("forwardTurn", &P::forwardTurn, "", -30, 30),
                     field("speedLeft", &P::speedLeft, "", -30, 30),
                     field("speedTurn", &P::speedTurn, "", -30, 30),
                     field("leftTurning", &P::leftTurning, "", -30, 30),
                     field("turnLateral", &P::turnLateral, "", -30, 30), field("felt", &P::felt),
                     field("otherLegs", &P::otherLegs), field("otherLegsBent", &P::otherLegsBent));
  }
};

struct WalkOdometry {
  AlongTerms forward;  // cm/s
  AcrossTerms left;    // cm/s
  AcrossTerms turn;    // rad/s

  template <int = 0>
  static constexpr auto fields() {
    using P = WalkOdometry;
    return fieldList(field("forward", &P::forward), field("left", &P::left),
                     field("turn", &P::turn));
  }
};

// Of a walk that does what its feet do.
inline WalkOdometry exactOdometry() {
  WalkOdometry odometry;
  odometry.forward.ahead = odometry.forward.behind = odometry.left.left = odometry.turn.turn = 1.0;
  return odometry;
}

}  // namespace kelpie::actuator

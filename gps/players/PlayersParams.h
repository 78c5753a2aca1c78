// SPDX-License-Identifier: Apache-2.0
// What can be tuned in the beliefs about the team's ball, the opponents and the team mates. Numbers
// of thesis 2004 section 2.3 and facts-2005 section 5.4 where they state them, else ours.
#pragma once

#include "gps/players/ObstacleMapParams.h"
#include "robot/core/types/Geometry.h"

namespace kelpie::gps {

struct TeamBallParams {
  double keep = 1.5;            // s since it was seen; older ones are no witnesses
  double growth = 30.0;         // cm2/s while a message ages
  double witnessNoise = 2.0;    // cm2 more for each: errors that its covariance does not know
  double gate = 9.21;           // two dimensions, 99 %; beyond it two saw different balls
  double maxVariance = 4900.0;  // cm2; vaguer ones are no witnesses

  template <int = 0>
  static constexpr auto fields() {
    using P = TeamBallParams;
    return fieldList(field("keep", &P::keep, "s", 0.01, 60),
                     field("growth", &P::growth, "cm2/s", 0, 1e5),
                     field("witnessNoise", &P::witnessNoise, "cm2", 0, 1e4),
                     field("gate", &P::gate, "", 0.1, 1000),
                     field("maxVariance", &P::maxVariance, "cm2", 1, 1e6));
  }
};

struct OpponentParams {
  Angle angleGate = Angle::deg(15.0);  // between sighting and filter (checklist U17)
  double matchGate = 3.5;              // standard deviations; 0: by the angle alone, as the thesis
  double startVariance = 2500.0;       // cm2 (facts-2005 section 5.4)
  double walkNoise = 400.0;            // cm2/s, how opponents walk about
  double missedNoise = 3000.0;         // cm2/s more when it should be in the image and is not
  double missedReach = 150.0;          // cm; farther ones are often overlooked
  double varianceFactor = 2.0;         // errors of one robot's sightings repeat
  double maxVariance = 5625.0;         // cm2; vaguer sightings are not used
  double forgetVariance = 3600.0;      // cm2; a filter so vague knows of no opponent
  double joinDistance = 30.0;          // cm; two filters nearer than a robot is long are one robot
  double keep = 15.0;                  // s unseen

  template <int = 0>
  static constexpr auto fields() {
    using P = OpponentParams;
    return fieldList(field("angleGate", &P::angleGate, "rad", 1, 90),
                     field("matchGate", &P::matchGate, "", 0, 100),
                     field("startVariance", &P::startVariance, "cm2", 1, 1e6),
                     field("walkNoise", &P::walkNoise, "cm2/s", 0, 1e5),
                     field("missedNoise", &P::missedNoise, "cm2/s", 0, 1e6),
                     field("missedReach", &P::missedReach, "cm", 0, 1000),
                     field("varianceFactor", &P::varianceFactor, "", 0.1, 100),
                     field("maxVariance", &P::maxVariance, "cm2", 1, 1e6),
                     field("forgetVariance", &P::forgetVariance, "cm2", 1, 1e6),
                     field("joinDistance", &P::joinDistance, "cm", 0, 100),
                     field("keep", &P::keep, "s", 0.1, 1000));
  }
};

struct TeamParams {
  double interval = 1.0 / 6.0;  // s between own messages: every fifth frame,
  double shortest =
      1.0 / 15.0;            // or so few once it has become attacker, is none any more, or grabs
  double keep = 1.5;         // s until a silent mate is forgotten (45 frames)
  double walkNoise = 400.0;  // cm2/s, how mates walk on since their message
  double maxAge = 2.0;       // s; older messages are refused
  double offField = 60.0;    // cm beyond the lines; what is farther is refused

  template <int = 0>
  static constexpr auto fields() {
    using P = TeamParams;
    return fieldList(
        field("interval", &P::interval, "s", 0.01, 10),
        field("shortest", &P::shortest, "s", 0.01, 10), field("keep", &P::keep, "s", 0.1, 100),
        field("walkNoise", &P::walkNoise, "cm2/s", 0, 1e5),
        field("maxAge", &P::maxAge, "s", 0.01, 100), field("offField", &P::offField, "cm", 0, 500));
  }
};

// Who corrects his pose by a mate's ball (gps/players/BallLandmark.h).
struct BallLandmarkParams {
  bool use = true;
  double ownUnseen = 0.1;   // s since this robot saw the ball, at most
  double mateUnseen = 0.5;  // s since the mate did
  // The mate's variance v of the ball, at most, over the own one. A correction leaves round
  // v / (1 + surer), which the mate does not take back while that is above surer v: up to 0.618 two
  // robots do not hear their own ball again. By way of a third it comes back, with noise and age.
  double surer = 0.6;
  double noise = 5.0;           // cm2 more than the mate's covariance tells
  double lateSd = 0.1;          // s of the ball's speed: when the two saw it
  double outlierWeight = 1e-2;  // of the copy that is not corrected

  template <int = 0>
  static constexpr auto fields() {
    using P = BallLandmarkParams;
    return fieldList(
        field("use", &P::use), field("ownUnseen", &P::ownUnseen, "s", 0, 10),
        field("mateUnseen", &P::mateUnseen, "s", 0, 10), field("surer", &P::surer, "", 0, 0.618),
        field("noise", &P::noise, "cm2", 0, 1e4), field("lateSd", &P::lateSd, "s", 0, 10),
        field("outlierWeight", &P::outlierWeight, "", 0, 1));
  }
};

struct PlayersParams {
  TeamBallParams teamBall;
  BallLandmarkParams ballLandmark;
  OpponentParams opponents;
  TeamParams team;
  ObstacleMapParams obstacles;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("teamBall", &PlayersParams::teamBall),
                     field("ballLandmark", &PlayersParams::ballLandmark),
                     field("opponents", &PlayersParams::opponents),
                     field("team", &PlayersParams::team),
                     field("obstacles", &PlayersParams::obstacles));
  }
};

}  // namespace kelpie::gps

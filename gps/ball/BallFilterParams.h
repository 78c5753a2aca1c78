// SPDX-License-Identifier: Apache-2.0
// What can be tuned in the ball filter, and in what the referee does with a ball. Numbers of
// facts-2005 section 5.3 where it states them, else ours.
#pragma once

#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

// Where the referee puts a ball that left the field (rules 2006), and when that is believed.
struct DropInParams {
  double outSds = 2.0;      // so far beyond the line, in standard deviations, it is out
  double unseen = 0.2;      // s; a ball in sight is where it is seen
  double variance = 30.0;   // cm2, of the referee's hand (facts-2005 section 5.3)
  double maxPoseSd = 50.0;  // cm; a robot that knows its place less does not judge

  template <int = 0>
  static constexpr auto fields() {
    using P = DropInParams;
    return fieldList(field("outSds", &P::outSds, "", 0, 10),
                     field("unseen", &P::unseen, "s", 0, 10),
                     field("variance", &P::variance, "cm2", 1, 1e4),
                     field("maxPoseSd", &P::maxPoseSd, "cm", 1, 1000));
  }
};

struct BallFilterParams {
  double deceleration = 6.0;    // cm/s2 of a slow rolling ball
  double drag = 0.8;            // 1/s more: keeps 0.975 a frame (checklist G52)
  double velocityNoise = 20.0;  // (cm/s)2 per s, of a rolling ball
  double positionNoise = 4.0;   // cm2/s
  double unseenNoise = 60.0;    // cm2/s more while it is not seen
  double startRate = 0.25;      // 1/s, how often a lying ball begins to roll
  double stopRate = 3.0;        // 1/s, how often one slower than stopSpeed lies
  double stopSpeed = 10.0;      // cm/s
  double minSd = 1.5;           // cm, least error of one sighting
  // What one is wrong by in matches: 2 to 4 % of its distance and 1 deg while the head moves by
  // less than 2.5 deg a frame, 10 % and 2 deg at 17. Believed to 3 %, what a look to the side and
  // back showed of a lying ball made it roll at 1 m/s: in 24 matches in a third of the frames.
  double minShare = 0.02;  // of its distance: least and most error of one,
  double maxShare = 0.04;
  double sharePerHeadSpeed = 0.35;  // and more per rad a frame of the head's speed
  Angle headingSd = Angle::deg(0.7);
  double headingLate = 0.12;       // frames; of the head's speed, its heading is wrong by more
  double startSpeedSd = 60.0;      // cm/s, of a ball just found
  double kickSpeedSd = 200.0;      // cm/s, of a near ball while we kick
  double kickReach = 40.0;         // cm
  double kickSeconds = 1.0;        // s after it in which a jump is believed at once
  double gate = 3.0;               // standard deviations; a sighting outside waits for a second
  double keep = 5.0;               // s until an unseen ball is given up
  double missedReach = 100.0;      // cm; a ball in the image nearer than this must be seen
  std::uint32_t missedFrames = 5;  // so often in a row it may be missed
  double missedFactor = 4.0;       // how much faster it is given up then
  double heldAhead = 8.0;          // cm from the neck to a held ball (docs/physical-body.md)
  double heldSd = 1.5;             // cm
  DropInParams dropIn;

  template <int = 0>
  static constexpr auto fields() {
    using B = BallFilterParams;
    return fieldList(field("deceleration", &B::deceleration, "cm/s2", 0, 1000),
                     field("drag", &B::drag, "1/s", 0, 10),
                     field("velocityNoise", &B::velocityNoise, "cm2/s3", 0, 1e6),
                     field("positionNoise", &B::positionNoise, "cm2/s", 0, 1e5),
                     field("unseenNoise", &B::unseenNoise, "cm2/s", 0, 1e6),
                     field("startRate", &B::startRate, "1/s", 0, 30),
                     field("stopRate", &B::stopRate, "1/s", 0, 30),
                     field("stopSpeed", &B::stopSpeed, "cm/s", 0, 100),
                     field("minSd", &B::minSd, "cm", 0.1, 100),
                     field("minShare", &B::minShare, "", 0.001, 1),
                     field("maxShare", &B::maxShare, "", 0.001, 10),
                     field("sharePerHeadSpeed", &B::sharePerHeadSpeed, "/rad", 0, 10),
                     field("headingSd", &B::headingSd, "rad", 0, 45),
                     field("headingLate", &B::headingLate, "", 0, 10),
                     field("startSpeedSd", &B::startSpeedSd, "cm/s", 0, 1000),
                     field("kickSpeedSd", &B::kickSpeedSd, "cm/s", 0, 1000),
                     field("kickReach", &B::kickReach, "cm", 0, 200),
                     field("kickSeconds", &B::kickSeconds, "s", 0, 10),
                     field("gate", &B::gate, "", 1, 100), field("keep", &B::keep, "s", 0.1, 100),
                     field("missedReach", &B::missedReach, "cm", 0, 1000),
                     field("missedFrames", &B::missedFrames, "", 0, 1000),
                     field("missedFactor", &B::missedFactor, "", 1, 100),
                     field("heldAhead", &B::heldAhead, "cm", 0, 30),
                     field("heldSd", &B::heldSd, "cm", 0.1, 30), field("dropIn", &B::dropIn));
  }
};

}  // namespace kelpie::gps

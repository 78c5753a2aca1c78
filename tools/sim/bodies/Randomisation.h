// SPDX-License-Identifier: Apache-2.0
// How a world differs from the one that Kelpie was tuned in, drawn from a seed: each robot's body,
// physics, neck, lens, shutter, nose and uniform, and the place that it plays in. No two robots and
// no two venues are alike; the nominal world (seed 0) has none of this. Every kind of difference
// can be switched off by itself and has its own random numbers, so that one never changes another.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/FixedVector.h"
#include "tools/sim/bodies/Backlash.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/sim/camera/FieldCamera.h"
#include "tools/sim/camera/Scene.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::sim {

constexpr const char* kRandomisedTopic = "/randomised";

// What kinds of difference there are, and how large they are drawn.
struct RandomisationParams {
  std::uint64_t seed = 0;  // 0: the nominal world
  Lean lean;               // constant, of every robot, in the nominal world too: for experiments

  bool body = true;     // lean and accelerometer
  bool physics = true;  // servos, mass, friction and play of legs (physics/Variation.h)
  bool neck = true;     // play of the head's joints
  bool lens = true;     // focal length
  bool shutter = true;  // read-out time, or global
  bool lag = true;      // the image, or the joints' angles, are older than their stamp
  bool odometry =
      true;          // feet carry a kinematic body farther or less far than it reckons, and aside
  bool tone = true;  // the camera's response is not linear
  bool uniform = true;     // worn or shiny
  bool tape = true;        // its width
  bool carpet = true;      // its brightness, and stripes
  bool light = true;       // a second one of another colour
  bool brightness = true;  // of all light
  bool noise = true;       // of the camera's pixels
  bool room = true;        // walls, floor, boards and tables
  bool infrared = true;    // what the near sensor of the head makes of a distance

  double leanSdDeg = 1.5;          // of tilt and of roll: 3 deg is 95 % (facts-2005 section 2.1)
  double accelerationBias = 20.0;  // cm/s2, sd of each axis: 1.2 deg of tilt [chosen]
  // Whole plays, drawn from 0 to these. The tilt's is twice the constant of 2005's correction of
  // the neck beyond 3 deg, 1.254 deg, which "absorbs joint play" (facts-2005 section 2.2). The
  // pan's is as much larger as its rough error, 4 deg for 3 (section 2.1). The nod, the lighter
  // joint, has half of the tilt's [chosen].
  double tiltPlayDeg = 2.5;
  double panPlayDeg = 3.3;
  double nodPlayDeg = 1.25;
  // Of the nominal 192 px. The 2005 team's distances alone speak for 201.5 px, 4.9 % more
  // (data/distance).
  double focalShare = 0.04;
  double globalShutter = 0.25;  // share of the robots [chosen]
  // Of the frame, for the others [chosen]; the nominal read-out takes all of it (facts-2005 section
  // 2.1).
  double shortestReadout = 0.5;
  // OPEN-R stamps an image with a frame number in the same count as joints (openr.md section 5.3),
  // but does not say of what moment: a camera that stamps the delivery of what was exposed in the
  // frame before looks the same. Share of such robots [chosen], and what their images are old at
  // most. Joints are as old in a quarter of the robots: no source tells of either beyond one frame.
  double lagging = 0.5;
  double mostLag = 2.0;  // frames
  double jointsLagging = 0.25;
  // Of the way that a kinematic body goes, ahead, aside and in a turn, and what it turns besides in
  // a frame in which it walks [chosen]: carpets differ more than 2005's calibrations of one walk
  // (facts-2005 section 6.3). Physical bodies have their friction (physics).
  double strideShare = 0.25;
  double turnBiasDeg = 0.3;
  // A robot's linear shift is within the nominal world (ColourShift). Exponents of Y, and of Cr and
  // Cb about grey, differ from 1 by up to these [chosen]: middle grey by 12 levels, a full colour
  // by 4.
  double toneY = 0.14;
  double toneChroma = 0.08;
  double fade = 0.4;           // at most: red's Cr is 138 to 190 in labelled pixels (data/colour)
  double scuffs = 1.5;         // of a face, mean at most [chosen]
  double glossiest = 1.8;      // from 0 to this [chosen]
  double narrowestTape = 2.5;  // cm; the rules' own
  double widestTape = 5.0;     // cm; the tape that is sold
  // Over the table's mean of 77 (facts-2005 section 3): two genuine frames have 55 and 57, labelled
  // pixels up to 100 (data/frames-ers7, data/colour).
  double darkestCarpet = 0.7;
  double brightestCarpet = 1.3;
  double stripeContrast = 0.08;  // at most [chosen]
  double lightStrength = 0.2;    // at most [chosen]
  // All light over the nominal one [chosen]: a hall that is not lit for the league, and one whose
  // camera is set too bright.
  double darkest = 0.5;
  double brightest = 1.5;
  double noisiest = 10.0;  // levels, sd, from 0 to this [chosen]
  // Levels at most [chosen]; two robots differ by up to 13.6 at once (facts-2005 section 3).
  double lightWarmth = 10.0;
  // Thesis 2006 section 6.4.4: NUbots' robots read 20 to 25 cm of the same carpet. Both together
  // make that of 22.5 cm [chosen how much each].
  double noseGain = 0.07;   // from 1, at most
  double noseOffset = 0.9;  // cm at most
};

// What the near infrared sensor of a head makes of a distance, but for its noise. The thesis tells
// of no other sensor that robots differ in it.
struct NoseSensor {
  double gain = 1.0;
  double offset = 0.0;  // cm

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("gain", &NoseSensor::gain, "", 0.5, 2),
                     field("offset", &NoseSensor::offset, "cm", -10, 10));
  }
};

// What a kinematic body's feet make of the way that they walk.
struct Stride {
  double share = 1.0;
  Angle turn;  // besides, to the left, in a frame of a walk

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("share", &Stride::share, "", 0.1, 3),
                     field("turn", &Stride::turn, "rad", -10, 10));
  }
};

// What of a robot's body the walk engine does not know.
struct BodyFaults {
  Lean lean;
  NeckPlay play;
  std::array<double, 3> accelerationBias{};  // forward, left, up
  Stride stride;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("lean", &BodyFaults::lean), field("play", &BodyFaults::play),
                     field("accelerationBias", &BodyFaults::accelerationBias, "cm/s2", -981, 981),
                     field("stride", &BodyFaults::stride));
  }
};

struct RandomisedRobot {
  BodyFaults body;
  std::uint64_t physics = 0;  // seed of a varied physical robot; 0: the standard one
  Lens lens;
  double readout = 1.0;                       // share of the frame; 0: global
  double lag = 0.0;                           // frames that images are old
  double jointsLag = 0.0;                     // frames that the angles of joints are old
  double noise = 0.0;                         // as RobotCamera has it
  std::array<double, 3> tone{1.0, 1.0, 1.0};  // as RobotCamera has it
  Uniform uniform;
  NoseSensor nose;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("body", &RandomisedRobot::body), field("physics", &RandomisedRobot::physics),
        field("lens", &RandomisedRobot::lens),
        field("readout", &RandomisedRobot::readout, "", 0, 1),
        field("lag", &RandomisedRobot::lag, "", 0, 2),
        field("jointsLag", &RandomisedRobot::jointsLag, "", 0, 2),
        field("noise", &RandomisedRobot::noise, "levels", 0, 30),
        field("tone", &RandomisedRobot::tone, "", 0.5, 2),
        field("uniform", &RandomisedRobot::uniform), field("nose", &RandomisedRobot::nose));
  }
};

// All that was drawn for a match: truth, for logs and experiments, never for an agent.
struct RandomisedWorld {
  FixedVector<RandomisedRobot, kMaxRobots> robots;
  Venue venue;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("robots", &RandomisedWorld::robots),
                     field("venue", &RandomisedWorld::venue));
  }
};

// `match`: the seed of the match or trial; each has a randomised world of its own.
RandomisedRobot drawRandomisedRobot(const RandomisationParams& params, std::uint64_t match,
                                    std::size_t robot);
Venue drawRandomisedVenue(const RandomisationParams& params, std::uint64_t match);
RandomisedWorld drawRandomised(const RandomisationParams& params, std::uint64_t match,
                               std::size_t robots);

// The kinds by name, as for --randomise-only.
std::vector<std::string> randomisedKinds();
// That seed with only these kinds; with all if none is named. Names must be known.
RandomisationParams randomisationParams(std::uint64_t seed, const std::vector<std::string>& only);

}  // namespace kelpie::sim

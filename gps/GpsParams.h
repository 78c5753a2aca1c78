// SPDX-License-Identifier: Apache-2.0
// All that can be tuned in the localiser.
#pragma once

#include "gps/ball/BallFilterParams.h"
#include "gps/camera/FocalParams.h"
#include "gps/camera/LagParams.h"
#include "gps/camera/TiltParams.h"
#include "gps/lines/LinesParams.h"
#include "gps/pinks/PinkMapParams.h"
#include "gps/players/PlayersParams.h"
#include "gps/pose/Crossing.h"
#include "gps/pose/LandmarkOffsets.h"
#include "gps/pose/NoiseScale.h"
#include "gps/pose/OdometryErrorsParams.h"
#include "gps/pose/PoseParams.h"
#include "gps/pose/Return.h"
#include "gps/pose/Shake.h"
#include "gps/pose/StuckParams.h"
#include "robot/body/FieldDescription.h"

namespace kelpie::gps {

struct GpsParams {
  body::FieldDescription field;  // the agent's (AgentConfig::field), so it is not in the list
  InitialPose initialPose;
  MotionNoise motion;
  OdometryErrorsParams odometryErrors;
  StuckParams stuck;
  ShakeParams shake;
  ReturnParams afterPenalty;
  LandmarkGates gates;
  ModeParams modes;
  CrossingParams crossing;
  LandmarkOffsetParams landmarkOffsets;
  NoiseScaleParams noiseScale;
  TiltParams tilt;
  FocalParams focal;
  LagParams lag;
  LinesParams lines;
  PinkMapParams pinks;
  BallFilterParams ball;
  PlayersParams players;

  template <int = 0>
  static constexpr auto fields() {
    using kelpie::field;
    return fieldList(
        field("initialPose", &GpsParams::initialPose), field("motion", &GpsParams::motion),
        field("odometryErrors", &GpsParams::odometryErrors), field("stuck", &GpsParams::stuck),
        field("shake", &GpsParams::shake), field("afterPenalty", &GpsParams::afterPenalty),
        field("gates", &GpsParams::gates), field("modes", &GpsParams::modes),
        field("crossing", &GpsParams::crossing),
        field("landmarkOffsets", &GpsParams::landmarkOffsets),
        field("noiseScale", &GpsParams::noiseScale), field("tilt", &GpsParams::tilt),
        field("focal", &GpsParams::focal), field("lag", &GpsParams::lag),
        field("lines", &GpsParams::lines), field("pinks", &GpsParams::pinks),
        field("ball", &GpsParams::ball), field("players", &GpsParams::players));
  }
};

}  // namespace kelpie::gps

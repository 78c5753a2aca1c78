// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/body/BodyModel.h"

#include <cmath>
#include <cstring>

namespace kelpie::calibrate {
namespace {

constexpr double kDegree = maths::kPi / 180.0;
constexpr std::array<Joint, 3> kHead = {Joint::neckTilt, Joint::headPan, Joint::headNod};

}  // namespace

// Tilts of 95 % of the robots are within 3 deg (facts-2005 section 2.1), and the neck's play adds
// to them. The focal length is within 4 % as in RandomisationParams. The others are chosen so that
// an ERS-7's drawing is right for two thirds of the robots.
const std::array<UnknownKind, kUnknowns> kUnknownKinds{{{"lens.focalLength", "px", 8.0, 0.05},
                                                        {"lens.principalX", "px", 2.0, 0.05},
                                                        {"lens.principalY", "px", 2.0, 0.05},
                                                        {"lens.edgeTerm", "", 0.03, 1e-3},
                                                        {"neckTiltOffset", "deg", 2.0, 0.01},
                                                        {"headPanOffset", "deg", 2.0, 0.01},
                                                        {"headNodOffset", "deg", 1.0, 0.01},
                                                        {"bodyRollOffset", "deg", 1.5, 0.01},
                                                        {"cameraRollOffset", "deg", 0.7, 0.01},
                                                        {"neckGives", "", 0.05, 1e-4},
                                                        {"play of the pan", "deg", 2.0, 0.01},
                                                        {"height", "cm", 0.3, 0.01},
                                                        {"spread of edges", "px", 0.5, 0.01},
                                                        {"spread of carpet", "px", 0.5, 0.01},
                                                        {"x", "cm", 0.0, 0.05},
                                                        {"y", "cm", 0.0, 0.05},
                                                        {"heading", "deg", 0.0, 0.01}}};

double inUnit(Unknown unknown) {
  return std::strcmp(kUnknownKinds[unknown].unit, "deg") == 0 ? 1.0 / kDegree : 1.0;
}

Numbers valuesOf(const body::BodyParams& p) {
  Numbers values(kUnknowns, 0.0);
  values[kFocalLength] = p.lens.focalLength;
  values[kPrincipalX] = p.lens.principalX;
  values[kPrincipalY] = p.lens.principalY;
  values[kEdgeTerm] = p.lens.edgeTerm;
  values[kNeckTilt] = p.neckTiltOffset.rad();
  values[kHeadPan] = p.headPanOffset.rad();
  values[kHeadNod] = p.headNodOffset.rad();
  values[kBodyRoll] = p.bodyRollOffset.rad();
  values[kCameraRoll] = p.cameraRollOffset.rad();
  values[kNeckGives] = p.neckGives;
  return values;
}

body::BodyParams paramsWith(const body::BodyParams& base, const Numbers& values) {
  body::BodyParams p = base;
  p.lens.focalLength = values[kFocalLength];
  p.lens.principalX = values[kPrincipalX];
  p.lens.principalY = values[kPrincipalY];
  p.lens.edgeTerm = values[kEdgeTerm];
  p.neckTiltOffset = Angle::rad(values[kNeckTilt]);
  p.headPanOffset = Angle::rad(values[kHeadPan]);
  p.headNodOffset = Angle::rad(values[kHeadNod]);
  p.bodyRollOffset = Angle::rad(values[kBodyRoll]);
  p.cameraRollOffset = Angle::rad(values[kCameraRoll]);
  p.neckGives = values[kNeckGives];
  return p;
}

Pose2 placeOf(const Numbers& values) {
  return {{values[kPlaceX], values[kPlaceY]}, Angle::rad(values[kHeading])};
}

std::vector<double> panSlack(const std::vector<double>& pans, double play) {
  constexpr double kNoise =
      0.01;  // rad; sensed angles of a resting joint spread by a quarter of it
  std::vector<double> slack(pans.size(), 0.0);
  double motor = pans.empty() ? 0.0 : pans[0];
  double now = 0.0;
  const double half = 0.5 * std::fabs(play);
  for (std::size_t i = 0; i < pans.size(); ++i) {
    const double moved = pans[i] - motor;
    if (std::fabs(moved) > kNoise) {
      now = maths::clamp(now - moved, -half, half);
      motor = pans[i];
    }
    slack[i] = play < 0.0 ? -now : now;
  }
  return slack;
}

BodyModel::BodyModel(const StandingLog& log, const body::BodyParams& base)
    : pans_(log.pans), base_(base) {
  for (const StandingFrame& frame : log.frames) {
    JointAngles joints = frame.input.sensors.joints;
    for (std::size_t i = 0; i < kHead.size(); ++i) joints[kHead[i]] = Angle::rad(frame.head[i]);
    postures_.push_back({joints, frame.input.stance, frame.pan});
  }
}

std::vector<CameraPose> BodyModel::cameras(const Numbers& values) const {
  const body::BodyParams params = paramsWith(base_, values);
  const std::vector<double> slack = panSlack(pans_, values[kPanPlay]);
  const auto blind = std::make_unique<FrameInput>();
  std::vector<CameraPose> cameras;
  cameras.reserve(postures_.size());
  for (const Posture& posture : postures_) {
    blind->sensors.joints = posture.joints;
    Angle& pan = blind->sensors.joints[Joint::headPan];
    pan = pan + Angle::rad(slack[posture.pan]);
    blind->stance = posture.stance;
    blind->stance.shoulderHeight += values[kHeight];
    cameras.push_back(body::step(*blind, params).camera);
  }
  return cameras;
}

}  // namespace kelpie::calibrate

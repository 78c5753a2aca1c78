// SPDX-License-Identifier: Apache-2.0
// What `kelpie calibrate body` does not know, and where a thing on the field is seen if it were so:
// the unknowns of BodyParams, what else moves the pixels (play of the pan, height of the body,
// colours that run over an edge), and the robot's place.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "robot/body/Camera.h"
#include "robot/core/types/FrameInput.h"
#include "tools/calibrate/RobustFit.h"
#include "tools/calibrate/body/StandingLog.h"

namespace kelpie::calibrate {

// In the order of their values. Neck and body tilt turn the camera about the same axis, so that
// both are in neckTilt.
enum Unknown : std::size_t {
  kFocalLength,
  kPrincipalX,
  kPrincipalY,
  kEdgeTerm,
  kNeckTilt,
  kHeadPan,
  kHeadNod,
  kBodyRoll,
  kCameraRoll,
  kNeckGives,
  kBodyUnknowns,             // those above are BodyParams'
  kPanPlay = kBodyUnknowns,  // rad, the whole dead zone
  kHeight,                   // cm, of the body above what its stance says
  kSpread,                   // px, by which a beacon's ends are seen too far out
  kCarpetSpread,             // px, by which the carpet's end is
  kPlaceX,                   // cm, of the robot frame on the field
  kPlaceY,
  kHeading,  // rad
  kUnknowns
};

struct UnknownKind {
  const char* name;  // of BodyParams: the key in a file of parameters
  const char* unit;  // as there; "deg" is kept in rad
  double priorSd;    // how much robots differ, in the unit; 0: not known
  double step;       // for the derivative, in the unit
};
extern const std::array<UnknownKind, kUnknowns> kUnknownKinds;

// How many of the unit a kept value of 1 is.
double inUnit(Unknown unknown);

Numbers valuesOf(const body::BodyParams& params);
body::BodyParams paramsWith(const body::BodyParams& base, const Numbers& values);
Pose2 placeOf(const Numbers& values);

// What the camera's pose depends on in one frame.
struct Posture {
  JointAngles joints;
  Stance stance;
  std::size_t pan = 0;  // StandingFrame::pan
};

// How far the head is from where its motor is, for each of the sensed pans: it is carried at the
// ends of the dead zone only. Of a negative play, for derivatives at 0, the opposite.
std::vector<double> panSlack(const std::vector<double>& pans, double play);

// Cameras of many postures for given values.
class BodyModel {
 public:
  BodyModel(const StandingLog& log, const body::BodyParams& base);

  std::vector<CameraPose> cameras(const Numbers& values) const;

 private:
  std::vector<Posture> postures_;
  std::vector<double> pans_;
  body::BodyParams base_;
};

}  // namespace kelpie::calibrate

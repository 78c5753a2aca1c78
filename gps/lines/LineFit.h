// SPDX-License-Identifier: Apache-2.0
// The pose at which the seen line points lie best on the painted lines. The overall match of thesis
// 2004 (equations 3.2 and 3.13) is a weighted mean of 1 / (1 + S d2); its maximum is sought by
// reweighted Gauss-Newton steps on the distances, damped (Levenberg-Marquardt), which needs a
// quarter of the evaluations of the thesis' gradient ascent. Finds the maximum near the start:
// within about 20 cm and 10 deg the right one in 9 of 10 views. All points of a frame are laid on
// the ground with one tilt of the camera, so that they lie wrong together: tilt and roll are
// unknowns of the fit, and the pose's information is what is left for any tilt as likely.
#pragma once

#include "gps/Gaussian.h"
#include "gps/lines/FieldFeatures.h"
#include "gps/lines/LineUpdateParams.h"
#include "robot/core/ScratchVector.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::gps {

constexpr std::size_t kMaxLinePoints = 128;

struct SeenPoint {
  Point2<Robot> place;
  double weight = 0.0;
  bool border = false;  // at the foot of the white border, not on a painted line
};
struct SeenLines {
  ScratchVector<SeenPoint, kMaxLinePoints> lines;  // and the foot of the border
  ScratchVector<SeenPoint, 16> carpet;  // green; only says that the robot is near the field
  double newEvidenceShare = 1.0;        // what no update has used before
  double noiseScale = 1.0;              // of the variances
  double shaking = 0.0;                 // of the body, as Shake.h has it
  double headSpeed = 0.0;               // rad a frame, while they were seen
  double lateVariance = 0.0;            // rad2, of the heading, by the lag that is not known
  // The camera, and the tilt with which the points were laid on the ground.
  Point3<Robot> eye{0.0, 8.0, 20.0};
  CameraTilt readWith;
};

// Whether the index is one of `max` that are spread evenly over `count`.
inline bool isSpread(std::size_t index, std::size_t count, std::size_t max) {
  return count <= max || (index + 1) * max / count != index * max / count;
}

// Lines and border evenly thinned to `maxPoints` each; points that are not finite or have no weight
// are left out.
SeenLines seenLines(const FixedVector<LinePoint, 256>& points, const LineUpdateParams& params);

struct LineFit {
  Pose2 pose;
  double match = 0.0;       // 0 to 1, thesis 2004 equations 3.13 to 3.15
  Matrix3 information;      // 1/cm2, 1/(cm rad), 1/rad2: curvature over the points' variance
  std::uint32_t steps = 0;  // evaluations
  // Of a fit with a tilt of its own. The information of the pose is then what is left of it for any
  // tilt that is as likely as it was before.
  CameraTilt tilt;
  Matrix5 jointInformation;  // of the points alone
  Vector2 tiltPull;          // by which the points would move the tilt farther, 1/rad
};

// The match at a pose, without moving.
double lineMatch(const SeenLines& seen, const Pose2& pose, const FieldFeatures& field,
                 const LineUpdateParams& params);
// `fromFar`: first with a blunter match, which leads from 40 cm and 20 deg where the true one does
// not.
LineFit fitLines(const SeenLines& seen, const Pose2& start, const FieldFeatures& field,
                 const LineUpdateParams& params, bool fromFar = false);

// The same where the camera's tilt is only known so well: all points of a frame were laid on the
// ground with one wrong tilt and roll, so these are fitted with the pose.
LineFit fitLinesAndTilt(const SeenLines& seen, const Pose2& start, const CameraTilt& known,
                        const FieldFeatures& field, const LineUpdateParams& params,
                        bool fromFar = false);

}  // namespace kelpie::gps

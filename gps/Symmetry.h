// SPDX-License-Identifier: Apache-2.0
// Which places of a painted field look alike, derived from the field's description: corners, Ts,
// the circle, straight pieces (thesis 2004 section 3.3.2, which lists them by hand). Where all that
// is seen lies about one of them, the robot may as well stand before any other of its kind. The
// whole field looks the same after half a turn.
#pragma once

#include "gps/LineFit.h"
#include "gps/LineMapParams.h"
#include "gps/LineState.h"

namespace kelpie::gps {

PaintedFeatures paintedFeatures(const body::FieldDescription& field);

// The pose turned by 180 deg about the middle of the field.
Pose2 twinOf(const Pose2& pose, const body::FieldDescription& field);

// The pose that sees `to` as `pose` sees `from`; the view is turned by their directions'
// difference.
Pose2 seenAlike(const Pose2& pose, const PaintedFeature& from, const PaintedFeature& to);

// An information or covariance of a pose (x, y, heading) when the field is turned.
Matrix3 turned(const Matrix3& matrix, Angle by);

// An infinite variance along a direction: nothing is known of it any more.
Matrix3 withoutAlong(const Matrix3& information, Angle direction);

// The seen point nearest to the mean of all line points, on the field; nothing without points.
Point2<Field> middlePoint(const SeenLines& seen, const Pose2& pose);

bool isInWindow(const PaintedFeature& feature, Point2<Field> point, const SymmetryParams& params);

// Poses that may look like the fitted one, with its information turned; the twin first. Each is
// worth its own match (equation 3.20), those below `minMatch` are left out; best first.
struct AlikePose {
  Pose2 pose;
  double match = 0.0;
  Matrix3 information = Matrix3::Zero();
};
constexpr std::size_t kMaxAlike = 6;
using AlikePoses = FixedVector<AlikePose, kMaxAlike>;

struct AlikeField {
  const body::FieldDescription& description;
  const FieldFeatures& features;
  const PaintedFeatures& painted;
};
AlikePoses posesAlike(const SeenLines& seen, const LineFit& fit, const AlikeField& field,
                      const LineParams& lines, const SymmetryParams& params);

}  // namespace kelpie::gps

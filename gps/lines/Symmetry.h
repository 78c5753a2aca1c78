// SPDX-License-Identifier: Apache-2.0
// Which places of a painted field look the same, derived from the field's description: corners, Ts,
// the circle, straight pieces (thesis 2004 section 3.3.2, which lists them by hand). Where all that
// is seen lies about one of them, the robot may as well stand before any other of its kind. The
// whole field looks the same after half a turn.
#pragma once

#include "gps/lines/LineFit.h"
#include "gps/lines/LineMapParams.h"
#include "gps/lines/LineState.h"

namespace kelpie::gps {

PaintedFeatures paintedFeatures(const body::FieldDescription& field);

// The pose turned by 180 deg about the middle of the field.
Pose2 twinOf(const Pose2& pose, const body::FieldDescription& field);

// The pose that sees `to` as `pose` sees `from`: moved with `from` onto `to`, turned by the
// difference of their directions.
Pose2 movedWithFeature(const Pose2& pose, const PaintedFeature& from, const PaintedFeature& to);

// An information or covariance of a pose (x, y, heading) when the field is turned.
Matrix3 turned(const Matrix3& matrix, Angle by);

// With infinite variance along a direction, about which nothing is known then.
Matrix3 withoutAlong(const Matrix3& information, Angle direction);

// The seen point nearest to the mean of all line points, on the field.
Point2<Field> middlePoint(const SeenLines& seen, const Pose2& pose);

bool isInWindow(const PaintedFeature& feature, Point2<Field> point, const SymmetryParams& params);

// Poses that the view cannot tell from the fitted one, with its information turned; the twin is
// always tried. Each has its own match (thesis 2004 equation 3.20), those below
// `LineUpdateParams::match` are left out; best first.
struct AmbiguousPose {
  Pose2 pose;
  double match = 0.0;
  Matrix3 information = Matrix3::Zero();
};
constexpr std::size_t kMaxAmbiguousPoses = 6;
constexpr double kSameCm = 5.0;  // nearer poses are one
constexpr double kSameDeg = 5.0;
using AmbiguousPoses = FixedVector<AmbiguousPose, kMaxAmbiguousPoses>;

struct PaintedField {
  const body::FieldDescription& description;
  const FieldFeatures& features;
  const PaintedFeatures& painted;
};
AmbiguousPoses ambiguousPoses(const SeenLines& seen, const LineFit& fit, const PaintedField& field,
                              const LineUpdateParams& lines, const SymmetryParams& params);

}  // namespace kelpie::gps

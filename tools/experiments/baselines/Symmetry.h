// SPDX-License-Identifier: Apache-2.0
// Which places of a painted field look the same, derived from the field's description: corners, Ts,
// the circle, straight pieces, and where there is a border its 45 deg bends and straight pieces
// (thesis 2004 section 3.3.2, which lists them by hand; the ends of lines at the border are none
// here). Where all that
// is seen lies about one of them, the robot may as well stand before any other of its kind. The
// whole field looks the same after half a turn.
#pragma once

#include "gps/lines/LineFit.h"
#include "gps/lines/PaintedField.h"

namespace kelpie::gps {

struct SymmetryParams {
  double window = 20.0;        // cm around a feature in which the seen points lie about it
  std::uint32_t maxPoses = 6;  // ambiguous poses, the best matching
  std::uint32_t points = 24;   // by which they are checked
};

enum class FeatureKind : std::uint8_t { corner, tee, circle, straight, borderBend, border };

// `direction`: a corner's or a bend's bisector, a T's stem, the line through the circle, the normal
// of a straight piece or of the border's foot. A T also gives two corners (one arm may be hidden);
// the circle and a straight piece are listed in both directions, the border, which has one side, in
// that of the field.
struct PaintedFeature {
  FeatureKind kind = FeatureKind::corner;
  Point2<Field> place;
  Angle direction;
  double half = 0.0;  // cm, of the length of a straight piece or a piece of the border
};
using PaintedFeatures = FixedVector<PaintedFeature, 80>;

PaintedFeatures paintedFeatures(const body::FieldDescription& field);

// The pose that sees `to` as `pose` sees `from`: moved with `from` onto `to`, turned by the
// difference of their directions.
Pose2 movedWithFeature(const Pose2& pose, const PaintedFeature& from, const PaintedFeature& to);

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

AmbiguousPoses ambiguousPoses(const SeenLines& seen, const LineFit& fit, const PaintedField& field,
                              const PaintedFeatures& painted, const LineUpdateParams& lines,
                              const SymmetryParams& params);

}  // namespace kelpie::gps

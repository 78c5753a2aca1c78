// SPDX-License-Identifier: Apache-2.0
// The thesis' own way to the lines (thesis 2004 sections 3.2 and 3.3), kept as a baseline: a table
// of the match value at the centre of every 2 cm cell, read by its interpolation or bilinearly, and
// the ascent along the match's gradient; for the field at home or in Lisbon (MatchGround.h). Takes
// 4 B a cell (2006 field: 0.7 MB each for lines, border and carpet) and is not used in the frame
// loop.
#pragma once

#include <vector>

#include "gps/lines/FieldFeatures.h"
#include "gps/lines/LineFit.h"
#include "tools/experiments/baselines/MatchGround.h"

namespace kelpie::gps {

enum class Interpolation : std::uint8_t { thesis, bilinear };

// How the match falls with the distance d in cm: 1 / (1 + S d2), thesis 2004 equation 3.2, or
// exp(-S d2), thesis 2004 equation 3.3, which came before and falls too quickly.
enum class MatchDecay : std::uint8_t { reciprocal, bell };

struct MatchOptions {
  MatchDecay decay = MatchDecay::reciprocal;
  double sharpness = 0.004;      // 1/cm2, S
  double outside = kSeenAtHome;  // cm of green that are seen beyond the border
};
constexpr double kBellSharpness = 0.001;  // 1/cm2, S of equation 3.3

double matchAt(double distance, const MatchOptions& options);

// Value and slope (1/cm) of a table at a place; beyond the table its border's cell counts.
struct MatchValue {
  double value = 0.0;
  double slopeX = 0.0;
  double slopeY = 0.0;
};

class MatchTable {
 public:
  static constexpr double kCell = 2.0;      // cm
  static constexpr double kMargin = 200.0;  // cm around the lines

  // `distance` in cm to the nearest feature.
  template <typename Distance>
  MatchTable(const body::FieldDescription& field, const MatchOptions& options,
             const Distance& distance)
      : columns_(static_cast<int>((field.width + 2.0 * kMargin) / kCell)),
        rows_(static_cast<int>((field.length + 2.0 * kMargin) / kCell)) {
    values_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i) {
        const double d = distance(Point2<Field>{i * kCell - kMargin, j * kCell - kMargin});
        values_.push_back(static_cast<float>(matchAt(d, options)));
      }
  }

  MatchValue at(Point2<Field> p, Interpolation interpolation) const;
  std::size_t bytes() const { return values_.size() * sizeof(float); }

 private:
  double cell(int column, int row) const;
  MatchValue thesis(double x, double y) const;
  MatchValue bilinear(double x, double y) const;

  int columns_;
  int rows_;
  std::vector<float> values_;
};

struct MatchTables {
  MatchTable lines;
  MatchTable border;
  MatchTable carpet;
  MatchTables(const body::FieldDescription& field, const FieldFeatures& features,
              const MatchOptions& options);

 private:
  MatchTables(const MatchGround& ground, const body::FieldDescription& field,
              const MatchOptions& options);
};

struct OverallMatch {
  double value = 0.0;
  Vector3 slope = Vector3::Zero();  // 1/cm, 1/cm, 1/rad
};

// Thesis 2004 equations 3.13 to 3.17: the weighted mean over line and border points, times that
// over the points on the carpet.
OverallMatch overallMatch(const SeenLines& seen, const Pose2& pose, const MatchTables& tables,
                          Interpolation interpolation);

// Section 3.3.1: along the gradient, the rate 1.2 times larger after a better pose and half after a
// worse. `headingScale` brings the heading's gradient (1/rad) to the units of the way; with the
// thesis' printed 1 the heading runs away (checklist H13).
struct AscentParams {
  double rate = 200.0;
  double exitRate = 0.2;
  double headingScale = 1e-4;
  std::uint32_t maxSteps = 50;
};
struct Ascent {
  Pose2 pose;
  double match = 0.0;
  std::uint32_t steps = 0;
};
Ascent ascend(const SeenLines& seen, const Pose2& start, const MatchTables& tables,
              const AscentParams& params);

}  // namespace kelpie::gps

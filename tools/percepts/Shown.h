// SPDX-License-Identifier: Apache-2.0
// How much of a thing an image shows, inside its border and hidden by nobody: what decides whether
// vision recognises it.
#pragma once

#include <array>

#include "robot/body/FieldDescription.h"
#include "tools/percepts/View.h"

namespace kelpie::percepts {

struct ShownBall {
  Spot centre;
  double radius = 0.0;  // px
  double along = 0.0;   // cm on the ground from the camera
  double range = 0.0;   // cm from the camera
  double share = 0.0;   // of its disc
};
// Nothing if it is behind the camera.
std::optional<ShownBall> shownBall(const View& view, Point2<Field> ball);

// The coloured upper half of a beacon.
struct ShownBands {
  PixelBox box;
  double share = 0.0;
  bool cut = false;  // by the image's border
};
ShownBands shownBands(const View& view, const body::FieldDescription& field, Point2<Field> foot);

enum class MouthColumn : std::uint8_t { free, hidden, outside };
constexpr std::size_t kMouthColumns = 41;

// A goal's mouth, from its left to its right as it is seen.
struct ShownMouth {
  std::array<MouthColumn, kMouthColumns> column{};
  std::array<PixelPoint, kMouthColumns> pixel{};  // at half the goal's height
  std::array<double, kMouthColumns> along{};      // cm from the camera
  std::size_t first = kMouthColumns;              // that shows,
  std::size_t last = 0;                           // and the last
  double share = 0.0;
};
// `middle`: of the mouth. Nothing shows of a goal that is looked at from behind.
ShownMouth shownMouth(const View& view, const body::FieldDescription& field, Point2<Field> middle);

// Pixels of its uniform that another robot shows.
double shownUniform(const View& view, const sim::BodyPlace& robot);

}  // namespace kelpie::percepts

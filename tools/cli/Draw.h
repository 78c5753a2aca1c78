// SPDX-License-Identifier: Apache-2.0
// Pictures for people: the camera image with what vision made of it, and the field from above with
// where the robot and the ball were and where the robot believes they are.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/FrameInput.h"
#include "robot/core/FrameOutput.h"

namespace kelpie::cli {

// True places from the world's log, when there is one.
struct TruePlaces {
  bool present = false;
  Pose2 robot;
  Point2<Field> ball;
};

// One moment of a match, ready to draw.
struct Moment {
  const FrameInput& input;
  const FrameOutput& output;
  TruePlaces truth;
};

// Paths so far, in field coordinates.
struct Paths {
  std::vector<Point2<Field>> robot;
  std::vector<Point2<Field>> ball;
  std::vector<Point2<Field>> belief;
};

cv::Mat drawCamera(const FrameInput& input, const FrameOutput& output, int scale);

// The field seen from above, the team's own goal at the bottom, `pixelsPerCm` to the cm.
cv::Mat drawField(const body::FieldDescription& field, TeamColour team, double pixelsPerCm);
void drawPaths(cv::Mat& picture, const body::FieldDescription& field, double pixelsPerCm,
               const Paths& paths);
void drawPlaces(cv::Mat& picture, const body::FieldDescription& field, double pixelsPerCm,
                const Moment& moment);

}  // namespace kelpie::cli

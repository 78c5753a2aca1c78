// SPDX-License-Identifier: Apache-2.0
// Pictures for people: the camera image with what vision made of it, and the field from above with
// where the robots and the ball were and where the log's own robot believes they are.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"

namespace kelpie::match {

struct TrueRobot {
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;
  bool own = false;  // the log is this robot's
  Pose2 pose;
};

// True places from the world's log, when there is one.
struct TruePlaces {
  bool present = false;
  std::vector<TrueRobot> robots;
  Point2<Field> ball;
  bool ballThere = true;  // nobody has taken it away

  const TrueRobot* own() const;  // null where the log's robot is not among them
};

// One moment of a match, ready to draw.
struct Moment {
  const FrameInput& input;
  const FrameOutput& output;
  TruePlaces truth;
  bool fresh = true;   // the image is of this moment, not one that was kept of an earlier
  bool imaged = true;  // there has been an image; a match of percepts has none
};

// Paths so far, in field coordinates.
struct Paths {
  std::vector<Point2<Field>> robot;  // the log's own
  std::vector<Point2<Field>> ball;
  std::vector<Point2<Field>> belief;
};

// Colours of marks, blue green red.
namespace ink {
inline const cv::Scalar kOrange(0, 128, 255);
inline const cv::Scalar kBlue(255, 96, 32);
inline const cv::Scalar kYellow(0, 220, 255);
inline const cv::Scalar kPink(190, 100, 255);
inline const cv::Scalar kWhite(255, 255, 255);
inline const cv::Scalar kGrey(170, 170, 170);
inline const cv::Scalar kBlack(0, 0, 0);
inline const cv::Scalar kRed(60, 60, 230);
inline const cv::Scalar kLine(0, 255, 255);  // of points, by kind
inline const cv::Scalar kBorder(255, 255, 0);
inline const cv::Scalar kField(120, 255, 120);
inline const cv::Scalar kObstacle(255, 80, 255);
inline const cv::Scalar kGap(255, 255, 160);
}  // namespace ink

const char* wordFor(LandmarkKind kind);
cv::Scalar inkFor(LandmarkKind kind);
cv::Scalar inkFor(TeamColour team);
cv::Scalar inkFor(LinePointKind kind);

// Everything that vision found, over the image.
cv::Mat drawCamera(const FrameInput& input, const FrameOutput& output, int scale);

// Lines of text from `where` downwards, each cut off where it is wider than `width` px.
constexpr int kReasonLine = 18;  // px from one to the next
void drawLines(cv::Mat& picture, const std::vector<std::string>& lines, cv::Point where, int width,
               double size, const cv::Scalar& colour);

// The field seen from above, the team's own goal at the bottom, `pixelsPerCm` to the cm.
cv::Mat drawField(const body::FieldDescription& field, TeamColour team, double pixelsPerCm);
// Where a place is on such a picture; up-field is up.
cv::Point onPicture(const body::FieldDescription& field, double pixelsPerCm, Point2<Field> p);
void drawPaths(cv::Mat& picture, const body::FieldDescription& field, double pixelsPerCm,
               const Paths& paths);
void drawPlaces(cv::Mat& picture, const body::FieldDescription& field, double pixelsPerCm,
                const Moment& moment);

}  // namespace kelpie::match

// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/show/RobotFilm.h"

#include <opencv2/imgproc.hpp>

#include "tools/cli/match/Describe.h"
#include "tools/match/Draw.h"
#include "tools/match/TraceWords.h"

namespace kelpie::cli {
namespace {

using namespace match;

constexpr int kCameraScale = 3;                           // 624 x 480
constexpr double kFieldScale = 1.0;                       // pixels per cm
constexpr int kCaption = 32;                              // px below the pictures
constexpr int kReasonsTop = kCameraScale * kImageHeight;  // below the camera's picture
constexpr int kReasonsHigh = (static_cast<int>(Trace::kCapacity) + 1) * kReasonLine - 12;
constexpr double kReasonSize = 0.45;
constexpr std::size_t kTrail = 300;  // frames of the paths that a film shows: ten seconds
const cv::Scalar kInk(235, 235, 235);

void follow(Paths& paths, const Moment& moment) {
  paths.belief.push_back(moment.output.world.pose.position);
  if (!moment.truth.present) return;
  if (const TrueRobot* own = moment.truth.own()) paths.robot.push_back(own->pose.position);
  if (moment.truth.ballThere) paths.ball.push_back(moment.truth.ball);
}

// Drops all but the last of each path: a film that drew whole paths took longer with every frame,
// 45 ms on average over four minutes.
void cutToTrail(Paths& paths) {
  for (auto* path : {&paths.robot, &paths.ball, &paths.belief})
    if (path->size() > kTrail)
      path->erase(path->begin(), path->end() - static_cast<std::ptrdiff_t>(kTrail));
}

void write(cv::Mat& picture, const std::string& text, cv::Point where) {
  cv::putText(picture, text, where, cv::FONT_HERSHEY_SIMPLEX, 0.5, kInk, 1, cv::LINE_AA);
}

// Pastes `part` at a place of the canvas, cut to what fits.
void paste(cv::Mat& canvas, const cv::Mat& part, int x, int y) {
  const int width = std::min(part.cols, canvas.cols - x);
  const int height = std::min(part.rows, canvas.rows - y);
  part(cv::Rect(0, 0, width, height)).copyTo(canvas(cv::Rect(x, y, width, height)));
}

int even(int n) { return n + n % 2; }  // H.264 wants even sizes

}  // namespace

RobotFilm::RobotFilm(const match::Match& match)
    : field_(match.field()), ground_(drawField(match.field(), match.team(), kFieldScale)) {
  const int width = kCameraScale * kImageWidth + ground_.cols;
  const int height = std::max(kReasonsTop + kReasonsHigh, ground_.rows) + kCaption;
  canvas_ = cv::Mat(even(height), even(width), CV_8UC3, cv::Scalar(30, 30, 30));
}

const cv::Mat& RobotFilm::frame(const Moment& moment) {
  follow(paths_, moment);
  cutToTrail(paths_);
  canvas_.setTo(cv::Scalar(30, 30, 30));
  paste(canvas_, drawCamera(moment.input, moment.output, kCameraScale), 0, 0);
  cv::Mat ground = ground_.clone();
  drawPaths(ground, field_, kFieldScale, paths_);
  drawPlaces(ground, field_, kFieldScale, moment);
  paste(canvas_, ground, kCameraScale * kImageWidth, 0);
  drawLines(canvas_, reasonLines(moment.input.drive.present, moment.output.command),
            {8, kReasonsTop + kReasonLine}, kCameraScale * kImageWidth - 16, kReasonSize, kInk);
  write(canvas_, describe(moment.input, moment.output), {8, canvas_.rows - 10});
  return canvas_;
}

}  // namespace kelpie::cli

// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/show/Film.h"

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/match/Describe.h"
#include "tools/match/Draw.h"
#include "tools/match/Match.h"
#include "tools/match/TraceWords.h"
#include "tools/picture/FileNames.h"
#include "tools/picture/FilmFile.h"
#include "tools/picture/PngFile.h"

namespace kelpie::cli {
namespace {

using namespace match;

namespace fs = std::filesystem;

constexpr int kCameraScale = 3;      // 624 x 480
constexpr double kFieldScale = 1.0;  // pixels per cm
constexpr int kFilmRate = 30;        // frames a second
constexpr int kCaption = 32;         // px below the pictures
constexpr int kTileText = 46;        // px below a camera's picture: belief, decisions, reason
constexpr int kReasonsTop = kCameraScale * kImageHeight;  // below the camera's picture
constexpr int kReasonsHigh = (static_cast<int>(Trace::kCapacity) + 1) * kReasonLine - 12;
constexpr double kReasonSize = 0.45;
constexpr std::size_t kTrail = 300;     // frames of the paths that a film shows: ten seconds
constexpr int kPictureFrames = 6;       // camera frames in the picture
constexpr int kPictureCameraScale = 2;  // 416 x 320
constexpr double kPictureFieldScale = 1.5;
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

// Draws the frames of a film.
class FilmFrames {
 public:
  explicit FilmFrames(const Match& match)
      : field_(match.field()), ground_(drawField(match.field(), match.team(), kFieldScale)) {
    const int width = kCameraScale * kImageWidth + ground_.cols;
    const int height = std::max(kReasonsTop + kReasonsHigh, ground_.rows) + kCaption;
    canvas_ = cv::Mat(even(height), even(width), CV_8UC3, cv::Scalar(30, 30, 30));
  }
  cv::Size size() const { return canvas_.size(); }

  const cv::Mat& next(const Moment& moment) {
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

 private:
  body::FieldDescription field_;
  cv::Mat ground_;
  cv::Mat canvas_;
  Paths paths_;
};

// Name for the unfinished file; keeps the ending, which tells the container.
std::string partName(const std::string& out) {
  const fs::path path(out);
  return (path.parent_path() / (path.stem().string() + ".part" + path.extension().string()))
      .string();
}

// The frames shown in the picture: evenly spread, the first and the last whole one included.
bool isShown(std::size_t frame, std::size_t all) {
  if (all <= kPictureFrames) return true;
  for (std::size_t k = 0; k < kPictureFrames; ++k)
    if (frame == k * (all - 1) / (kPictureFrames - 1)) return true;
  return false;
}

cv::Mat arrange(const cv::Mat& ground, const std::vector<cv::Mat>& frames) {
  const int tileWidth = kPictureCameraScale * kImageWidth;
  const int tileHeight = kPictureCameraScale * kImageHeight + kTileText;
  const int height = std::max(ground.rows, 3 * tileHeight) + kCaption;
  cv::Mat canvas(height, ground.cols + 2 * tileWidth + 16, CV_8UC3, cv::Scalar(30, 30, 30));
  paste(canvas, ground, 0, 0);
  for (std::size_t i = 0; i < frames.size(); ++i)
    paste(canvas, frames[i], ground.cols + 8 + static_cast<int>(i % 2) * (tileWidth + 8),
          static_cast<int>(i / 2) * tileHeight);
  write(canvas,
        "white: robot   red, blue: others   orange: ball   pink: where the robot believed it was",
        {8, height - 10});
  return canvas;
}

cv::Mat tile(const Moment& moment) {
  const cv::Mat camera = drawCamera(moment.input, moment.output, kPictureCameraScale);
  cv::Mat result(camera.rows + kTileText, camera.cols, CV_8UC3, cv::Scalar(30, 30, 30));
  paste(result, camera, 0, 0);
  const auto line = [&](const std::string& text, int below) {
    cv::putText(result, text, {2, camera.rows + below}, cv::FONT_HERSHEY_SIMPLEX, 0.35, kInk, 1,
                cv::LINE_AA);
  };
  line(describe(moment.input, moment.output), 13);
  // Who decided what, and the reason of the last in the chain.
  const Trace& trace = moment.output.command.trace;
  if (!trace.empty()) {
    line(chainOf(trace), 26);
    line(reasonOf(trace.back()), 39);
  }
  return result;
}

Status writeFilm(const Match& match, const std::string& part) {
  FilmFrames frames(match);
  auto film = picture::FilmFile::create(part, frames.size(), kFilmRate);
  if (!film) return Error{film.error()};
  Progress progress("film", "frames");
  std::size_t done = 0;
  Status status = Done{};
  match.forEachMoment([&](const Moment& moment) {
    status = interrupted() ? Status(Error{"interrupted"}) : film->add(frames.next(moment));
    progress(++done, match.frames());
    return status.ok();
  });
  if (!status) return status;
  return film->close();
}

}  // namespace

Status filmMatch(const match::Match& match, const std::string& out) {
  const std::string part = partName(out);
  const Status written = writeFilm(match, part);
  return putInPlace(written ? written : Status(Error{out + ": " + written.error()}), part, out);
}

Status drawMatchPicture(const match::Match& match, const std::string& out) {
  const auto& field = match.field();
  cv::Mat ground = drawField(field, match.team(), kPictureFieldScale);
  Paths paths;
  std::vector<cv::Mat> frames;
  std::size_t number = 0;
  Progress progress("picture", "frames");
  match.forEachMoment([&](const Moment& moment) {
    follow(paths, moment);
    if (isShown(number++, match.frames())) frames.push_back(tile(moment));
    if (number == match.frames()) {
      drawPaths(ground, field, kPictureFieldScale, paths);
      drawPlaces(ground, field, kPictureFieldScale, moment);
    }
    progress(number, match.frames());
    return true;
  });
  return picture::writePng(out, arrange(ground, frames));
}

namespace {

struct FilmOptions {
  std::string log;
  std::string out;
};

int film(const FilmOptions& options) {
  if (isDevice(options.out)) return fail(options.out + ": not a plain file", kExitBadInput);
  if (sameFile(options.log, options.out))
    return fail(options.out + ": is the log itself", kExitBadInput);
  if (picture::endingOf(options.out) != ".mp4")
    return fail(options.out + ": a film is an .mp4 file", kExitBadInput);
  catchInterrupts();
  const auto match = Match::open(options.log);
  if (!match) return fail(match.error(), kExitBadInput);
  const Status made = filmMatch(*match, options.out);
  if (!made) return fail(made.error(), kExitBadInput);
  return match->lacks().empty() ? kExitDone : fail(match->lacks(), kExitBadInput);
}

}  // namespace

void addFilm(CommandLine& app, int& code) {
  auto command = app.subcommand("film", "A film: camera with overlays beside the field");
  auto options = std::make_shared<FilmOptions>();
  command.option("LOG", options->log, "The log").required();
  command.option("OUT", options->out, "The film, for example match.mp4").required();
  command.callback([options, &code] { code = film(*options); });
}

}  // namespace kelpie::cli

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
#include "tools/match/drawing/MatchPicture.h"
#include "tools/picture/FileNames.h"
#include "tools/picture/FilmFile.h"
#include "tools/picture/PngFile.h"

namespace kelpie::cli {
namespace {

using namespace match;

namespace fs = std::filesystem;

constexpr int kCameraScale = 3;                           // 624 x 480
constexpr double kFieldScale = 1.0;                       // pixels per cm
constexpr int kFilmRate = 30;                             // frames a second
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
  Progress progress("picture", "frames");
  const auto drawn =
      match::drawMatch(match, [&](std::size_t done, std::size_t all) { progress(done, all); });
  if (!drawn) return Error{out + ": " + drawn.error()};
  return picture::writePng(out, *drawn);
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
  const std::string ending = picture::endingOf(options.out);
  if (ending != ".mp4" && ending != ".png")
    return fail(options.out + ": a film is an .mp4 file, a picture a .png file", kExitBadInput);
  catchInterrupts();
  const auto match = Match::open(options.log);
  if (!match) return fail(match.error(), kExitBadInput);
  const Status made = ending == ".png" ? drawMatchPicture(*match, options.out)
                                       : filmMatch(*match, options.out);
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

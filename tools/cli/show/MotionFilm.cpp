// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/show/MotionFilm.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/show/BodyDrawing.h"
#include "tools/picture/FilmFile.h"
#include "tools/picture/PngFile.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;
using learn::MotionCourse;
using learn::MotionMoment;

constexpr int kFilmRate = 30;       // pictures a second
constexpr double kFilmScale = 9.0;  // pixels a cm
constexpr double kStripScale = 4.0;
constexpr int kAcross = 4;          // moments in a row of the strip
constexpr int kCaption = 26;        // px below the views
constexpr int kGap = 6;             // px between moments
constexpr std::size_t kLater = 30;  // ticks after the last key frame
const cv::Scalar kPaper(30, 30, 30);
const cv::Scalar kInk(235, 235, 235);

void write(cv::Mat& picture, const std::string& text, int x, int y, double size) {
  cv::putText(picture, text, {x, y}, cv::FONT_HERSHEY_SIMPLEX, size, kInk, 1, cv::LINE_AA);
}

cv::Mat captioned(const MotionCourse& course, const MotionMoment& moment, double scale,
                  const std::string& text) {
  const cv::Mat views = drawBodies(moment.shapes, course.start, scale);
  cv::Mat picture(views.rows + kCaption, views.cols, CV_8UC3, kPaper);
  views.copyTo(picture(cv::Rect(0, 0, views.cols, views.rows)));
  write(picture, text, 6, picture.rows - 8, 0.48);
  return picture;
}

cv::Mat evenSize(const cv::Mat& picture) {  // H.264 wants it
  cv::Mat even;
  cv::copyMakeBorder(picture, even, 0, picture.rows % 2, 0, picture.cols % 2, cv::BORDER_CONSTANT,
                     kPaper);
  return even;
}

cv::Mat filmPicture(const MotionCourse& course, const MotionMoment& moment,
                    const std::string& name) {
  return evenSize(captioned(course, moment, kFilmScale,
                            fmt::format("{}   {:.2f} s   {} times slower; from its right side and "
                                        "from above",
                                        name, moment.seconds, kSlower)));
}

// The unfinished film; keeps the ending, which tells the container.
std::string partName(const std::string& out) {
  const fs::path path(out);
  return path.parent_path() / (path.stem().string() + ".part" + path.extension().string());
}

Status writeFilm(const MotionCourse& course, const std::string& name, const std::string& part) {
  const cv::Mat first = filmPicture(course, course.moments.front(), name);
  auto film = picture::FilmFile::create(part, first.size(), kFilmRate);
  if (!film) return Error{film.error()};
  Progress progress("film", "pictures");
  for (std::size_t i = 0; i < course.moments.size(); ++i) {
    if (interrupted()) return Error{"interrupted"};
    const Status added = film->add(filmPicture(course, course.moments[i], name));
    if (!added) return added;
    progress(i + 1, course.moments.size());
  }
  return film->close();
}

struct KeyMoment {
  std::size_t tick;
  std::string text;
};

std::vector<KeyMoment> keyMoments(const actuator::MotionData& motion, std::size_t all) {
  std::size_t tick = learn::kTicksUntilPlayed;
  std::vector<KeyMoment> moments{{tick, "before"}};
  for (std::size_t i = 0; i < motion.frames.size(); ++i) {
    tick += motion.frames[i].ticks;
    moments.push_back(
        {tick, fmt::format("end of key frame {} of {}", i + 1, motion.frames.size())});
  }
  moments.push_back({tick + kLater, fmt::format("{:.2f} s later", kLater * kTickSeconds)});
  moments.push_back({all, "at the end"});
  for (KeyMoment& moment : moments) moment.tick = std::clamp<std::size_t>(moment.tick, 1, all) - 1;
  return moments;
}

}  // namespace

Status filmMotion(const MotionCourse& course, const std::string& name, const std::string& out) {
  if (course.moments.empty()) return Error{out + ": there is nothing to film"};
  const std::string part = partName(out);
  const Status written = writeFilm(course, name, part);
  return putInPlace(written ? written : Status(Error{out + ": " + written.error()}), part, out);
}

Status drawMotion(const MotionCourse& course, const actuator::MotionData& motion,
                  const std::string& name, const std::string& out) {
  if (course.moments.empty()) return Error{out + ": there is nothing to draw"};
  std::vector<cv::Mat> tiles;
  for (const KeyMoment& key : keyMoments(motion, course.moments.size())) {
    const MotionMoment& moment = course.moments[key.tick];
    tiles.push_back(captioned(course, moment, kStripScale,
                              fmt::format("{:.2f} s   {}", moment.seconds, key.text)));
  }
  const int count = static_cast<int>(tiles.size());
  const int wide = tiles[0].cols + kGap;
  const int high = tiles[0].rows + kGap;
  cv::Mat strip(kCaption + high * ((count + kAcross - 1) / kAcross),
                wide * std::min(count, kAcross), CV_8UC3, kPaper);
  write(strip, name + ": from its right side and from above; blue: left legs, yellow: right legs",
        6, 18, 0.5);
  for (int i = 0; i < count; ++i)
    tiles[static_cast<std::size_t>(i)].copyTo(strip(
        cv::Rect(i % kAcross * wide, kCaption + i / kAcross * high, tiles[0].cols, tiles[0].rows)));
  return picture::writePng(out, strip);
}

}  // namespace kelpie::cli

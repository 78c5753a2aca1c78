// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/show/Film.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "tools/broadcast/BroadcastFilm.h"
#include "tools/broadcast/SplitFilm.h"
#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/show/RobotFilm.h"
#include "tools/match/drawing/MatchPicture.h"
#include "tools/picture/FileNames.h"
#include "tools/picture/FilmFile.h"
#include "tools/picture/PngFile.h"

namespace kelpie::cli {
namespace {

using match::Match;
using match::Moment;

namespace fs = std::filesystem;

constexpr int kRobotRate = 30;  // frames a second

// The frames of one film, whichever view it is.
struct Frames {
  cv::Size size;
  int rate = kRobotRate;
  std::size_t every = 1;  // of the camera's frames one is shown
  std::function<Expected<cv::Mat>(const Moment&)> frame;
  std::function<Expected<cv::Mat>(const Moment&)> last;  // stays for a while; maybe none
};

// Name for the unfinished file; keeps the ending, which tells the container.
std::string partName(const std::string& out) {
  const fs::path path(out);
  return (path.parent_path() / (path.stem().string() + ".part" + path.extension().string()))
      .string();
}

Frames robotFrames(const Match& match) {
  const auto film = std::make_shared<RobotFilm>(match);
  return {film->size(),
          kRobotRate,
          1,
          [film](const Moment& moment) { return Expected<cv::Mat>(film->frame(moment)); },
          {}};
}

template <class Film>
Frames televised(Film&& made) {
  const auto film = std::make_shared<Film>(std::forward<Film>(made));
  Frames frames{Film::size(), broadcast::kFilmRate, broadcast::kEvery, {}, {}};
  frames.frame = [film](const Moment& moment) { return film->frame(moment); };
  return frames;
}

Expected<Frames> broadcastFrames(const Match& match, broadcast::Course course, double sharpness) {
  auto film = broadcast::BroadcastFilm::create(match, std::move(course), sharpness);
  if (!film) return Error{film.error()};
  const auto shared = std::make_shared<broadcast::BroadcastFilm>(std::move(*film));
  Frames frames{shared->size(), broadcast::kFilmRate, broadcast::kEvery, {}, {}};
  frames.frame = [shared](const Moment& moment) { return shared->frame(moment); };
  frames.last = [shared](const Moment& moment) { return shared->last(moment); };
  return frames;
}

Expected<Frames> framesOf(const Match& match, const FilmRequest& request,
                          std::vector<std::string>& lacks) {
  if (request.view == "robot") return robotFrames(match);
  auto read = broadcast::readCourse(request.logs, interrupted);
  if (!read) return Error{read.error()};
  lacks = read->lacks;
  const double sharpness = request.still ? broadcast::kStillSharpness : broadcast::kFilmSharpness;
  if (request.view == "broadcast")
    return broadcastFrames(match, std::move(read->course), sharpness);
  auto film = broadcast::SplitFilm::create(match, std::move(read->course), request.logs, sharpness);
  if (!film) return Error{film.error()};
  return televised(std::move(*film));
}

class Writing {
 public:
  Writing(const Frames& frames, picture::FilmFile& film, std::size_t all)
      : frames_(frames), film_(film), all_(all) {}

  bool take(const Moment& moment) {
    if (interrupted()) status = Error{"interrupted"};
    if (status.ok() && done_ % frames_.every == 0) add(frames_.frame(moment));
    progress_(++done_, all_);
    if (status.ok() && done_ == all_ && frames_.last) addLast(moment);
    return status.ok();
  }

  Status status = Done{};

 private:
  void add(const Expected<cv::Mat>& frame) {
    status = frame ? film_.add(*frame) : Status(Error{frame.error()});
  }
  void addLast(const Moment& moment) {
    const auto frame = frames_.last(moment);
    const int times = static_cast<int>(broadcast::kLastPicture * frames_.rate);
    for (int i = 0; i < times && status.ok(); ++i) add(frame);
  }

  const Frames& frames_;
  picture::FilmFile& film_;
  std::size_t all_;
  std::size_t done_ = 0;
  Progress progress_{"film", "frames"};
};

Status writeFilm(const Match& match, const FilmRequest& request, const std::string& part,
                 std::vector<std::string>& lacks) {
  const auto frames = framesOf(match, request, lacks);
  if (!frames) return Error{frames.error()};
  auto film = picture::FilmFile::create(part, frames->size, frames->rate);
  if (!film) return Error{film.error()};
  Writing writing(*frames, *film, match.frames());
  match.forEachMoment([&](const Moment& moment) { return writing.take(moment); });
  return writing.status ? film->close() : writing.status;
}

Expected<cv::Mat> drawFrameAt(const Match& match, const FilmRequest& request, double seconds) {
  std::vector<std::string> lacks;
  const auto frames = framesOf(match, request, lacks);
  if (!frames) return Error{frames.error()};
  Expected<cv::Mat> drawn = Error{fmt::format("the log ends before {:.1f} s", seconds)};
  match.forEachMoment([&](const Moment& moment) {
    if (moment.input.time.seconds() < seconds) return true;
    drawn = frames->frame(moment);
    return false;
  });
  return drawn;
}

Expected<cv::Mat> drawWholeMatch(const Match& match) {
  Progress progress("picture", "frames");
  return match::drawMatch(match, [&](std::size_t done, std::size_t all) { progress(done, all); });
}

}  // namespace

Status filmMatch(const Match& match, const FilmRequest& request, std::vector<std::string>& lacks) {
  const std::string part = partName(request.out);
  const Status written = writeFilm(match, request, part, lacks);
  return putInPlace(written ? written : Status(Error{request.out + ": " + written.error()}), part,
                    request.out);
}

Status drawMatchPicture(const Match& match, const std::string& out) {
  const auto drawn = drawWholeMatch(match);
  if (!drawn) return Error{out + ": " + drawn.error()};
  return picture::writePng(out, *drawn);
}

std::vector<std::string> logsBeside(const std::string& log) {
  std::vector<std::string> logs = {log};
  std::error_code error;
  for (const char* team : {"red", "blue"})
    for (int player = 1; player <= 4; ++player) {
      const fs::path beside = fs::path(log).parent_path() / fmt::format("{}-{}.mcap", team, player);
      if (fs::is_regular_file(beside, error) && !sameFile(beside.string(), log))
        logs.push_back(beside.string());
    }
  return logs;
}

namespace {

struct FilmOptions {
  std::vector<std::string> logs;
  std::string out;
  std::string view = "broadcast";
  double at = -1.0;  // s; below 0: the whole match
  bool small = false;
};

Status checkOut(const FilmOptions& options) {
  if (isDevice(options.out)) return Error{options.out + ": not a plain file"};
  for (const std::string& log : options.logs)
    if (sameFile(log, options.out))
      return Error{options.out +
                   (options.logs.size() == 1 ? ": is the log itself" : ": is one of the logs")};
  const std::string ending = picture::endingOf(options.out);
  if (ending != ".mp4" && ending != ".png")
    return Error{options.out + ": a film is an .mp4 file, a picture of the match a .png file"};
  return Done{};
}

int endOf(const Match& match, const std::vector<std::string>& lacks) {
  std::string all = match.lacks();
  for (const std::string& one : lacks)
    if (one != match.lacks()) all += (all.empty() ? "" : "; ") + one;
  return all.empty() ? kExitDone : fail(all, kExitBadInput);
}

Status drawStill(const Match& match, const FilmRequest& request, const FilmOptions& options) {
  const auto drawn =
      options.at < 0.0 ? drawWholeMatch(match) : drawFrameAt(match, request, options.at);
  if (!drawn) return Error{options.out + ": " + drawn.error()};
  return options.small ? picture::writeSmallPng(options.out, *drawn)
                       : picture::writePng(options.out, *drawn);
}

int film(FilmOptions& options) {
  if (options.logs.size() < 2)
    return fail("OUT is required; `kelpie film --help` tells more", kExitBadInput);
  options.out = options.logs.back();
  options.logs.pop_back();
  const Status sound = checkOut(options);
  if (!sound) return fail(sound.error(), kExitBadInput);
  catchInterrupts();
  const auto match = Match::open(options.logs.front());
  if (!match) return fail(match.error(), kExitBadInput);
  std::vector<std::string> lacks;
  const bool still = picture::endingOf(options.out) == ".png";
  const FilmRequest request{
      options.logs.size() == 1 ? logsBeside(options.logs.front()) : options.logs, options.view,
      options.out, still};
  const Status made =
      still ? drawStill(*match, request, options) : filmMatch(*match, request, lacks);
  if (!made) return fail(made.error(), interrupted() ? kExitInterrupted : kExitBadInput);
  return endOf(*match, lacks);
}

}  // namespace

void addFilm(CommandLine& app, int& code) {
  auto command = app.subcommand("film", "A film of a match, or with OUT.png one picture of it");
  auto options = std::make_shared<FilmOptions>();
  command
      .option("FILES", options->logs,
              "LOG... OUT: the log whose robot is watched, those of others, and last the film to "
              "write, as match.mp4; of one log alone also those that --logs all left beside it "
              "(red-1.mcap, ...) are read")
      .required();
  command
      .option("--view", options->view,
              "broadcast (the match in 3D as on television, beside what the robot sees and "
              "decides), robot (its camera, large, beside the field from above) or split (the "
              "cameras of all robots round the field)")
      .check(oneOf({"broadcast", "robot", "split"}))
      .showDefault();
  command.option("--at", options->at, "With OUT.png: the view at that time (s), not the match")
      .check(inRange(0.0, 1e5));
  command.flag("--small", options->small, "With OUT.png: in 256 colours, a third of the size");
  command.callback([options, &code] { code = film(*options); });
}

}  // namespace kelpie::cli

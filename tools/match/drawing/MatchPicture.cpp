// SPDX-License-Identifier: Apache-2.0
#include "tools/match/drawing/MatchPicture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "tools/match/Highlights.h"
#include "tools/match/MatchWords.h"
#include "tools/match/TraceWords.h"
#include "tools/match/drawing/CameraDrawing.h"
#include "tools/match/drawing/FieldDrawing.h"
#include "tools/match/drawing/Inks.h"

namespace kelpie::match {
namespace {

using namespace picture;

constexpr std::size_t kMoments = 6;
constexpr double kMargin = 32.0;
constexpr double kHead = 112.0;  // px of the title
constexpr double kMapWidth = 720.0;
constexpr double kTileWidth = 380.0;
constexpr double kCameraHigh = kTileWidth * kImageHeight / kImageWidth;
constexpr double kTileText = 84.0;  // px below a camera's picture
constexpr double kGap = 18.0;
constexpr int kMarks = 10;  // of the time, at most
constexpr double kTilesHigh = 3 * (kCameraHigh + kTileText) - 4.0;

// Paths of a whole match, thinned by time: more points than pixels are of no use.
struct Courses {
  TimedPath robot, ball, belief;
};

void follow(const Moment& moment, Courses& courses) {
  const double now = moment.input.time.seconds();
  courses.belief.push_back({now, moment.output.world.pose.position});
  if (!moment.truth.present) return;
  if (const TrueRobot* own = moment.truth.own()) courses.robot.push_back({now, own->pose.position});
  if (moment.truth.ballThere) courses.ball.push_back({now, moment.truth.ball});
}

// Why the robot does what it does, by who decided last; or who decided in its place.
std::string whyOf(const Moment& moment) {
  const Command& command = moment.output.command;
  std::string instead = insteadOf(moment.input.drive.present, command);
  if (!instead.empty()) {
    instead[0] = static_cast<char>(std::toupper(instead[0]));
    return instead + ".";
  }
  if (command.trace.empty()) return "It asks its body to " + requestOf(command) + ".";
  return sentenceOf(command.trace.back());
}

class Sheet {
 public:
  Sheet(Canvas& canvas, const Match& match)
      : canvas_(canvas), map_(match.field(), match.team(), kMargin, kHead, kMapWidth) {}

  void title(const MatchFacts& facts);
  void courses(const Courses& courses, const MatchFacts& facts);
  void end(const Moment& moment) { map_.places(canvas_, moment); }
  void tile(const Moment& moment, const Happening& happening, int number);
  void badges(const std::vector<Point2<Field>>& places);
  void legend();

 private:
  double name(double x, const MatchFacts& facts, TeamColour team, Align align);
  Spot corner(int number) const;
  void entry(Spot at, const std::string& words);

  Canvas& canvas_;
  FieldDrawing map_;
};

// A team's name in its colour; gives its width.
double Sheet::name(double x, const MatchFacts& facts, TeamColour team, Align align) {
  const cv::Size2d size =
      canvas_.text({x, 26.0}, nameOf(facts, team), {30.0, inks::of(team), true, align});
  return size.width;
}

void Sheet::title(const MatchFacts& facts) {
  double x = kMargin;
  x += name(x, facts, TeamColour::red, Align::left) + 18.0;
  x += canvas_.text({x, 26.0}, scoreOf(facts), {30.0, inks::kText, true}).width + 18.0;
  name(x, facts, TeamColour::blue, Align::left);
  canvas_.text({kMargin, 70.0}, subtitleOf(facts), {16.0, inks::kQuiet});
  const std::string whose =
      fmt::format("Six moments of {} {}: what it saw, what it did, and why",
                  facts.team == TeamColour::red ? "red" : "blue", facts.player);
  canvas_.text({kMargin + kMapWidth + 28.0, 70.0}, whose, {16.0, inks::kQuiet});
}

void Sheet::courses(const Courses& courses, const MatchFacts& facts) {
  map_.ground(canvas_);
  map_.attack(canvas_, "attack");
  canvas_.cut(map_.frame(), 10.0);
  const double length = facts.seconds;
  map_.ballPath(canvas_, courses.ball, {length, length});
  map_.robotPath(canvas_, courses.robot, {length, length});
  map_.belief(canvas_, courses.belief);
  const TimedPath& timed = courses.robot.empty() ? courses.belief : courses.robot;
  map_.marks(canvas_, timeMarks(timed, timeBetweenMarks(length, kMarks)));
  canvas_.uncut();
}

Spot Sheet::corner(int number) const {
  const int i = number - 1;
  return {kMargin + kMapWidth + 28.0 + (i % 2) * (kTileWidth + kGap),
          kHead + (i / 2) * (kCameraHigh + kTileText)};
}

void Sheet::tile(const Moment& moment, const Happening& happening, int number) {
  const Spot at = corner(number);
  drawCameraView(canvas_, {at.x, at.y, kTileWidth, kCameraHigh}, moment);
  drawBadge(canvas_, {at.x + 17.0, at.y + 17.0}, number);
  const std::string time = clockOf(moment.input.time.seconds());
  const Type clock{14.0, inks::kText, true};
  const double wide = canvas_.measure(time, clock).width;
  const Spot stamp{at.x + kTileWidth - wide - 16.0, at.y + 8.0};
  canvas_.box({stamp.x - 7.0, stamp.y - 3.0, wide + 14.0, 23.0}, inks::kGround.faded(0.75), 5.0);
  canvas_.text(stamp, time, clock);
  Spot below{at.x, at.y + kCameraHigh + 6.0};
  if (!happening.words.empty()) {
    const Type bold{13.0, inks::kText, true, Align::left, 2};
    below.y += canvas_.text(below, happening.words, bold, kTileWidth).height + 2.0;
  }
  canvas_.text(below, whyOf(moment), {12.5, inks::kQuiet, false, Align::left, 2}, kTileWidth);
}

void Sheet::badges(const std::vector<Point2<Field>>& places) {
  canvas_.cut(map_.frame(), 10.0);
  map_.badges(canvas_, places);
  canvas_.uncut();
}

void Sheet::entry(Spot at, const std::string& words) {
  canvas_.text({at.x + 34.0, at.y - 9.0}, words, {13.0, inks::kText});
}

void Sheet::legend() {
  const double top = map_.frame().y + map_.height() + 26.0;
  const double second = kMargin + 0.5 * kMapWidth;
  const auto row = [&](double x, int n) { return Spot{x, top + 24.0 * n}; };
  const auto stroke = [&](Spot at, const Ink& ink, double width, const std::string& words) {
    canvas_.line({{at.x, at.y}, {at.x + 24.0, at.y}}, ink, width);
    entry(at, words);
  };
  stroke(row(kMargin, 0), inks::kRobot, 3.0, "where the robot really was");
  stroke(row(kMargin, 1), inks::kBall, 2.4, "the ball, seen and real");
  const Spot dashed = row(kMargin, 2);
  canvas_.dashes({dashed, {dashed.x + 24.0, dashed.y}}, inks::kBelief, 2.0, 4.0);
  entry(dashed, "what the robot believed");
  const Spot mark = row(kMargin, 3);
  canvas_.disc({mark.x + 12.0, mark.y}, 3.0, inks::kRobot);
  entry(mark, "time marks; older paths are paler");
  stroke(row(second, 0), inks::kCarpetEdge, 1.6, "seen: the edge of the carpet");
  const Spot lines = row(second, 1);
  for (int i = 0; i < 3; ++i)
    canvas_.disc({lines.x + 4.0 + 8.0 * i, lines.y}, 2.0, inks::kLinePoint);
  entry(lines, "seen: a line of the field");
  const Spot cross = row(second, 2);
  canvas_.line({{cross.x + 8, cross.y - 4}, {cross.x + 16, cross.y + 4}}, inks::kObstacle, 1.6);
  canvas_.line({{cross.x + 8, cross.y + 4}, {cross.x + 16, cross.y - 4}}, inks::kObstacle, 1.6);
  entry(cross, "seen: an obstacle");
  const Spot box = row(second, 3);
  canvas_.outline({box.x + 4, box.y - 6, 16, 12}, inks::kPink, 1.6, 2.0);
  entry(box, "seen: goal, beacon or robot, in its colour");
}

struct Survey {
  Courses courses;
  MatchFacts facts;
  std::vector<Happening> chosen;
};

Survey surveyOf(const Match& match, const std::function<void(std::size_t)>& progress) {
  Survey survey;
  survey.facts = factsOf(match.notes(), match.team(), match.player());
  Happenings happenings(match.events());
  std::size_t done = 0;
  match.forEachMoment([&](const Moment& moment) {
    follow(moment, survey.courses);
    add(moment, survey.facts);
    happenings.take(moment);
    progress(++done);
    return true;
  });
  score(match.events(), TimeUs{std::numeric_limits<std::int64_t>::max()}, survey.facts);
  survey.chosen = chooseHighlights(happenings.all(), kMoments);
  return survey;
}

Point2<Field> placeOf(const Moment& moment) {
  const TrueRobot* own = moment.truth.own();
  return own != nullptr ? own->pose.position : moment.output.world.pose.position;
}

// Where a log keeps few images the next one after the moment is shown, if there is one soon.
bool isShown(const Moment& moment, std::size_t frame, std::size_t wanted) {
  constexpr std::size_t kPatience = 15;  // frames
  return frame >= wanted && (moment.fresh || frame >= wanted + kPatience);
}

cv::Size sizeOf(const Match& match) {
  const FieldDrawing map(match.field(), match.team(), 0.0, 0.0, kMapWidth);
  const double width = 2 * kMargin + kMapWidth + 28.0 + 2 * kTileWidth + kGap;
  const double height = kHead + std::max(kTilesHigh, map.height() + 118.0) + 24.0;
  return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace

Expected<cv::Mat> drawMatch(const Match& match,
                            const std::function<void(std::size_t, std::size_t)>& progress) {
  auto canvas = Canvas::create(sizeOf(match), inks::kGround);
  if (!canvas) return Error{canvas.error()};
  const std::size_t all = 2 * match.frames();
  const Survey survey = surveyOf(match, [&](std::size_t done) { progress(done, all); });
  Sheet sheet(*canvas, match);
  sheet.title(survey.facts);
  sheet.courses(survey.courses, survey.facts);
  sheet.legend();
  std::vector<Point2<Field>> places;
  std::size_t frame = 0;
  match.forEachMoment([&](const Moment& moment) {
    if (places.size() < survey.chosen.size() &&
        isShown(moment, frame, survey.chosen[places.size()].frame)) {
      places.push_back(placeOf(moment));
      sheet.tile(moment, survey.chosen[places.size() - 1], static_cast<int>(places.size()));
    }
    if (++frame == match.frames()) sheet.end(moment);
    progress(match.frames() + frame, all);
    return true;
  });
  sheet.badges(places);
  return canvas->picture();
}

}  // namespace kelpie::match

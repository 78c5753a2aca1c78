// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/Overlay.h"

#include <fmt/core.h>

#include <algorithm>

#include "tools/match/TraceWords.h"
#include "tools/match/drawing/Inks.h"

namespace kelpie::broadcast {
namespace {

using namespace picture;
namespace inks = match::inks;

constexpr double kBarHigh = 34.0;

// A field of the score bar; gives where the next begins.
double cell(Canvas& canvas, Spot corner, const std::string& words, const Ink& ground,
            const Type& type) {
  const double wide = canvas.measure(words, type).width + 26.0;
  canvas.box({corner.x, corner.y, wide, kBarHigh}, ground);
  const double drop = 0.5 * (kBarHigh - canvas.measure(words, type).height);
  canvas.text({corner.x + 13.0, corner.y + drop}, words, type);
  return corner.x + wide;
}

// "grab_dribble" -> "grab dribble"
std::string spoken(std::string_view name) {
  std::string words(name.substr(0, name.find(' ')));
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

class Map {
 public:
  Map(const Frame& frame, const body::FieldDescription& field)
      : frame_(frame),
        scale_(std::min((frame.width - 2 * kEdge) / field.length,
                        (frame.height - 2 * kEdge) / field.width)),
        corner_{frame.x + 0.5 * (frame.width - scale_ * field.length),
                frame.y + 0.5 * (frame.height - scale_ * field.width)} {}
  Spot at(Point2<Field> p) const { return {corner_.x + scale_ * p.y, corner_.y + scale_ * p.x}; }
  double pixels(double cm) const { return scale_ * cm; }

 private:
  static constexpr double kEdge = 14.0;
  Frame frame_;
  double scale_;
  Spot corner_;
};

void drawMapGround(Canvas& canvas, const Map& map, const body::FieldDescription& field) {
  const double half = 0.5 * field.goalWidth, middle = 0.5 * field.width;
  for (const auto& mark : field.landmarks) {
    if (mark.kind != LandmarkKind::goalBlue && mark.kind != LandmarkKind::goalYellow) continue;
    const bool far = mark.position.y > 0.5 * field.length;
    const double line = far ? field.length : -field.goalDepth;
    const Spot a = map.at({middle - half, line});
    canvas.box({a.x, a.y, map.pixels(field.goalDepth), map.pixels(field.goalWidth)},
               mark.kind == LandmarkKind::goalBlue ? inks::kBlueGoal : inks::kYellowGoal, 1.5);
  }
  for (const auto& line : field.lines)
    canvas.line({map.at(line.start), map.at(line.end)}, inks::kPaint, 1.4);
  canvas.ring(map.at({middle, 0.5 * field.length}), map.pixels(0.5 * field.circleDiameter),
              inks::kPaint, 1.4);
}

}  // namespace

void drawScore(Canvas& canvas, Spot corner, const match::MatchFacts& facts) {
  const Type name{15.0, {1.0, 1.0, 1.0}, true};
  const Type number{18.0, {1.0, 1.0, 1.0}, true};
  double x = cell(canvas, corner, match::nameOf(facts, TeamColour::red), {0.72, 0.13, 0.13}, name);
  x = cell(canvas, {x, corner.y}, match::scoreOf(facts), inks::kGround, number);
  x = cell(canvas, {x, corner.y}, match::nameOf(facts, TeamColour::blue), {0.15, 0.28, 0.72}, name);
  cell(canvas, {x + 6.0, corner.y}, match::clockOf(facts.seconds), inks::kGround.faded(0.85),
       {15.0, inks::kText, true});
}

void drawNumber(Canvas& canvas, Spot where, const Actor& actor, bool watched) {
  const Ink ground = actor.team == TeamColour::red ? Ink{0.72, 0.13, 0.13} : Ink{0.15, 0.28, 0.72};
  canvas.disc(where, 9.0, ground.faded(0.9));
  if (watched) canvas.ring(where, 10.0, {1.0, 1.0, 1.0}, 2.0);
  const Type type{11.5, {1.0, 1.0, 1.0}, true, Align::centre};
  canvas.text({where.x, where.y - 7.0}, std::to_string(actor.player), type);
}

void drawBanner(Canvas& canvas, const Frame& stage, const std::string& words) {
  if (words.empty()) return;
  const bool goal = words.compare(0, 4, "Goal") == 0 || words.compare(0, 8, "Own goal") == 0;
  const Type type{goal ? 26.0 : 17.0, {1.0, 1.0, 1.0}, true, Align::centre};
  const cv::Size2d size = canvas.measure(words, type);
  const double high = size.height + 18.0, wide = size.width + 52.0;
  const Spot middle{stage.x + 0.5 * stage.width, stage.y + stage.height - 22.0 - high};
  canvas.box({middle.x - 0.5 * wide, middle.y, wide, high}, inks::kGround.faded(0.86), 6.0);
  canvas.box({middle.x - 0.5 * wide, middle.y, 6.0, high}, inks::kBall, 2.0);
  canvas.text({middle.x, middle.y + 9.0}, words, type);
}

void drawMap(Canvas& canvas, const Frame& frame, const body::FieldDescription& field,
             const Tableau& tableau, const Actor* watched) {
  canvas.box(frame, inks::kCarpet, 8.0);
  const Map map(frame, field);
  canvas.cut(frame, 8.0);
  drawMapGround(canvas, map, field);
  for (const Actor& actor : tableau.actors) {
    const Spot nose = map.at(fieldFromRobot(actor.pose, Point2<Robot>{0.0, 9.0}));
    const Spot body = map.at(fieldFromRobot(actor.pose, Point2<Robot>{0.0, -9.0}));
    canvas.line({body, nose}, inks::of(actor.team), 5.0);
    drawNumber(canvas, body, actor, &actor == watched);
  }
  if (tableau.ballThere) canvas.disc(map.at(tableau.ball), 4.5, inks::kBall);
  canvas.uncut();
}

void drawCalls(Canvas& canvas, const Frame& frame, const std::string& ball,
               const std::vector<Call>& calls) {
  canvas.text({frame.x, frame.y}, ball, {17.0, inks::kText, true}, frame.width);
  double y = frame.y + 32.0;
  for (std::size_t i = 0; i < calls.size() && y < frame.y + frame.height - 18.0; ++i) {
    const Ink ink = i == 0 ? inks::kText : inks::kQuiet;
    canvas.text({frame.x, y}, match::clockOf(calls[i].seconds), {13.0, inks::kQuiet});
    const Type type{13.0, ink, false, Align::left, 2};
    y += canvas.text({frame.x + 58.0, y}, calls[i].words, type, frame.width - 58.0).height + 5.0;
  }
}

void drawReasons(Canvas& canvas, const Frame& frame, const match::Moment& moment) {
  const Command& command = moment.output.command;
  const std::string instead = match::insteadOf(moment.input.drive.present, command);
  double y = frame.y;
  if (!instead.empty()) {
    canvas.text({frame.x, y}, instead, {13.5, inks::kText, true, Align::left, 4}, frame.width);
    return;
  }
  for (std::size_t i = 0; i < command.trace.size() && y < frame.y + frame.height - 34.0; ++i) {
    const TraceStep& step = command.trace[i];
    const bool last = i + 1 == command.trace.size();
    const Ink ink = last ? inks::kBall : inks::kText;
    const std::string who =
        step.module.empty() ? match::wordFor(step.layer) : spoken(step.module.view());
    const double wide = canvas.text({frame.x, y}, who + "  ", {13.0, inks::kQuiet}).width;
    const std::string what = spoken(step.branch.view());
    y += canvas.text({frame.x + wide, y}, what, {13.0, ink, true}, frame.width - wide).height;
    const std::string reason = match::reasonOf(step);
    if (!reason.empty()) {
      const Type type{12.0, last ? inks::kText : inks::kQuiet, false, Align::left, 2};
      y += canvas.text({frame.x + 14.0, y}, reason, type, frame.width - 14.0).height;
    }
    y += 6.0;
  }
}

}  // namespace kelpie::broadcast

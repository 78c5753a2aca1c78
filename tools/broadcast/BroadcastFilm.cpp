// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/BroadcastFilm.h"

#include <fmt/core.h>

#include <algorithm>

#include "tools/broadcast/Captions.h"
#include "tools/broadcast/Overlay.h"
#include "tools/match/drawing/CameraDrawing.h"
#include "tools/match/drawing/Inks.h"

namespace kelpie::broadcast {
namespace {

using namespace picture;
namespace inks = match::inks;

constexpr Frame kStageFrame{0.0, 0.0, 896.0, 504.0};
constexpr double kPanel = 896.0 + 16.0;  // x of what the robot sees
constexpr double kPanelWide = 1280.0 - kPanel - 16.0;
constexpr Frame kCamera{kPanel, 40.0, kPanelWide, kPanelWide* kImageHeight / kImageWidth};
constexpr double kReasonsTop = kCamera.y + kCamera.height + 40.0;
constexpr Frame kReasons{kPanel, kReasonsTop, kPanelWide, 720.0 - kReasonsTop - 10.0};
constexpr Frame kMap{16.0, 520.0, 290.0, 184.0};
constexpr Frame kCalls{330.0, 524.0, 550.0, 184.0};
constexpr std::size_t kCallCount = 6;
constexpr double kOverBack = 0.27;  // m, of the numbers

const Actor* find(const Tableau& tableau, TeamColour team, int player) {
  for (const Actor& actor : tableau.actors)
    if (actor.team == team && actor.player == player) return &actor;
  return nullptr;
}

void drawNumbers(Canvas& canvas, const View& view, const Tableau& tableau, const Actor* watched) {
  canvas.cut(kStageFrame);
  const cv::Size size(static_cast<int>(kStageFrame.width), static_cast<int>(kStageFrame.height));
  for (const Actor& actor : tableau.actors) {
    const Point2<Field> back = fieldFromRobot(actor.pose, Point2<Robot>{0.0, -6.0});
    const auto where = project(view, {0.01 * back.x, 0.01 * back.y, kOverBack}, size);
    if (where) drawNumber(canvas, {where->x, where->y}, actor, &actor == watched);
  }
  canvas.uncut();
}

std::string heading(const match::MatchFacts& facts) {
  return fmt::format("{} {} sees", facts.team == TeamColour::red ? "Red" : "Blue", facts.player);
}

}  // namespace

Expected<BroadcastFilm> BroadcastFilm::create(const match::Match& match, Course course,
                                              double sharpness) {
  const auto fonts = Canvas::create({1, 1}, inks::kGround);
  if (!fonts) return Error{fonts.error()};
  auto stage = Stage::build(
      match.field(), course.players(),
      {static_cast<int>(kStageFrame.width), static_cast<int>(kStageFrame.height)}, sharpness);
  if (!stage) return Error{stage.error()};
  BroadcastFilm film(match, std::move(course), std::move(*stage));
  film.plan();
  return Expected<BroadcastFilm>(std::move(film));
}

BroadcastFilm::BroadcastFilm(const match::Match& match, Course course, Stage stage)
    : match_(&match),
      course_(std::move(course)),
      stage_(std::move(stage)),
      facts_(match::factsOf(match.notes(), match.team(), match.player())) {}

void BroadcastFilm::plan() {
  const std::vector<double> times = course_.frameTimes({match_->team(), match_->player()});
  for (std::size_t i = 0; i < times.size(); i += kEvery) times_.push_back(times[i]);
  views_ = followPlay(course_, match_->field(), times_, kStageFrame.width / kStageFrame.height);
}

Expected<cv::Mat> BroadcastFilm::frame(const match::Moment& moment) {
  while (next_ + 1 < views_.size() && moment.input.time.seconds() > times_[next_] + 1e-9) ++next_;
  return draw(moment, moment.input.time.seconds());
}

Expected<cv::Mat> BroadcastFilm::last(const match::Moment& moment) {
  double seconds = moment.input.time.seconds();
  for (const sim::MatchEvent& event : match_->events())
    if (event.kind == sim::EventKind::goal) seconds = std::max(seconds, event.time.seconds());
  return draw(moment, seconds);
}

Expected<cv::Mat> BroadcastFilm::draw(const match::Moment& moment, double seconds) {
  const Tableau tableau = course_.at(moment.input.time.seconds());
  const View view = views_.empty() ? View{} : views_[next_];
  stage_.put(tableau);
  const auto stage = stage_.shoot(view);
  if (!stage) return stage;
  match::add(moment, facts_);
  facts_.seconds = seconds;
  match::score(course_.events(), TimeUs{static_cast<std::int64_t>(1e6 * seconds + 0.5)}, facts_);
  auto canvas = Canvas::create(size(), inks::kGround);
  if (!canvas) return Error{canvas.error()};
  const Actor* const watched = find(tableau, facts_.team, facts_.player);
  canvas->paste(*stage, kStageFrame, false);
  drawNumbers(*canvas, view, tableau, watched);
  drawScore(*canvas, {18.0, 16.0}, facts_);
  drawBanner(*canvas, kStageFrame, bannerAt(course_.events(), seconds));
  drawMap(*canvas, kMap, match_->field(), tableau, watched);
  const Actor* const holder = course_.holderOf(tableau, seconds);
  drawCalls(*canvas, kCalls, ballWords(holder, tableau.ballThere),
            callsUntil(course_.events(), seconds, kCallCount));
  canvas->text({kPanel, 13.0}, heading(facts_), {15.0, inks::kText, true});
  match::drawCameraView(*canvas, kCamera, moment);
  canvas->text({kPanel, kReasonsTop - 26.0}, "and decides", {15.0, inks::kText, true});
  drawReasons(*canvas, kReasons, moment);
  return canvas->picture();
}

}  // namespace kelpie::broadcast
